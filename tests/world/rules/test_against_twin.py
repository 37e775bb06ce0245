"""What the loader makes of a rule file is what the plain twin reads in its pictures, block by block."""

import random
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as some

from game import Rule, load_rule, rule_names
from game.world.files.paths import asset
from tests import reference
from tests.sweeps import sweep

MOST_BLOCKS, SOME_BLOCKS = 700, 250  # of a rule: compared are all, as with five materials, or some


def assert_same(rule, twin):
    """Every block has the same outcomes with the same probabilities."""
    letters = [each.letter for each in rule.definition.materials]
    blocks = list(product(range(len(letters)), repeat=4))
    for block in blocks if len(blocks) <= MOST_BLOCKS else random.Random(7).sample(blocks, SOME_BLOCKS):
        found = {tuple(letters[code] for code in after): p for p, after in rule.outcomes(block)}
        assert found == pytest.approx(twin.outcomes([letters[code] for code in block]), abs=1e-12), block


@pytest.mark.parametrize("name", rule_names())
def test_a_shipped_rule_is_what_its_pictures_say(name):
    assert_same(load_rule(name), reference.Pictures(asset("rules", f"{name}.toml")))


@sweep("name", rule_names(), keep=["sand", "water-and-oil"])
def test_chances_can_be_turned(name):
    rule, draw = load_rule(name), random.Random(name)
    chances = {each: draw.choice([0.0, 0.125, 0.4]) for each in rule.chances}
    assert_same(rule.with_chances(**chances), reference.Pictures(asset("rules", f"{name}.toml"), **chances))


def test_the_sand_in_pictures_is_the_sand_in_words():
    chances = dict(zip(Rule().chances, (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7), strict=True))
    twin = reference.Pictures(asset("rules", "sand.toml"), **chances)
    for block in product(".o#", repeat=4):
        event = reference.event(*block)
        expected = {} if event is None else {event[0]: 1.0 if event[1] == reference.ALWAYS else chances[event[1]]}
        assert twin.outcomes(block) == pytest.approx(expected)


@pytest.mark.parametrize("schedule", reference.SCHEDULES)
def test_the_sand_in_pictures_draws_what_the_sand_in_words_draws(schedule):
    chances = dict(zip(Rule().chances, (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7), strict=True))
    draw = random.Random(schedule)
    cells = [draw.choices("..oo#", k=17) for _ in range(12)]
    twin = reference.Pictures(asset("rules", "sand.toml"), **chances)
    assert reference.run(cells, twin, schedule, 5, 20) == reference.run(cells, chances, schedule, 5, 20)


@pytest.mark.parametrize("schedule", reference.SCHEDULES)
@pytest.mark.parametrize("shape", [(9, 13), (10, 12)])
def test_outside_is_wall_on_all_four_sides(schedule, shape):
    """Two more cells of wall all round leave the partitions where they are, and so change nothing."""
    draw, certain = random.Random(3), dict.fromkeys(Rule().chances, 1.0)
    cells = [draw.choices("..oo#", k=shape[1]) for _ in range(shape[0])]
    wall = [["#"] * (shape[1] + 4)] * 2
    framed = reference.run([*wall, *(["#", "#", *row, "#", "#"] for row in cells), *wall], certain, schedule, 0, 40)
    assert [row[2:-2] for row in framed[2:-2]] == reference.run(cells, certain, schedule, 0, 40)


CLASSES = some.sampled_from(["powder", "liquid", "gas", "solid"])
CHANCES = some.sampled_from(["0.25", "0.5", '"slow"', '"fast"', '"B.own"', '"a.own"'])
SHAPES = some.sampled_from([(1, 1), (1, 2), (2, 1), (2, 2)])
WAYS = some.sampled_from(["", 'ways = "as drawn"\n', 'ways = "mirror"\n', 'ways = "turn"\n'])


@some.composite
def events(draw, number):
    height, width = draw(SHAPES)
    before = draw(some.text(".ab#?BCDE", min_size=height * width, max_size=height * width))
    own = [sign for sign in before if sign not in "?#DE"]
    outcomes = draw(some.integers(1, 2))
    # walls stay: what may be one is put back where it was
    afters = [
        [sign if sign in "?#DE" else draw(some.sampled_from([".", "a", "b", *own])) for sign in before]
        for _ in range(outcomes)
    ]
    rows = [" ".join("".join(grid[y * width : (y + 1) * width]) for grid in (before, *afters)) for y in range(height)]
    chances = [draw(CHANCES) for _ in range(outcomes)]
    chances = [each if each[0] != '"' or "." not in each or each[1] in before else "0.5" for each in chances]
    signs = sorted(set(before) - {"?"})
    where = ""
    if signs and draw(some.booleans()):
        x, y = draw(some.sampled_from(signs)), draw(some.sampled_from(signs))
        where = f'where = ["{x} {draw(some.sampled_from(["sinks in", "rests on"]))} {y}"]\n'
    layer = draw(some.sampled_from(["", 'layer = "second"\n', 'layer = "third"\n']))
    picture = "\n".join(rows)
    return (
        f'[[event]]\nname = "event {number}"\n{layer}{draw(WAYS)}{where}'
        f"chance = [{', '.join(chances)}]\npicture = '''\n{picture}\n'''\n"
    )


@some.composite
def rule_files(draw):
    first, second = draw(CLASSES), draw(CLASSES)
    densities = draw(some.tuples(some.integers(-2, 2), some.integers(-2, 2)))
    materials = (
        f'air = {{ letter = ".", class = "empty", colour = "#000000" }}\n'
        f'first = {{ letter = "a", class = "{first}", density = {densities[0]}, colour = "#ff0000", own = 0.375 }}\n'
        f'wall = {{ letter = "#", class = "solid", colour = "#ffffff" }}\n'
        f'second = {{ letter = "b", class = "{second}", density = {densities[1]}, colour = "#00ff00", own = "slow" }}\n'
    )
    groups = 'B = "first, second"\nC = "everything, but wall"\nD = "everything"\nE = "everything, but first"\n'
    told = "".join(draw(events(number)) for number in range(draw(some.integers(1, 6))))
    asks = '[[event]]\nname = "asks"\nchance = "B.own"\npicture = "B. -> .B"\n'
    return (
        f'layers = ["first", "second", "third"]\n[materials]\n{materials}[any]\n{groups}'
        f"[chances]\nslow = 0.125\nfast = 0.5\n{told}{asks}"
    )


@given(text=rule_files())
def test_any_rule_is_what_its_pictures_say(text, tmp_path_factory):
    path = tmp_path_factory.mktemp("rules") / "any.toml"
    path.write_text(text, encoding="utf-8")
    assert_same(load_rule(path), reference.Pictures(path))
