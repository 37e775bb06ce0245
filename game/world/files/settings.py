"""Settings: what is remembered from one start to the next, in one readable file in the user's config folder.

To add one, add a row to ROWS: a Knob, Switch, Choice or Names with a name, a default and a meaning. Then

    toy.settings["theme"]                # the value, checked
    toy.settings["theme"] = "night"      # raises ValueError for one that is not allowed; saved a second later
    toy.settings.override("theme", ...)  # for a flag of the command line: holds for this run, is not saved

and nothing else is to be done: the file, its comments, what is said of a bad line, and keeping it are the same for all.
"""

import time
from dataclasses import replace

from game.world.files.atomic import FileError, load, lock, save, trouble
from game.world.files.paths import config_file
from game.world.files.setting_types import Choice, Names, Switch
from game.world.files.settings_format import Kept, read_lines, written
from game.world.sand import parameters
from game.world.sand.parameters import Knob

ROWS = (
    replace(parameters.UI_SCALE, name="ui_scale"),
    Choice("theme", "night", ("day", "night", "high-contrast"), "colours of the window and the sand"),
    Switch("smooth_streams", True, "draw falling sand as the mean of what happens within a frame"),
    Switch("reduced_motion", False, "leave out turns, glows and fades"),
    Switch("sound", False, "the hiss of flowing sand"),
    Choice("recording", "gif", ("gif", "webp", "mp4"), "format of recordings; mp4 needs ffmpeg"),
    Switch("chime", True, "a bell when the timer ends"),
    Knob("volume", 0.5, 0.0, 1.0, "", "how loud the sand is", ends=("soft", "loud")),
    Names("stage_lines", "what stands in large letters on the stage", ("iteration", "p", "partition", "clock")),
    Names("hints_seen", "hints that were shown, and are not shown again"),
    Knob("window_width", 0, 0, 16384, "pixels", "width of the window; 0 suits scene and screen", whole=True),
    Knob("window_height", 0, 0, 16384, "pixels", "height of the window; 0 suits scene and screen", whole=True),
    parameters.BRUSH,
    parameters.MEMORY,
)
LARGEST_FILE = 2**20  # bytes
MOST_NAMED = 5  # bad lines that are named beside the first
LOCK_TRIES, LOCK_S = 50, 0.02  # how often and how long a file that another window writes is waited for


class Settings:
    """The values by name. Without a path they are the defaults, and are kept nowhere."""

    def __init__(self, path=None, rows=ROWS):
        self.path = path
        self.problem = None  # what is wrong with the file, as one line, or None
        self.rows = {row.name: row for row in rows}
        self._values = {}  # those that are not left at their defaults
        self._overrides = {}
        self._unsaved = {}
        self._owed = {}  # what could not be saved: it goes with what is saved next
        if path is not None:
            self._read()

    @classmethod
    def of_user(cls):
        """Return the settings in the user's config folder."""
        return cls(config_file())

    def __getitem__(self, name):
        return self._overrides.get(name, self._values.get(name, self.rows[name].default))

    def __setitem__(self, name, value):
        value = self.rows[name].check(value)
        if value != self[name]:
            self._overrides.pop(name, None)
            self._values[name] = self._unsaved[name] = value

    def has(self, name):
        """Return whether a value was set, now or once, rather than left at its default."""
        return name in self._overrides or name in self._values

    def override(self, name, value):
        """Let a value hold for this run: until it is changed, and without being saved."""
        self._overrides[name] = self.rows[name].check(value)

    @property
    def unsaved(self):
        """Whether anything was changed and is not on its way to the file."""
        return bool(self._unsaved) and self.path is not None

    @property
    def owed(self):
        """Whether anything that was changed could not be saved so far."""
        return bool(self._owed) and self.path is not None

    def take_unsaved(self):
        """Return a function that saves what was changed, in any thread; it raises FileError if that is not possible."""
        changed = self._owed | self._unsaved
        self._owed, self._unsaved = {}, {}

        def save():
            try:
                self._save(changed)
            except FileError:
                self._owed = changed
                raise

        return save

    def _read(self):
        try:
            kept = self._kept()
        except FileError as error:
            self.problem = f"{error}; the default settings are used"
            return
        self._values = kept.values
        if kept.problems:
            first, *others = kept.problems
            named = [each.partition(":")[0] for each in others[:MOST_NAMED]]  # "line 7"
            more = ["more"] if others[MOST_NAMED:] else []
            also = f"; the same with {', '.join(named + more)}" if others else ""
            self.problem = f"{self.path}: {first}; the default is used{also}"

    def _kept(self):
        """Return what the file holds now; raise FileError if it cannot be read."""
        try:
            self.path.stat()
        except (FileNotFoundError, NotADirectoryError):
            return Kept()
        except OSError as error:
            raise trouble(self.path, "cannot read", error) from None
        return read_lines(load(self.path, LARGEST_FILE), self.rows)

    def _save(self, changed):
        """Put what was changed into the file, in which another window may have changed something else meanwhile."""
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with open(self.path.with_name(f".{self.path.name}.lock"), "ab") as guard:
                _wait_for(guard)
                kept = self._kept()
                kept.values.update(changed)
                save(self.path, written(kept, self.rows.values()))
        except OSError as error:
            raise trouble(self.path, "cannot save", error) from None


def _wait_for(guard):
    """Wait until no other window holds the file, for a second at most: each save is atomic in any case."""
    for _ in range(LOCK_TRIES):
        if lock(guard.fileno()):
            return
        time.sleep(LOCK_S)
