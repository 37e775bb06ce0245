"""The panel's section of friction: how sand moves, from p to all seven probabilities, or the chances of any rule."""

from contextlib import suppress
from dataclasses import replace

from game.world.rules.rule import PROBABILITIES, SCHEDULES, Rule
from game.world.sand import parameters
from game.world.sessions.action import SetRule

PAPER_P = (0.25, 0.5, 0.75, 1.0)  # the four values of the paper

BLOCKS = {  # what each probability decides: corners a b c d before and after
    "topple_left": (".o.#", "..o#"),
    "topple_right": ("o.#.", "..#o"),
    "fall_pair": ("oo..", "..oo"),
    "fall_low_left": ("o..#", "..o#"),
    "fall_low_right": (".o#.", "..#o"),
    "fall_full_left": ("o#.#", ".#o#"),
    "fall_full_right": ("#o#.", "#.#o"),
}
SCHEDULE_TIP = (
    "The order in which the partitions into blocks take turns. Margolus: two partitions; piles grow on one side first. "
    "Paper: four; grains alternate sides. Balanced: the same four in another order; grains fall evenly, twice as fast."
)
LEAN_TIP = "Which side grains favour, and the order in which blocks take turns"
MOST_OPEN = 4  # chances that are always in sight
CHANCES_TIP = "How likely what the materials do is, event by event"
TIP = "How likely it is, in each block of 2×2 cells where it can happen."
SEVEN_TIP = "How likely each event in a block of 2×2 cells is"


class FrictionSection:
    """The sliders of a session's rule; a drag of one is one act."""

    def __init__(self, sessions):
        self._sessions = sessions
        self._all_open = self._lean_open = False  # the folds of all probabilities, and of bias and schedule
        self._turning = False  # a slider is being dragged, and what it sets is one act
        self._rule = None  # the rule that _p and _bias stand for
        self._p = self._bias = 0.0

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        rule, usual = self._sessions.now.rule, self._sessions.now.scene.rule
        changed = self._of_sand(ui, rule, usual) if rule.codes.is_sand else self._of_any(ui, rule, usual)
        held = ui.focus.held is not None
        if changed is not rule:
            self._sessions.do(SetRule(changed), join=self._turning)
        self._turning = held and (self._turning or changed is not rule)

    def _of_any(self, ui, rule, usual):
        """Show the chances of a rule; return it as it is to be."""
        ui.heading(rule.definition.title)
        changed, chances = rule, rule.definition.chances
        if len(chances) > MOST_OPEN:
            self._all_open = ui.fold(f"All {len(chances)} chances", self._all_open, tip=CHANCES_TIP)
        for each in chances if self._all_open or len(chances) <= MOST_OPEN else ():
            default, now = usual.chances.get(each.name, each.default), rule.chances[each.name]
            words = each.meaning.capitalize()
            value = ui.slider(words, each, now, default=default, tip=f"{words}. {TIP}")
            if value != now:
                with suppress(ValueError):  # outcomes of one event that are more than certain together: as it was
                    changed = changed.with_chances(**{each.name: value})
        self._lean_open = ui.fold("Schedule", self._lean_open, tip=SCHEDULE_TIP)
        schedule = _choose_schedule(ui, rule) if self._lean_open else rule.schedule
        return changed.with_schedule(schedule) if schedule != rule.schedule else changed

    def _of_sand(self, ui, rule, usual):
        """Show p and what can be folded away; return the rule as it is to be."""
        if rule is not self._rule:
            self._rule, self._p, self._bias = rule, rule.p, rule.bias
        ui.heading("Friction")
        tip = "How readily grains topple. A lower p is more friction: piles are steeper."
        p = ui.slider("p", parameters.P, self._p, default=usual.p, marks=PAPER_P, tip=tip)
        bias, schedule = self._bias, rule.schedule
        self._lean_open = ui.fold("Bias and schedule", self._lean_open, tip=LEAN_TIP)
        if self._lean_open:
            bias, schedule = self._lean(ui, rule, usual)
        return self._seven(ui, self._changed(rule, p, bias, schedule), usual)

    def _lean(self, ui, rule, usual):
        """Show bias and schedule; return them as they are to be."""
        tip = "Makes grains favour the left side (below 0) or the right side (above 0)."
        bias = ui.slider("Bias", parameters.BIAS, self._bias, default=usual.bias, marks=(0.0,), tip=tip)
        return bias, _choose_schedule(ui, rule)

    def _changed(self, rule, p, bias, schedule):
        """Return the rule with what was set, or itself."""
        changed = rule
        if (p, bias) != (self._p, self._bias):
            topples = Rule.with_p(p, bias=bias)
            changed = replace(rule, topple_left=topples.topple_left, topple_right=topples.topple_right)
            self._p, self._bias, self._rule = p, bias, changed
        if schedule != rule.schedule:
            changed = self._rule = replace(changed, schedule=schedule)
        return changed

    def _seven(self, ui, rule, usual):
        self._all_open = ui.fold("All seven probabilities", self._all_open, tip=SEVEN_TIP)
        if not self._all_open:
            return rule
        for each in PROBABILITIES:
            before, after = BLOCKS[each.name]
            words = each.name.replace("_", " ").capitalize()
            value = getattr(rule, each.name)
            tip = f"How often {each.meaning}."
            turned = ui.slider_with_picture(
                words, each, value, before, after, default=getattr(usual, each.name), tip=tip
            )
            if turned != value:
                rule = replace(rule, **{each.name: turned})
        return rule


def _choose_schedule(ui, rule):
    """Show the schedules, and return the one that is to be."""
    names = list(SCHEDULES)
    now = names.index(rule.schedule)
    return names[ui.choice("Schedule", [name.capitalize() for name in names], now, tip=SCHEDULE_TIP)]
