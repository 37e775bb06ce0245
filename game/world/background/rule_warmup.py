"""Makes rules ready beside the frames: what must be compiled before one can be played without a pause."""

from game.core.compiler.beside import giving_way
from game.core.compiler.plan import kinds_of
from game.core.compiler.rule_pass import make_beside
from game.world.background.kernel_warmup import steps
from game.world.sessions.action import Load, SetRule

MOST = 16  # rules that are known to be ready; the passes in memory are some more


class ReadyRules:
    """Which rules can be played at once."""

    def __init__(self):
        self._known = {}  # what is compiled: {(definition, kinds of its thresholds): None}, the oldest first

    def has(self, rule, played):
        """Return whether a rule is ready where another is being played. It never takes long."""
        if rule.codes.is_sand and played.codes.is_sand:
            return True  # that is compiled in a blink
        if rule.definition not in {played.definition, *(definition for definition, _ in self._known)}:
            return False
        kinds = _kinds(rule)
        return kinds == _kinds(played) or kinds in self._known

    def note(self, rule):
        """Note that a rule is ready."""
        self._known[_kinds(rule)] = None
        while len(self._known) > MOST:
            del self._known[next(iter(self._known))]


def _kinds(rule):
    return rule.definition, tuple(sorted(kinds_of(rule.table, rule.values).items()))


def make_ready(rule, walls, cell, coloured, fixtures):
    """Compile all that showing a scene with a rule needs, as `kernel_warmup.steps` does; frames go on beside it."""
    make_beside(rule.table, rule.values)
    with giving_way():
        for _, act in steps(rule, walls, cell, coloured and rule.codes.is_sand, fixtures):
            act()


def make_recording_ready(recording):
    """Compile all rules that a Recording comes by, as `make_ready` does."""
    scenes = [recording.scene, *(each.what.scene for each in recording.entries if isinstance(each.what, Load))]
    rules = [each.rule for each in scenes] + [
        each.what.rule for each in recording.entries if isinstance(each.what, SetRule)
    ]
    for rule in {_kinds(each): each for each in rules}.values():
        if not rule.codes.is_sand:
            make_ready(rule, recording.scene.made_of, recording.scene.cell, False, recording.scene.fixtures)
