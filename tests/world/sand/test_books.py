"""Laws of the books: what a rule's file says is kept is kept, whatever happens, and the account knows of all else."""

from itertools import product

import numpy as np
import pytest

from game import World, advance, load_rule
from game.study import books
from game.world.rules.definition import rule_names
from game.world.sand.fixtures import Fixture
from game.world.sessions.action import Clear, Draw, Fill, Flip, Paint, Paste, Resize, SetFixtures, Turn, perform
from game.world.sessions.moment import account_of
from tests.cells import strewn
from tests.sweeps import sweep
from tests.world.random_sessions import stamp_of


@pytest.fixture(params=rule_names())
def rule(request):
    return load_rule(request.param)


def kept(world, rule):
    """Return the number of cells in each sum that no event may change."""
    return [int(np.isin(world.materials, kinds).sum()) for kinds in rule.definition.kept]


@sweep("number", range(3), keep=[0])
def test_what_a_rule_says_is_kept_is_kept_to_the_cell(rule, number):
    world = strewn(rule, number, 40 + number, 131, lumps=1 + number)
    before, walls, account = kept(world, rule), world.walls, account_of(world, rule)
    for _ in range(10):
        advance(world, rule, 300)
        assert kept(world, rule) == before and (world.walls == walls).all() and account.balanced(world)


def test_sums_with_exceptions_change_one_way_only(rule):
    laws = books.laws_of(rule)
    followed = books.follow(rule, laws, 8 * books.LOOK, seed=3)
    assert followed.looks == 8 and not followed.walls and not any(followed.broken.values())
    kept = {law.codes for law in laws if not (law.may_fall or law.may_rise)}
    assert kept == set(rule.definition.kept)


def test_a_sum_that_is_not_kept_is_seen():
    rule = load_rule("alchemy")
    law = books.BookLaw("water", (rule.definition.code("water"),), False, False)
    assert books.follow(rule, [law], books.LOOK, seed=3).broken == {"water": 1}


def test_what_exceptions_may_do_to_a_sum_is_read_off_the_table():
    laws = {law.words: (law.may_fall, law.may_rise) for law in books.laws_of(load_rule("alchemy"))}
    down = (True, False)
    assert laws == {"stone + lava": down, "sand": down, "salt + brine": (False, False), "oil": down, "acid": down}


def random_act(rule, generator):
    """Return an act of a player, with any material."""
    material = generator.choice(("erase", *rule.materials[1:])).item()
    start, end = (tuple(place) for place in generator.uniform((-9, -9), (75, 60), (2, 2)).tolist())
    diameter, over_walls, only = int(generator.integers(1, 12)), bool(generator.integers(2)), ""
    if generator.random() < 0.3:
        only = generator.choice(("empty", *rule.materials[1:])).item()
    taps = (Fixture("tap", *generator.integers(0, 50, 2).tolist(), 5, 2, 3, material=name) for name in rule.materials)
    acts = (
        Paint(material, start, end, diameter, over_walls, only=only),
        Draw("ellipse", material, start, end, 0, over_walls),
        Fill(material, start),
        Paste(stamp_of(int(generator.integers(10))), start, over_walls),
        Resize(66, int(generator.integers(48, 60)), "left"),
        SetFixtures((*taps, Fixture("drain", -3, 30, 40, 2, 2), Fixture("drain", 50, 9, 2, 30))),
        Turn(1),
        Flip(),
    )
    return acts[generator.integers(len(acts))]


@sweep(("name", "number"), product(rule_names(), range(3)), keep=[("sand", 0), ("water-and-oil", 0)])
def test_the_account_balances_after_acts_taps_and_drains(name, number):
    rule = load_rule(name)
    generator = np.random.default_rng(number)
    world = strewn(rule, number, 50, 66, lumps=2)
    account = account_of(world, rule)
    for _ in range(40):
        world, _, grains, _ = perform(random_act(rule, generator), world, rule)
        account = account.booked(grains)
        assert account.balanced(world)
        account = account.passed(advance(world, rule, 100))
        assert account.balanced(world)
    assert account.poured and account.swallowed and account.painted and account.erased
    world, _, grains, _ = perform(Clear(), world, rule)
    assert account.booked(grains).balanced(world)


def test_a_cell_too_many_or_too_few_in_a_sum_that_is_kept_unbalances_the_account(rule):
    world = strewn(rule, 4, 20, 30)
    account, cells = account_of(world, rule), world.materials
    for kinds in [(1,)] if rule.codes.is_sand else rule.definition.kept:
        for code, wrong in ((kinds[0], 0), (0, kinds[0])):
            other = cells.copy()
            other[tuple(np.argwhere(cells == code)[0])] = wrong
            assert not account.balanced(World.from_materials(other, rule))
