"""The colours: what is to be told apart can be, and what is to be read can be, in every theme and by every eye."""

import itertools

import pytest

from game import load_rule
from game.core.draw.cells import SHADES
from game.core.draw.looks import (
    AIR,
    AIR_BY_WALL,
    GLEAM,
    GRAIN,
    GRAIN_BY_WALL,
    INSIDE,
    INSIDE_BY_WALL,
    MOST_LOOKS,
    POST,
    SHAPES,
    UNDER,
    WOOD,
    WOOD_EDGE,
    WOOD_RIM,
    Look,
    dyed,
)
from game.world.looks.themes import THEMES, WALL_LOOKS, palette, rgb, substances_of
from game.world.rules.definition import rule_names
from tests.eyes import RARE_SIGHTS, SIGHTS, contrast, difference, lab

FREE = {"stone": (AIR, AIR_BY_WALL), "wood": (AIR, AIR_BY_WALL)}  # what lies about the walls of each kind
FREE["glass"] = (*FREE["stone"], INSIDE, INSIDE_BY_WALL, GLEAM)
EVERYWHERE = pytest.mark.parametrize("walls", WALL_LOOKS)
EVERY_THEME = pytest.mark.parametrize("colours", THEMES.values(), ids=THEMES)
EVERY_EYE = pytest.mark.parametrize("sight", SIGHTS)


def least_difference(colours, walls, sight, ones, others):
    looks = colours.looks(walls)
    seen = [[lab(each, sight) for look in some for each in looks[look]] for some in (ones, others)]
    return min(difference(*pair) for pair in itertools.product(*seen))


def test_the_measures_are_those_of_their_sources():
    assert difference((50, 2.6772, -79.7751), (50, 0, -82.7485)) == pytest.approx(2.0425, abs=1e-4)
    assert difference((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619)) == pytest.approx(2.0373, abs=1e-4)
    assert difference((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514)) == pytest.approx(0.9082, abs=1e-4)
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21)
    assert lab((255, 255, 255), "protanopia") == pytest.approx((100, 0, 0), abs=0.1)


@EVERY_THEME
@EVERYWHERE
@EVERY_EYE
def test_every_eye_tells_sand_from_air_and_walls(colours, walls, sight):
    made_of = colours.looks(walls).keys() - colours.air.keys() - colours.sand.keys() - {WOOD, WOOD_RIM, WOOD_EDGE}
    wood = {POST, WOOD, WOOD_RIM, WOOD_EDGE}
    assert least_difference(colours, walls, sight, colours.sand, FREE[walls]) > 20
    assert least_difference(colours, walls, sight, colours.sand, made_of) > (9 if walls == "wood" else 20)
    assert least_difference(colours, walls, sight, colours.sand, wood) > 9
    assert least_difference(colours, walls, sight, made_of, FREE[walls]) > 8


@EVERY_THEME
@EVERYWHERE
def test_sand_is_the_brightest_thing_but_by_day_and_light_falls_on_it_from_above(colours, walls):
    def brightness(look):
        return [lab(each)[0] for each in colours.looks(walls)[look]]

    lit = [sum(brightness(look)) for look in colours.sand]  # in the order grain, surface, under, by a wall
    assert lit[1] > lit[2] > lit[0] > lit[3]
    if colours.name == "night":
        others = colours.looks(walls).keys() - colours.sand.keys()
        assert min(brightness(min(colours.sand))) > max(max(brightness(look)) for look in others)


@EVERY_THEME
def test_every_word_can_be_read(colours):
    grounds = {role: colours.panel[role] for role in ("ground", "raised", "sunken", "hover", "pressed")}
    for words in ("text", "dim", "faint", "handle"):
        for role, ground in (grounds | {"stage": colours.ground}).items():
            assert contrast(colours.panel[words], ground) >= 4.5, (words, role)
    for words in ("accent", "bright accent"):
        for role in ("ground", "raised", "sunken"):
            assert contrast(colours.panel[words], grounds[role]) >= 4.5, (words, role)
    assert contrast(colours.panel["sunken"], colours.panel["accent"]) >= 4.5
    assert contrast(colours.panel["ring"], colours.panel["ground"]) >= 3


