"""Under every shipped rule machine code does what the plain twin reads in its pictures, number by number."""

import numpy as np
import pytest

from game import load_rule, rule_names
from game.core.compiler.rule_pass import pass_of
from game.world.files.paths import asset
from tests import reference
from tests.core.compiler.test_rule_pass import Lattice


@pytest.mark.parametrize("name", rule_names())
def test_a_lattice_goes_as_its_pictures_say(name):
    rule, twin = load_rule(name), reference.Pictures(asset("rules", f"{name}.toml"))
    letters = np.array([each.letter for each in rule.definition.materials])
    moving, generator = pass_of(rule.table, rule.values), np.random.default_rng(70)
    for schedule, shape in (("paper", (10, 13)), ("balanced", (7, 131))):
        codes = generator.integers(0, len(letters), shape) * (generator.random(shape) < 0.6)
        lattice, cells = Lattice(codes, rule.table), letters[codes].tolist()
        for iteration in range(8):
            lattice.advance(moving, schedule, 5, iteration, 1)
            cells = reference.step(cells, twin, schedule, 5, iteration)
            assert letters[lattice.codes].tolist() == cells
