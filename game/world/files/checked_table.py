"""A table of a file, read key by key. Each error is one line: what was found, what is wanted, where."""

import difflib
import math
import re
import tomllib
import unicodedata

from game.world.files.atomic import FileError, printable
from game.world.files.toml_text import parse_toml

LARGEST_FILE = 32 * 2**20  # bytes: twice what drawing a 4K lattice cell by cell takes
LONGEST_LINE = 200  # characters of a title or notice


class TableError(FileError):
    """What is wrong with a table, as one line: FILE: KEY: found X, wanted Y."""

    def __init__(self, file, key, found, wanted):
        super().__init__(f"{file}: {key}: found {found}, wanted {wanted}")
        self.told = key, found, wanted


def as_line(text):
    """Return text as `CheckedTable.line` takes it: a space for a sign that cannot be shown, and no more than fits."""
    return printable(text)[:LONGEST_LINE]


class CheckedTable:
    """The keys and values of one table; `where` leads to it in messages, such as 'rule.' or 'shape 2 (line).'."""

    def __init__(self, file, values, where=""):
        self.file, self.values, self.where = file, values, where

    def __contains__(self, key):
        return key in self.values

    def error(self, key, found, wanted):
        """Return the TableError that says what is wrong at `key`."""
        return TableError(self.file, f"{self.where}{key}", found, wanted)

    def allow(self, keys):
        """Raise TableError for the first key that is not one of `keys`."""
        for key in self.values:
            if key not in keys:
                near = difflib.get_close_matches(key[:40], keys, 1, 0.5)
                wanted = near[0] if near else f"one of {', '.join(keys)}"
                raise self.error(key[:40], "an unknown key", wanted)

    def number(self, key, knob, default=None):
        """Return the number at `key`, in the range of `knob`; without a default the key must be there."""
        if key not in self.values and default is not None:
            return default
        value = self._value(key, knob.wanted)
        try:
            return knob.check(value)
        except (ValueError, OverflowError):
            raise self.error(key, shown(value), knob.wanted) from None

    def line(self, key, default):
        """Return the text at `key`, one line that can be shown."""
        wanted = f"one line of text, at most {LONGEST_LINE} characters"
        value = self.values[key] if key in self.values else as_line(default)
        if not isinstance(value, str) or not value.isprintable() or len(value) > LONGEST_LINE:
            raise self.error(key, _hidden_in(value) + shown(value), wanted)
        return value

    def choice(self, key, options, default=None):
        """Return the text at `key`, one of `options`; without a default the key must be there."""
        wanted = f"one of {', '.join(options)}"
        value = self.values.get(key, default) if default else self._value(key, wanted)
        if not isinstance(value, str) or value not in options:
            raise self.error(key, shown(value), wanted)
        return value

    def points(self, key, knob, fewest, most=1000):
        """Return the list of (x, y) at `key`, each number in the range of `knob`."""
        wanted = f"{fewest} to {most} points [x, y], numbers {knob.wanted}"
        value = self._value(key, wanted)
        if not isinstance(value, list) or not fewest <= len(value) <= most:
            raise self.error(key, shown(value), wanted)
        for point in value:
            if not isinstance(point, list) or len(point) != 2 or not all(_fits(number, knob) for number in point):
                raise self.error(key, shown(point), wanted)
        return [(float(x), float(y)) for x, y in value]

    def pair(self, key, knob, default):
        """Return the two numbers [x, y] at `key` as a tuple, each in the range of `knob`."""
        value = self.values.get(key, list(default))
        if not isinstance(value, list) or len(value) != 2 or not all(_fits(number, knob) for number in value):
            raise self.error(key, shown(value), f"[x, y], each {knob.wanted}")
        return tuple(knob.check(number) for number in value)

    def table(self, key):
        """Return the table at `key`; an empty one where there is none."""
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            raise self.error(key, shown(value), f"a table [{key}]")
        return CheckedTable(self.file, value, f"{self.where}{key}.")

    def tables(self, key):
        """Return the tables of the array [[key]], each named by its number in messages."""
        value = self.values.get(key, [])
        if not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
            raise self.error(key, shown(value), f"tables [[{key}]]")
        return [CheckedTable(self.file, each, f"{key} {number}.") for number, each in enumerate(value, 1)]

    def _value(self, key, wanted):
        if key not in self.values:
            raise self.error(key, "nothing", wanted)
        return self.values[key]


def read_table(path):
    """Return the CheckedTable in the TOML file at `path`; raise TableError where it cannot be read."""
    return parsed(path, read_text(path, LARGEST_FILE))


def parsed(path, text):
    """Return the CheckedTable of the TOML `text` of the file at `path`; raise TableError where it is broken."""
    try:
        return CheckedTable(path, parse_toml(text))
    except tomllib.TOMLDecodeError as error:
        reason, place = re.fullmatch(r"(.*?)(?: \(at (.*)\))?", str(error), re.DOTALL).groups()
        found, wanted = f"broken TOML ({reason})", "key = value, [table] or [[shape]]"
        raise TableError(path, place or "TOML", found, wanted) from None
    except (ValueError, RecursionError):  # thousands of digits, nested brackets or parts of a key
        raise TableError(path, "TOML", "a number or a nesting out of bounds", "ordinary numbers and tables") from None


def shown(value):
    """Return `value` as short text for a message."""
    if isinstance(value, int) and value.bit_length() > 64:
        return "a huge number"
    if isinstance(value, dict | list):
        return f"a{' table' if isinstance(value, dict) else 'n array'} of {len(value)}"
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    text = repr(value[:50] if isinstance(value, str) else value)
    return text if len(text) <= 60 else text[:57] + "..."


def _fits(value, knob):
    try:
        knob.check(value)
    except (ValueError, OverflowError):
        return False
    return True


def read_text(path, largest):
    """Return the text of the file at `path`, at most `largest` bytes; raise TableError where it cannot be read."""
    wanted = "a text file in UTF-8"
    try:
        if path.is_dir():
            raise TableError(path, "file", "a folder", wanted)
        if path.exists() and not path.is_file():
            raise TableError(path, "file", "no ordinary file", wanted)
        with open(path, "rb") as file:
            raw = file.read(largest + 1)
    except OSError as error:
        raise TableError(path, "file", f"{error.strerror or error}".lower(), wanted) from None
    if len(raw) > largest:
        raise TableError(path, "file", "a larger file", f"at most {largest} bytes")
    try:
        return raw.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise TableError(path, f"line {line}", f"the byte 0x{raw[error.start]:02x}", wanted) from None


def _hidden_in(value):
    """Return words for the first invisible character in a text, but for those that `shown` escapes; or ""."""
    unseen = [sign for sign in value if not sign.isprintable()] if isinstance(value, str) else []
    hidden = next((sign for sign in unseen if unicodedata.category(sign) != "Cc"), None)
    return "" if hidden is None else f"the invisible character U+{ord(hidden):04X} in "
