"""The text of a rule file: read within bounds, table by table, each knowing in which line its keys stand."""

import re

from game.world.files.checked_table import CheckedTable, TableError, parsed, read_text, shown

LARGEST_FILE = 2**16  # bytes; the longest shipped rule takes 8,000

_OF_RULES = re.compile(r"^\s*\[\[?\s*(materials|event)\b", re.MULTILINE)
_HEADER = re.compile(r"\s*\[\[?\s*([^\[\]]+?)\s*\]\]?")
_KEY = re.compile(r"""\s*["']?([^"'=#\[]+?)["']?\s*=""")


class RuleError(TableError):
    """What is wrong with a rule file, as one line: FILE:LINE: PLACE: found X, wanted Y."""

    def __init__(self, file, line, place, found, wanted):
        super().__init__(f"{file}:{line}" if line else file, place, found, wanted)


class RuleSection(CheckedTable):
    """A table of a rule file. `lines`: {key: line}, with the table's own line at the key ''."""

    def __init__(self, file, values, where, lines):
        super().__init__(file, values, where)
        self.lines = lines

    def error(self, key, found, wanted):
        """Return the RuleError that says what is wrong at `key`."""
        line = self.lines.get(key, self.lines.get("", 0))
        return RuleError(self.file, line, f"{self.where}{key}".removesuffix(": "), found, wanted)

    def names(self, key, most):
        """Return the list of texts at `key` as a tuple; empty where there is none."""
        value = self.values.get(key, [])
        if not isinstance(value, list) or len(value) > most or not all(isinstance(each, str) for each in value):
            raise self.error(key, shown(value), f"a list of at most {most} names")
        return tuple(value)


class RuleText:
    """A rule file, read: `root` is the RuleSection of its top-level keys."""

    def __init__(self, path, text=None):
        """`text`: what the file says, if it is not read from there."""
        self.path = path
        try:
            self.text = read_text(path, LARGEST_FILE) if text is None else text
            values = parsed(path, self.text).values
        except TableError as error:
            line = re.match(r"line (\d+)", error.told[0])
            raise RuleError(path, line and line[1], *error.told) from None
        self._lines = _lines_of(self.text)
        self.root = RuleSection(path, values, "", self._lines.get(("", 0), {}))

    def section(self, key):
        """Return the RuleSection [key]; an empty one where there is none."""
        value = self.root.table(key).values
        return RuleSection(self.path, value, f"{key}: ", self._lines.get((key, 0), {"": self.root.lines.get(key, 0)}))

    def sections(self, key, most):
        """Return the Sections of the array [[key]], at most so many, each named by its number or by its own name."""
        tables = self.root.tables(key)
        if len(tables) > most:
            raise self.root.error(key, f"{len(tables)} of them", f"at most {most}")
        return [self._numbered(key, number, each.values) for number, each in enumerate(tables)]

    def _numbered(self, key, number, values):
        name = values.get("name")
        title = shown(name) if isinstance(name, str) else str(number + 1)
        lines = self._lines.get((key, number), {"": self.root.lines.get(key, 0)})
        return RuleSection(self.path, values, f"{key} {title}: ", lines)


def is_rule(path):
    """Return whether the file at a path tells of a rule, be it right or wrong, and not of a scene."""
    try:
        return _OF_RULES.search(read_text(path, LARGEST_FILE)) is not None
    except TableError:
        return False


def _lines_of(text):
    """Return {(table, how many of that name before it): {key: line}}; a table's own line is at the key ''."""
    seen, now, inside = {}, ("", 0), None
    found = {now: {"": 1}}
    for number, line in enumerate(text.split("\n"), 1):
        if inside is None:
            header, key = _HEADER.match(line), _KEY.match(line)
            if header:
                name = header[1]
                now = name, seen.get(name, 0)
                seen[name] = now[1] + 1
                found[now] = {"": number}
                table, _, key = name.rpartition(".")  # [materials.sand] is a key of [materials] as well
                found.setdefault((table, 0), {}).setdefault(key, number)
            elif key:
                found[now].setdefault(key[1], number)
        inside = _open_string(line, inside)
    return found


def _open_string(line, inside):
    """Return the mark of the multi-line string that is open after a line; `inside` was open before it."""
    for mark in re.findall(r"'''|\"\"\"", line):
        if inside is None:
            inside = mark
        elif inside == mark:
            inside = None
    return inside
