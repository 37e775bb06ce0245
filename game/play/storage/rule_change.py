"""Changes of the rule: each is an act, done as soon as the rule is compiled; the sand goes on meanwhile."""

from contextlib import suppress
from functools import partial
from typing import NamedTuple

from game.world.background.rule_warmup import ReadyRules, make_ready
from game.world.rules.rule_text import RuleError
from game.world.sessions.action import SetRule

KEPT = "That is what the worlds differ in: each keeps what its title says."


class WantedRule(NamedTuple):
    """A rule that is on its way."""

    session: object  # that it is for
    scene: object
    made: object  # a function that returns the rule
    values: dict  # {name: value} of what is turned in the rule that is played, if that is all
    then: object  # called with whether the act changed anything, or None


class RuleChange:
    """The rule that is wanted, on its way to being played. What is wanted later takes the place of it."""

    def __init__(self, sessions, background, notices):
        self._sessions, self._background, self._notices = sessions, background, notices
        self._ready = ReadyRules()
        self._wanted = self._rule = None  # the WantedRule, and the rule itself once it can be played
        self._working = False  # a rule is being compiled
        self._joins = False  # the act to come is one with the last

    @property
    def busy(self):
        """Whether a rule is on its way."""
        return self._wanted is not None

    @property
    def words(self):
        """What the status line says of it."""
        return "Compiling the rule …" if self.busy else ""

    def value(self, name):
        """Return the probability of a chance or an own number, as it was turned last."""
        turned = self._wanted.values if self._wanted else {}
        return turned[name] if name in turned else self._sessions.now.rule.number(name)

    def turn(self, name, value, join=False):
        """Give a chance or an own number of the rule another value; join: one act with the turn before."""
        played = self._sessions.now.rule
        values = {**(self._wanted.values if self._wanted else {}), name: value}
        if set(values) <= set(played.chances):
            with suppress(RuleError):  # outcomes of one event that are more than certain together: as it was
                self.to(played.with_chances(**values), join, values)
        else:
            self.make(partial(played.with_chances, **values), join, values)

    def to(self, rule, join=False, values=None, then=None):
        """Play by a rule: at once, if it is ready."""
        if self._ready.has(rule, self._sessions.now.rule):
            self._wanted, self._joins = None, join and self._joins
            self._do(rule, then)
        else:
            self.make(lambda: rule, join, values, then)

    def make(self, made, join=False, values=None, then=None):
        """Play by the rule that made() returns, which may take long; the window tells of what it raises on a file."""
        session = self._sessions.now
        self._wanted, self._rule = WantedRule(session, session.scene, made, values or {}, then), None
        self._joins = join and self._joins
        self._begin()

    def update(self, now_s):
        """Do what is ready, once the sand is computed."""
        wanted, session = self._wanted, self._sessions.now
        if wanted and (wanted.session, wanted.scene) != (session, session.scene):
            self._wanted = None
        elif wanted and self._rule and session.arrived:
            self._wanted = None
            self._do(self._rule, wanted.then)

    def _begin(self):
        """Make ready what is wanted, one rule at a time."""
        if self._working or not self._wanted:
            return
        self._working = True
        made, world, scene = self._wanted.made, self._sessions.now.world, self._sessions.now.scene
        work = partial(_made_ready, made, scene.made_of, scene.cell, world.coloured, world.fixtures)
        self._background.do(work, partial(self._take, made), partial(self._end, made))

    def _take(self, made, rule):
        self._ready.note(rule)
        if self._wanted and self._wanted.made is made:
            self._working, self._rule = False, rule
            self.update(0.0)
        else:
            self._end(made)

    def _end(self, made):
        """Go on with what has been wanted meanwhile."""
        self._working = False
        if self._wanted and self._wanted.made is made:
            self._wanted = None
        self._begin()

    def _do(self, rule, then):
        changed, session = self._sessions.do(SetRule(rule), join=self._joins), self._sessions.now
        if not changed and len(session.sessions) > 1 and rule != session.rule:
            self._notices.say(KEPT)
        self._joins = True
        if then:
            then(changed)


def _made_ready(made, *how):
    rule = made()
    make_ready(rule, *how)
    return rule
