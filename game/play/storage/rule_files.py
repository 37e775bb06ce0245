"""Rule files in the window: choosing one, copying one, and reading one anew when it is changed on the disk."""

import os
from functools import partial
from pathlib import Path

from game.world.files.atomic import FileError
from game.world.files.checked_table import read_text
from game.world.files.paths import asset, folder_of
from game.world.rules.definition import load_definition, read_definition, rule_names, rule_title
from game.world.rules.own_rules import copy_rule, own_rules
from game.world.rules.rule import Rule
from game.world.rules.rule_text import LARGEST_FILE, RuleError

POLL_S = 0.25  # from one look at the files to the next; a change is read once it is the same for two looks


class RuleFiles:
    """The shipped rules and the player's own; the file of the rule that is played is watched."""

    def __init__(self, sessions, changes, background, notices):
        self._sessions, self._changes = sessions, changes
        self._background, self._notices = background, notices
        self._own, self._folder = {}, None  # the player's rules, and the state of their folder when it was read
        self._next_s = 0.0
        self._watched, self._known, self._last = (), None, None  # files; their states as read, and at the last look

    @property
    def labels(self):
        """{label: name or path} of the rules to choose from, that of the present one last if it is none of them."""
        found = {rule_title(name): name for name in rule_names()}
        found |= {f"Yours: {name}": path for name, path in self._own.items()}
        told = self._sessions.now.rule.definition
        return found if self.label in found else {**found, self.label: told.paths[0] if told.paths else None}

    @property
    def label(self):
        """The label of the rule that is played."""
        told = self._sessions.now.rule.definition
        if told.paths[:1] == (asset("rules", f"{told.name}.toml"),):
            return rule_title(told.name)
        return f"Yours: {told.name}" if told.name in self._own else told.name

    def choose(self, label):
        """Play by another of the rules."""
        self.play(self.labels[label])

    def play(self, name_or_path, said=""):
        """Play by a shipped rule or by that in a file; said: in place of what the rule says of itself."""

        def tell(changed):
            self._tell(said or (changed and self._sessions.now.rule.definition.notice))

        self._changes.make(lambda: Rule(definition=load_definition(name_or_path)), then=tell)

    def reset(self):
        """Give the rule all values that its file says."""
        self._changes.to(Rule(definition=self._sessions.now.rule.definition.plain))

    @property
    def is_turned(self):
        """Whether the rule has other values than its file says."""
        rule = self._sessions.now.rule
        return rule != Rule(definition=rule.definition.plain)

    def copy(self):
        """Copy the rule, as it is turned, to the player's folder, and play by that file from now on."""
        self._background.do(partial(copy_rule, self._sessions.now.rule), self._take_copy, writes=True)

    def update(self, now_s):
        """Look at the files now and then; read the rule anew once they have changed."""
        if now_s < self._next_s:
            return
        self._next_s = now_s + POLL_S
        folder = _state(folder_of("rules"))
        if folder != self._folder:
            self._own, self._folder = own_rules(), folder
        told = self._sessions.now.rule.definition
        files = told.paths or ((self._own[told.name],) if told.name in self._own else ())
        states = tuple(map(_state, files))
        if files != self._watched:
            self._watched, self._last = files, states
            self._known = states if _say(told.paths, told.texts) else None
        elif states != self._known and states == self._last and all(states):
            self._known = states
            self._read_anew(files[0])
        self._last = states

    def _read_anew(self, path):
        rule = self._sessions.now.rule
        words = f"{Path(path).name} was read anew. Ctrl+Z takes back what it changed."
        self._changes.make(partial(_read_anew, path, rule), then=lambda changed: changed and self._notices.say(words))

    def _take_copy(self, path):
        self._own = own_rules()
        self.play(path, f"Copied to {path}. What you save there plays at once.")

    def _tell(self, words):
        if words:
            self._notices.say(words)


def _state(path):
    """Return what tells a file or a folder from what it was before, or None where there is none."""
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _say(paths, texts):
    """Return whether files, if there are any, say what was read there: one may have been changed since."""
    try:
        return all(read_text(path, LARGEST_FILE) == text for path, text in zip(paths, texts, strict=False))
    except FileError:
        return False


def _read_anew(path, rule):
    """Return the rule in a file as it is now, with the values that were turned in the rule before."""
    try:
        definition = read_definition(path)
    except FileError as error:
        raise FileError(f"{error}; the rule stays as it was") from None
    before = rule.definition
    usual = {each.name: each.default for each in before.chances}
    names = {*(each.name for each in definition.chances), *definition.own_numbers}
    turned = {name: value for name, value in rule.chances.items() if value != usual[name] and name in names}
    schedule = rule.schedule if rule.schedule != before.schedule else definition.schedule
    made = Rule(definition=definition, schedule=schedule)
    try:
        return made.with_chances(**turned)
    except RuleError:
        return made
