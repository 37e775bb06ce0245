"""Comparing: worlds side by side that differ in one thing, which the player picks, with a value for each."""

from functools import partial

from game.world.background.rule_warmup import make_ready
from game.world.rules.definition import load_definition
from game.world.rules.rule import SCHEDULES, Rule
from game.world.sand import parameters
from game.world.sand.material_codes import SAND_NAME
from game.world.sessions.comparison import (
    MOST,
    Comparison,
    by_friction,
    by_rule,
    by_schedule,
    by_seed,
    present,
)

P, SCHEDULE, SEED, RULE = "p", "schedule", "seed", "rule"
FEWEST = 2  # worlds
TOO_FEW = "All worlds would be alike: give them other values."


class Comparing:
    """What the next comparison will be of, and the way there and back."""

    def __init__(self, sessions, journals, rule_files, background, notices, own_speed):
        """`own_speed()` returns the speed of the session's clock, or what it has to get back when a timer ends."""
        self._sessions, self._journals, self._rule_files = sessions, journals, rule_files
        self._background, self._notices, self._own_speed = background, notices, own_speed
        self._subject = P
        self.number = MOST  # worlds
        self.p = list(parameters.PAPER_P)
        self.schedules = [*SCHEDULES][:MOST]
        self._labels = []  # of rules, as far as they were chosen

    @property
    def on(self):
        """Whether worlds are compared now."""
        return isinstance(self._sessions.now, Comparison)

    @property
    def subjects(self):
        """What the worlds can differ in."""
        return (P, SCHEDULE, SEED, RULE) if self._sessions.now.rule.leans else (SCHEDULE, SEED, RULE)

    @property
    def subject(self):
        """What they will differ in."""
        return self._subject if self._subject in self.subjects else SEED

    @subject.setter
    def subject(self, subject):
        self._subject = subject

    @property
    def most(self):
        """How many worlds there can be."""
        return len(SCHEDULES) if self.subject == SCHEDULE else MOST

    @property
    def worlds(self):
        """How many worlds there will be, if their values differ."""
        return min(self.number, self.most)

    @property
    def rules(self):
        """The labels of the rules of the worlds: the one that is played, and then others."""
        known = self._rule_files.labels
        usual = [self._rule_files.label, *(each for each in known if each != self._rule_files.label)]
        chosen = [each if each in known else usual[number] for number, each in enumerate(self._labels)]
        return [*chosen, *usual[len(chosen) :]][:MOST]

    def choose_rule(self, number, label):
        """Give a world another rule."""
        self._labels = self.rules
        self._labels[number] = label

    def toggle(self):
        """Compare, from the sand as it is; again, go back to it as it was."""
        if self.on:
            self._sessions.leave()
        elif self._sessions.ready():
            self._begin()

    def _begin(self):
        number = self.worlds
        if self.subject == RULE:
            self._compile(self.rules[:number])
        elif self.subject == P:
            self._open(partial(by_friction, values=self.p[:number]))
        elif self.subject == SCHEDULE:
            self._open(partial(by_schedule, schedules=self.schedules[:number]))
        else:
            self._open(partial(by_seed, number=number))

    def _compile(self, labels):
        """Open a comparison of rules once they are compiled, beside the frames."""
        session, own, found = self._sessions.now, self._rule_files.label, self._rule_files.labels
        scene, fixtures, coloured = session.scene, session.world.fixtures, session.world.coloured
        played = session.rule

        def work():
            rules = {each: played if each == own else Rule(definition=load_definition(found[each])) for each in labels}
            for rule in rules.values():
                make_ready(rule, scene.made_of, scene.cell, coloured, fixtures)
            return rules

        def take(rules):
            if self._sessions.now is session and self._sessions.ready():
                here = _held(session.world)
                strange = [title for title, rule in rules.items() if here and here.isdisjoint(rule.codes.names)]
                kept = {title: rule for title, rule in rules.items() if title not in strange}
                if len(kept) >= FEWEST or not strange:
                    self._open(partial(by_rule, rules=kept))
                if strange:
                    self._notices.say(f"Left out, for it has nothing of what is here: {', '.join(strange)}.")

        self._notices.say("Compiling the rules …")
        self._background.do(work, take)

    def _open(self, variants):
        now = self._sessions.now
        if len(variants(now.seed)) < FEWEST:
            self._notices.say(TOO_FEW)
            return
        session = Comparison(present(now), now.seed, subject=variants)
        session.paused, session.clock.speed = now.paused, self._own_speed()
        self._journals.begin(session, [])
        self._sessions.open(session, keep=True)
        titles = ", ".join(each.title for each in session.variants.values())
        words = f"The same sand with {titles}. Shift+H or Esc goes back."
        self._notices.say(words, holds=lambda: self._sessions.now is session)


def _held(world):
    """Return the names of the materials that fill any cell of a world."""
    if world.codes.is_sand:
        return {SAND_NAME} if world.grains else set()
    return {world.codes.names[code] for code, number in enumerate(world.amounts) if number}