@EVERY_THEME
@EVERYWHERE
def test_every_look_has_its_shades_and_a_mean(colours, walls):
    values = palette(colours, walls)
    assert values.shape == (MOST_LOOKS, SHADES)
    for look, (dark, light) in colours.looks(walls).items():
        assert values[look, 0] == rgb(*dark) and values[look, -1] == rgb(*light)
        assert all(low <= mean <= high for low, mean, high in zip(dark, colours.mean(look, walls), light, strict=True))


def mean(of_look):
    return tuple((dark + light) / 2 for dark, light in zip(*of_look, strict=True))


@EVERY_THEME
@pytest.mark.parametrize("sight", [*SIGHTS, *RARE_SIGHTS])
def test_every_eye_tells_sand_of_each_colour_from_the_others_and_from_air_and_walls(colours, sight):
    sands = [lab(mean(colours.dye(number)[GRAIN]), sight) for number in range(8)]
    assert min(difference(*pair) for pair in itertools.combinations(sands, 2)) > 8.5
    looks = [each for walls in WALL_LOOKS for look, each in colours.looks(walls).items() if look not in colours.sand]
    assert min(difference(one, lab(mean(each), sight)) for one in sands[1:] for each in looks) > 7


@EVERY_THEME
@EVERYWHERE
def test_light_falls_on_every_colour_from_above(colours, walls):
    values = palette(colours, walls)
    for number in range(8):
        looks = colours.dye(number)
        brightness = [sum(lab(each)[0] for each in looks[look]) for look in sorted(looks)]
        assert brightness[1] > brightness[2] > brightness[0] > brightness[3]
        for look, (dark, light) in looks.items():
            assert values[dyed(look)[number], 0] == rgb(*dark) and values[dyed(look)[number], -1] == rgb(*light)


def mean_of(shades):
    return tuple(sum(pair) / 2 for pair in zip(*shades, strict=True))


def means(colours, rule):
    """Return {name: (class, mean colour)} of the materials that a player knows."""
    substances, materials = substances_of(rule.definition.materials), rule.definition.materials
    return {
        materials[each.codes[0]].name: (each.kind, mean_of(colours.seen(Look(SHAPES[each.kind][0], each), "stone")))
        for each in substances.all
        if materials[each.codes[0]].form_of is None
    }


@EVERY_THEME
@EVERY_EYE
@pytest.mark.parametrize("name", rule_names())
def test_every_eye_tells_materials_of_a_class_from_each_other_and_from_air(colours, sight, name):
    seen, air = means(colours, load_rule(name)), lab(colours.mean(AIR), sight)
    for material, (_, colour) in seen.items():
        assert difference(lab(colour, sight), air) > 10, material
    for (one, (kind, colour)), (other, (other_kind, other_colour)) in itertools.combinations(seen.items(), 2):
        if kind == other_kind:
            assert difference(lab(colour, sight), lab(other_colour, sight)) > 12, (one, other)


@EVERY_THEME
def test_through_ice_what_is_behind_shows_faintly_and_not_through_stone(colours):
    substances = substances_of(load_rule("alchemy").definition.materials).all
    ice = next(each for each in substances if each.translucent)
    for shape in (GRAIN, UNDER, GRAIN_BY_WALL):
        clear, solid = (
            mean_of(colours.seen(Look(shape, each), "stone")) for each in (ice, ice._replace(translucent=False))
        )
        for part, own, behind in zip(clear, solid, colours.mean(AIR), strict=True):
            assert min(own, behind) - 1 <= part <= max(own, behind) + 1
            assert abs(part - own) <= abs(part - behind) + 1
        assert clear != solid
