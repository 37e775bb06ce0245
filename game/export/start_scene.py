"""What an exported rule starts with: a scene, or a small hourglass."""

from typing import NamedTuple

import numpy as np

from game.world.rules.rule import Rule
from game.world.scenes.hourglass_spec import Glass

GLASS = Glass(width=40, height=44, across=0, down=0, wall=2)
FALLING = ("powder", "liquid")


class StartScene(NamedTuple):
    """Cells and the rule that moves them."""

    rule: Rule
    cells: np.ndarray  # (H, W) uint8: codes
    told: str  # what it is, after "shows"
    left_out: tuple  # what of the scene a header has not, in words


def scene_start(scene):
    """Return the StartScene of a Scene."""
    left_out = ["its taps and drains"] if scene.fixtures else []
    left_out += ["the colours of the sand"] if scene.coloured else []
    height, width = scene.shape
    return StartScene(scene.rule, scene.cells, f"the scene {scene.title}, {width}×{height} cells", tuple(left_out))


def small_start(rule):
    """Return the StartScene of a rule alone: a glass of what falls, or a heap in a box of air if nothing does."""
    materials, usual = rule.definition.materials, rule.codes.code(rule.codes.usual)
    falling = [code for code, each in enumerate(materials) if each.kind in FALLING]
    filled, walls = GLASS.cells()
    if not falling:
        return StartScene(
            rule, np.where(filled, np.uint8(usual), np.uint8(0)), f"a heap of {materials[usual].name}", ()
        )
    code = usual if usual in falling else falling[0]
    cells = np.where(filled, np.uint8(code), walls * np.uint8(rule.codes.wall))
    return StartScene(rule, cells, f"a small hourglass of {materials[code].name}", ())
