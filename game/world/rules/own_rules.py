"""The player's own rules: files in a folder of theirs, beside those that are shipped."""

import re
from contextlib import suppress

from game.world.files.atomic import FileError, make_folder, save_as_new
from game.world.files.checked_table import read_text
from game.world.files.paths import asset, folder_of, numbered
from game.world.rules.definition import MOST_INCLUDES, definition_of_texts
from game.world.rules.rule_text import LARGEST_FILE, RuleText

_NUMBER = r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?"


def own_rules():
    """Return {name: path} of the player's rules."""
    found = {}
    with suppress(OSError):
        for path in sorted(folder_of("rules").glob("*.toml")):
            with suppress(FileError):
                if "[materials" in read_text(path, LARGEST_FILE):
                    found[path.stem] = path
    return found


def copy_rule(rule):
    """Write a rule's file, with its values as they are turned, among the player's own; return the new file's path.

    Files that it includes and that are not shipped go with it. Raises FileError; no file is ever replaced.
    """
    folder, told = folder_of("rules"), rule.definition
    make_folder(folder)
    included = zip(_included(told), told.texts[1:], strict=True)
    for name, text in included:
        _keep_beside(folder, name, text)
    path = folder / f"my-{told.name.removeprefix('my-')}.toml"  # another name than its own: it is another rule
    return save_as_new(numbered(path), text_of(rule).encode())


def text_of(rule):
    """Return the text of a rule's file with the values of the rule, where they stand in that file."""
    told = rule.definition
    text = told.texts[0]
    lines, read = text.split("\n"), RuleText(f"{told.name}.toml", text)
    chances, materials = (read.section(key).lines for key in ("chances", "materials"))
    for each in told.plain.chances:
        value = rule.chances[each.name]
        if value != each.default and each.name in chances:
            _set(lines, chances[each.name], rf"(value\s*=\s*|^\s*{each.name}\s*=\s*)({_NUMBER})", value)
    for name in told.turned:
        material, _, number = name.partition(".")
        if material in materials:
            _set(lines, materials[material], rf"(\b{number}\s*=\s*)({_NUMBER})", rule.chances[name], number)
    turned = "\n".join(lines)
    return turned if _says(rule, turned) else text


def _set(lines, number, pattern, value, name=None):
    """Write a value into a line, by its number from 1; under a name at its end where it has none."""
    line, times = re.subn(pattern, rf"\g<1>{value:.6g}", lines[number - 1], count=1)
    if not times and name:
        line = re.sub(r"\s*\}(?!.*\})", f", {name} = {value:.6g} }}", line, count=1)
    lines[number - 1] = line


def _says(rule, text):
    """Return whether a text makes a rule with the values of this one, as nearly as they are written."""
    told = rule.definition
    try:
        made = definition_of_texts(told.name, (text, *told.texts[1:]))
    except FileError:
        return False
    usual = {each.name: each.default for each in made.chances} | made.own_numbers
    return all(abs(usual.get(name, value) - value) < 1e-5 for name, value in rule.chances.items())


def _included(told):
    return RuleText(f"{told.name}.toml", told.texts[0]).root.names("include", MOST_INCLUDES)


def _keep_beside(folder, name, text):
    """Put an included file into a folder, unless it is shipped or there already."""
    path, shipped = folder / f"{name}.toml", asset("rules", f"{name}.toml")
    if shipped.is_file() and shipped.read_text("utf-8") == text:
        return
    if path.exists() and path.read_text("utf-8", "replace") != text:
        raise FileError(f"{path}: include: found another file of that name, wanted the one that the rule includes")
    if not path.exists():
        save_as_new(lambda _: path, text.encode())
