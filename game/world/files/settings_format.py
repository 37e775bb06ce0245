"""The settings' file: a line `key = value` each, read one by one, so that a bad line costs no other one its value."""

import json
from dataclasses import dataclass, field

from game.world.files.atomic import printable
from game.world.files.checked_table import shown
from game.world.files.toml_text import parse_toml

VERSION = 1
HEAD = """\
# Sandglass remembers its settings here. A line that begins with # is a default: take the # away to change it.
# A line that cannot be used is named at the next start, and put at the end of this file.
"""
REST = "# Kept as it was: from another version, or not understood (#?)."


@dataclass
class Kept:
    """What a settings' file holds."""

    version: int = VERSION
    values: dict = field(default_factory=dict)
    strangers: list = field(default_factory=list)  # lines that are kept as they are
    problems: list = field(default_factory=list)  # what is wrong, one line each


def read_lines(data, rows):
    """Return what the bytes of a file say, given {name: row}; whatever they are, this raises nothing."""
    kept = Kept()
    lines = data.removeprefix(b"\xef\xbb\xbf").replace(b"\r\n", b"\n").split(b"\n")
    for number, line in enumerate(lines, 1):
        plain = line.strip()
        if plain.startswith(b"["):  # a table, which no version so far writes: it goes on to the end
            kept.strangers += [each.decode("utf-8", "replace") for each in lines[number - 1 :] if each.strip()]
            break
        if plain.startswith(b"#?"):
            kept.strangers.append(plain.decode("utf-8", "replace"))
        elif plain and not plain.startswith(b"#"):
            _read_line(kept, plain, number, rows)
    return kept


def _read_line(kept, line, number, rows):
    try:
        [(key, value)] = parse_toml(line.decode()).items()
    except (ValueError, RecursionError):  # of TOML, of UTF-8, of numbers too long, of more keys than one
        _put_aside(kept, line, f"line {number}: found {shown(line.decode('utf-8', 'replace'))}, wanted key = value")
        return
    if key == "version":
        kept.version = value if isinstance(value, int) and VERSION < value < 2**31 else VERSION
    elif key not in rows:
        kept.strangers.append(line.decode())
    else:
        _take(kept, line, number, rows[key], value)


def _take(kept, line, number, row, value):
    try:
        kept.values[row.name] = row.check(value)
    except (ValueError, OverflowError):
        _put_aside(kept, line, f"line {number}: {row.name}: found {shown(value)}, wanted {row.wanted}")


def _put_aside(kept, line, problem):
    kept.problems.append(printable(problem))
    kept.strangers.append(f"#? {line.decode('utf-8', 'replace')}")


def written(kept, rows):
    """Return the file's bytes: a row's value where it is not the default, which stands in a comment."""
    parts = [HEAD, f"version = {kept.version}\n"]
    for row in rows:
        value = kept.values.get(row.name, row.default)
        sign = "# " if value == row.default else ""
        parts.append(f"# {_meaning(row)}\n{sign}{row.name} = {_spelled(value)}\n")
    if kept.strangers:
        parts.append("\n".join([REST, *kept.strangers]) + "\n")
    return "\n".join(parts).encode()


def _meaning(row):
    return f"{row.meaning[:1].upper()}{row.meaning[1:]}: {row.wanted}."


def _spelled(value):
    """Return a value as TOML spells it."""
    return json.dumps(list(value) if isinstance(value, tuple) else value)
