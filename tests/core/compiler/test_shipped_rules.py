"""Under every shipped rule machine code does what the plain twin reads in its pictures, number by number."""

from dataclasses import replace

import numpy as np

from game import World, advance, load_rule, rule_names
from game.core import jit
from game.core.compiler import rule_pass
from game.core.compiler.rule_pass import pass_of
from game.world.files.paths import asset
from tests import reference
from tests.core.compiler.test_rule_pass import Lattice
from tests.sweeps import sweep


@sweep("name", rule_names(), keep=["sand", "water-and-oil"])
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


def test_a_rule_that_was_compiled_before_is_only_loaded_and_moves_all_alike(tmp_path, monkeypatch):
    monkeypatch.setattr(jit, "_FOLDER", tmp_path)
    rule, worlds = load_rule("water-and-oil"), []
    for made in (rule_pass._made, lambda *_: 1 / 0):
        monkeypatch.setattr(rule_pass, "_made", made)
        rule_pass._passes.cache_clear()
        rule_pass._compiled.cache_clear()
        cells = np.random.default_rng(1).integers(0, len(rule.materials), (90, 140)).astype(np.uint8)
        worlds.append(World.from_materials(cells, rule, 7))
        advance(worlds[-1], rule, 200)
    assert worlds[0].digest() == worlds[1].digest() and len(list(tmp_path.iterdir())) == 1


def test_tables_that_say_another_thing_have_another_digest():
    tables = [load_rule(name).table for name in rule_names()]
    claim = tables[0].layers[0][0]
    fewer = replace(tables[0], layers=((claim,), *tables[0].layers[1:]))
    other = replace(tables[0], layers=((replace(claim, face=1), *tables[0].layers[0][1:]), *tables[0].layers[1:]))
    digests = [each.digest for each in (*tables, fewer, other)]
    assert len(set(digests)) == len(digests) and replace(tables[0]).digest == tables[0].digest
