"""Swatches: what stands for a material beside the world looks as it does in the world."""

import pytest

from game import load_rule
from game.core.draw.looks import GRAIN, LIQUID, WALL, Look
from game.play.view.swatches import swatch_of
from game.world.looks.themes import THEMES, substances_of

SHAPE = {"powder": GRAIN, "liquid": LIQUID, "solid": WALL}


@pytest.mark.parametrize("theme", THEMES)
def test_a_swatch_is_as_light_or_dark_as_what_it_stands_for(theme):
    colours, rule = THEMES[theme], load_rule("alchemy")
    substances = {code: each for each in substances_of(rule.definition.materials).all for code in each.codes}
    for code, material in enumerate(rule.definition.materials):
        if material.kind in SHAPE and substances[code].colour and not (material.glows or material.translucent):
            dark, light = colours.seen(Look(SHAPE[material.kind], substances[code]), "stone")
            swatch = swatch_of(colours, material)
            near = [abs((low + high) / 2 - part) for low, high, part in zip(dark, light, swatch, strict=True)]
            assert max(near) < 24, material.name
