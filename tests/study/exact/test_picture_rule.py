"""The exact chain's own reader of rule files, and the chain of a rule: right by hand and as the plain twin reads."""

import random
from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from game import rule_names
from game.study.exact.lattices import LATTICES as LATTICES_OF_SAND
from game.study.exact.markov_chain import KINDS, SCHEDULES, explore
from game.study.exact.picture_chain import PictureChain
from game.study.exact.picture_rule import PictureRule
from game.study.exact.rule_lattices import LATTICES
from game.world.files.paths import asset
from tests import reference
from tests.sweeps import sweep

MOST_BLOCKS = 700  # of a rule: compared are all, as with five materials, or so many
SEVEN = (0.35, 0.8, 0.9, 0.55, 0.15, 0.7, 0.45)


def pictures(name, chances=None):
    return PictureRule(asset("rules", f"{name}.toml"), chances)


@sweep("name", rule_names(), keep=["sand", "water-and-oil", "three-sands"])
def test_it_reads_what_the_plain_twin_reads(name):
    chances = {each: 0.1 + 0.03 * number for number, each in enumerate(pictures(name).chances)}
    chances |= {each: 0.2 for each in ("smoulder", "die") if each in chances}
    rule, twin = pictures(name, chances), reference.Pictures(asset("rules", f"{name}.toml"), **chances)
    blocks = list(product(rule.materials, repeat=4))
    for block in blocks if len(blocks) <= MOST_BLOCKS else random.Random(3).sample(blocks, MOST_BLOCKS):
        found = dict(rule.fate(block := "".join(block)).outcomes)
        assert sum(found.values()) == pytest.approx(1.0, abs=1e-12)
        found.pop(block, None)
        wanted = {"".join(after): p for after, p in twin.outcomes(block).items()}
        assert found == pytest.approx(wanted, abs=1e-12), block


@sweep("schedule", SCHEDULES, keep=["balanced"])
@pytest.mark.parametrize("name", ["tower at the left edge", "walls in every role", "single column"])
def test_the_chain_of_sands_pictures_is_that_of_sand_in_words(name, schedule):
    rows, rule = LATTICES_OF_SAND[name], pictures("sand", dict(zip(KINDS, SEVEN, strict=True)))
    words = explore(rows, SCHEDULES[schedule])
    *_, wanted = words.distributions(SEVEN, 9)
    chain = PictureChain(rows, rule, SCHEDULES[schedule])
    *_, found = chain.distributions(9, 10**5)
    sand = chain.seen(found, "o")
    order = np.argsort(words.states)
    assert (sand.states == words.states[order][wanted[order] > 0]).all()
    assert sand.chances == pytest.approx(wanted[order][wanted[order] > 0], rel=1e-12)


def test_layers_follow_each_other_by_hand():
    rows, rule = ["pf", "##"], pictures("alchemy", {"kindle": 0.25, "smoulder": 0.5, "die": 0.125, "cling": 0.5})
    (now,) = PictureChain(rows, rule, SCHEDULES["paper"]).distributions(1, 100)
    fire, plant = (PictureChain(rows, rule, SCHEDULES["paper"]).seen(now, letter) for letter in "fp")
    assert dict(zip(plant.states.tolist(), plant.chances.tolist(), strict=True)) == {0: 0.25, 1: 0.75}
    assert dict(zip(fire.states.tolist(), fire.chances.tolist(), strict=True)) == {2: 0.75, 3: 0.25}


def test_float_chances_are_those_in_fractions():
    rows, rule = LATTICES["water-and-oil"]["oil below water"], pictures("water-and-oil")
    chain = PictureChain(rows, rule, SCHEDULES["balanced"])
    exact = {"".join(rows): Fraction(1)}
    for iteration in range(5):
        x, y = chain.offsets[iteration % 4]
        exact = after_iteration(exact, rule, len(rows), len(rows[0]), x, y)
    *_, found = chain.distributions(5, 10**5)
    for letter in rule.materials:
        wanted = {}
        for cells, p in exact.items():
            state = sum(1 << place for place, cell in enumerate(cells) if cell == letter)
            wanted[state] = wanted.get(state, 0) + p
        seen = chain.seen(found, letter)
        states = dict(zip(seen.states.tolist(), seen.chances, strict=True))
        assert states == pytest.approx({state: float(p) for state, p in wanted.items()}, rel=1e-9)


def after_iteration(states, rule, height, width, x, y):
    """Return {cells as one text: Fraction} after the partition at (x, y), state by state and block by block."""
    for top, left in product(range(-y, height, 2), range(-x, width, 2)):
        corners = [(top, left), (top, left + 1), (top + 1, left), (top + 1, left + 1)]
        inside = [0 <= row < height and 0 <= column < width for row, column in corners]
        after = {}
        for cells, p in states.items():
            block = "".join(
                cells[r * width + c] if here else rule.wall for (r, c), here in zip(corners, inside, strict=True)
            )
            for new, share in rule.fate(block).outcomes.items():
                changed = list(cells)
                for (r, c), here, letter in zip(corners, inside, new, strict=True):
                    if here:
                        changed[r * width + c] = letter
                key = "".join(changed)
                after[key] = after.get(key, 0) + p * Fraction(share)
        states = after
    return states


def test_a_lattice_with_too_many_states_for_a_number_is_refused():
    with pytest.raises(ValueError, match="17 cells of 16 materials"):
        PictureChain(["." * 17], pictures("alchemy"), SCHEDULES["paper"])


@sweep("name", LATTICES, keep=["three-sands"])
def test_the_lattices_come_to_every_event_of_their_rule_that_its_materials_can_have(name):
    rule = pictures(name)
    missing = {event.name for event in rule.events}
    for rows in LATTICES[name].values():
        assert len({len(row) for row in rows}) == 1 and set("".join(rows)) <= set(rule.materials)
        for offsets in SCHEDULES.values():
            chain = PictureChain(rows, rule, offsets)
            assert list(chain.distributions(12, 2000))
            missing -= chain.claimed
    gases = {"drift", "rise", "slip up", "spread below a ceiling"}
    assert missing == (gases if name == "water-and-oil" else set())
