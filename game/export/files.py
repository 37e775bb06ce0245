"""The files of an export: templates filled in with a rule and what it starts with."""

from string import Template

from game.export.c_text import listed, plain, text
from game.export.folder import MARK
from game.export.rule_parts import rule_parts
from game.export.scene_part import scene_parts
from game.world.files.paths import asset

NAMES = ("sandglass.h", "example.c", "README.md")


def files(start):
    """Return {name: text} of the files for a StartScene; raise ValueError for cells that are too many runs."""
    told = f"It is {start.told}{''.join(f', without {each}' for each in start.left_out)}."
    parts = {
        **rule_parts(start.rule),
        **scene_parts(start.cells, len(start.rule.materials), told),
        "letters": listed(text(each.letter) for each in start.rule.definition.materials),
        "scene_told": plain(start.told),
        "mark": MARK,
    }
    return {name: Template(asset("export", f"{name}.in").read_text("utf-8")).substitute(parts) for name in NAMES}
