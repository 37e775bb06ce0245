"""The panel's section of the rule: which one is played, and all that can be turned in it."""

from game.play.ui.slider_scale import SliderScale
from game.play.view.chance_sliders import ChanceSliders
from game.world.rules.dials import dials_of
from game.world.rules.rule import PROBABILITIES, SAND, SCHEDULES, Rule
from game.world.sand import parameters

SCHEDULE_TIP = (
    "The order in which the partitions into blocks take turns. Margolus: two partitions; piles grow on one side first. "
    "Paper: four; grains alternate sides. Balanced: the same four in another order; grains fall evenly, twice as fast."
)
RULE_TIP = "How materials move and change each other; what is here stays, as far as the other rule has it"
LEAN_TIP = "Which side grains favour, in which order blocks take turns, and the file of the rule"
ALL_TIP = "How likely what each material does is, with pictures; the schedule, and the file of the rule"
SEVEN_TIP = "How likely each event in a block of 2×2 cells is"


class RulesSection:
    """The rules, and the sliders of a session's rule."""

    def __init__(self, sessions, changes, rule_files, brush):
        self._sessions, self._changes, self._files, self._brush = sessions, changes, rule_files, brush
        self._all_open = self._lean_open = False  # the folds of all that can be turned, and of bias, schedule and file
        self._open = {}  # {material: whether its fold is open}, where the player has chosen
        self._sliders = ChanceSliders(sessions, changes)
        self._rule = None  # the rule of sand that _p and _bias stand for
        self._p = self._bias = 0.0

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        rule = self._sessions.now.rule
        self._sliders.begin()
        self._choose_rule(ui)
        if rule.is_sand:
            self._of_sand(ui, rule, self._sessions.now.scene.rule)
        else:
            self._of_any(ui, rule)
        self._sliders.end(ui)

    def _choose_rule(self, ui):
        ui.skip(ui.theme.px(2))
        labels = [*self._files.labels]
        now = labels.index(self._files.label)
        chosen = ui.choice("Rule", labels, now, tip=RULE_TIP)
        if chosen != now:
            self._files.choose(labels[chosen])

    def _of_any(self, ui, rule):
        """Show what can be turned in a rule, material by material, its schedule, and what to do with its file."""
        self._all_open = ui.fold("All of this rule", self._all_open, tip=ALL_TIP)
        if self._all_open:
            self._show_all(ui, rule, dials_of(rule.definition.plain))
            self._play(ui, _choose_schedule(ui, rule))
            self._show_file(ui)

    def _show_all(self, ui, rule, dials):
        """Show the dials of each material in a fold of its own; that of the brush's material is open."""
        names, told = rule.codes.names, rule.codes.told
        for code, of_one in dials.items():
            is_open = self._open.get(names[code], told[code] == self._brush.material)
            label = f"{names[code].capitalize()}: {len(of_one)}"
            unfolded = ui.fold(label, is_open, tip=f"What can be turned of {names[code]}", name=f"Of {names[code]}")
            if unfolded != is_open:
                self._open[names[code]] = unfolded
            for each in of_one if unfolded else ():
                self._sliders.show(ui, each)

    def _show_file(self, ui):
        """Show what is to be done with the rule's file."""
        tip = "Gives all numbers of this rule the values that its file says"
        if ui.button("Reset to the file's", tip=tip, name="Reset rule", enabled=self._files.is_turned):
            self._files.reset()
        tip = "Writes this rule, as it is turned, to a file of yours; what you change in it plays at once"
        if ui.button("Copy to my rules", tip=tip, name="Copy rule"):
            self._files.copy()

    def _play(self, ui, rule):
        """Play by a rule, if it is another."""
        if rule is not self._sessions.now.rule:
            self._changes.to(rule, join=self._sliders.turning)
            self._sliders.note_turn()

    # --- the paper's sand ---

    def _of_sand(self, ui, rule, usual):
        """Show p, and what can be folded away."""
        if rule is not self._rule:
            self._rule, self._p, self._bias = rule, rule.p, rule.bias
        usual = usual if usual.is_sand else Rule()
        tip = "How readily grains topple. A lower p is more friction: piles are steeper."
        p = ui.slider("Friction", parameters.P, self._p, usual.p, parameters.PAPER_P, tip=tip, name="p", spell=_spell_p)
        self._play(ui, self._leant(rule, p, self._bias))
        self._lean_open = ui.fold("Bias, schedule and file", self._lean_open, tip=LEAN_TIP)
        if self._lean_open:
            self._lean(ui, usual)
            self._show_file(ui)
        self._all_open = ui.fold("All seven probabilities", self._all_open, tip=SEVEN_TIP)
        dials = [each for of_one in dials_of(SAND).values() for each in of_one]
        for knob in PROBABILITIES if self._all_open else ():
            dial = next(each for each in dials if each.knob is knob)
            self._sliders.show(ui, dial, knob.name.replace("_", " ").capitalize())

    def _lean(self, ui, usual):
        """Show bias and schedule."""
        rule = self._sessions.now.rule
        tip = "Makes grains favour the left side (below 0) or the right side (above 0)."
        bias = ui.slider("Bias", parameters.BIAS, self._bias, default=usual.bias, marks=(0.0,), tip=tip)
        rule = self._leant(rule, self._p, bias)
        self._play(ui, _choose_schedule(ui, rule))

    def _leant(self, rule, p, bias):
        """Return the rule with p and bias, or itself."""
        if (p, bias) == (self._p, self._bias):
            return rule
        self._p, self._bias, self._rule = p, bias, rule.toppling(p, bias)
        return self._rule


def _spell_p(p):
    return f"p = {SliderScale(parameters.P).spell(p)}"


def _choose_schedule(ui, rule):
    """Show the schedules, and return the rule with the one that is to be."""
    names = list(SCHEDULES)
    now = names.index(rule.schedule)
    chosen = ui.choice("Schedule", [name.capitalize() for name in names], now, tip=SCHEDULE_TIP)
    return rule if chosen == now else rule.with_schedule(names[chosen])
