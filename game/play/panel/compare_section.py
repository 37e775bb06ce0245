"""The panel's section of worlds side by side: what they are to differ in, and what is shown over them."""

from game.play.controls.comparing import FEWEST, RULE, SCHEDULE, SEED, P
from game.world.rules.rule import SCHEDULES
from game.world.sand import parameters

LABELS = {P: "p", SCHEDULE: "Order", SEED: "Seed", RULE: "Rule"}
SUBJECT_TIP = "The one thing in which the worlds differ: friction, the order of the blocks, luck, or the rule"
WHICH_TIP = "What each of the worlds is given"
COMPARE_TIP = "Runs this sand in all of them at once, by one clock; what you do to one is done to all"
OVER_TIP = (
    "Over each world: nothing, the cells in which it differs from the bright one (F7), or how likely sand is (F8)"
)
SAVE_TIP = "Saves a picture of each world as it is shown, and one table of what the plots have measured in all"


class CompareSection:
    """The choice of a comparison, or what can be done with the one that is on."""

    def __init__(self, comparing, rule_files, differences, density, commands):
        self._comparing, self._rule_files = comparing, rule_files
        self._differences, self._density, self._commands = differences, density, commands
        self._open = False  # the fold of what each world is given

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        ui.heading("Compare")
        if self._comparing.on:
            self._lay_out_comparison(ui)
        else:
            self._lay_out_choice(ui)

    def _lay_out_comparison(self, ui):
        if ui.button("Back to one world", key="Shift+H", name="Compare"):
            self._commands.sand.compare()
        now = 1 if self._differences.shown else 2 if self._density.shown else 0
        chosen = ui.segmented("Show", ("Sand", "Differs", "Density"), now, tip=OVER_TIP)
        if chosen != now:
            toggles = None, self._commands.view.toggle_differences, self._commands.view.toggle_density
            (toggles[chosen] or toggles[now])()
        if ui.button("Save pictures and CSV", key="Shift+L", tip=SAVE_TIP, name="Save comparison"):
            self._commands.files.save_measures()
        words = "Each keeps what its title says. Saving, replays and the forecast follow the bright one."
        ui.text(words, dim=True)

    def _lay_out_choice(self, ui):
        comparing = self._comparing
        subjects = comparing.subjects
        labels = [LABELS[each] for each in subjects]
        comparing.subject = subjects[
            ui.segmented("Differ in", labels, subjects.index(comparing.subject), tip=SUBJECT_TIP)
        ]
        numbers = range(FEWEST, comparing.most + 1)
        now = numbers.index(comparing.worlds)
        chosen = ui.segmented("Worlds", [str(each) for each in numbers], now, tip="How many worlds are compared")
        if chosen != now:
            comparing.number = numbers[chosen]
        if comparing.subject != SEED:
            self._open = ui.fold("Which", self._open, tip=WHICH_TIP)
            for number in range(comparing.worlds) if self._open else ():
                self._lay_out_world(ui, number)
        if ui.button("Compare", key="Shift+H", tip=COMPARE_TIP):
            self._commands.sand.compare()
        tip = "The share of many runs that have sand in each cell now, from the scene's start or the last act  (F8)"
        if ui.toggle("Density", self._density.shown, tip=tip) != self._density.shown:
            self._commands.view.toggle_density()

    def _lay_out_world(self, ui, number):
        """Show what one world is given."""
        comparing, name = self._comparing, f"World {number + 1}"
        if comparing.subject == P:
            tip, usual = f"The p of world {number + 1}", parameters.PAPER_P[number]
            p = comparing.p[number]
            comparing.p[number] = ui.slider(name, parameters.P, p, usual, parameters.PAPER_P, tip=tip)
        elif comparing.subject == SCHEDULE:
            names, now = list(SCHEDULES), comparing.schedules[number]
            labels = [each.capitalize() for each in names]
            tip = f"The order of the blocks in world {number + 1}"
            comparing.schedules[number] = names[ui.choice(name, labels, names.index(now), tip=tip)]
        else:
            labels, now = [*self._rule_files.labels], comparing.rules[number]
            chosen = ui.choice(name, labels, labels.index(now), tip=f"The rule of world {number + 1}")
            if labels[chosen] != now:
                comparing.choose_rule(number, labels[chosen])
