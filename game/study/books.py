"""Books: the sums of cells that a rule's file says are kept, followed for a long time through random worlds."""

from typing import NamedTuple

import numpy as np

from game import World, advance
from game.core.rule_table import corners
from game.study.report import report

LOOK = 503  # iterations between two looks: odd and no multiple of any cycle, so that flips meet every phase
LIFE = 20  # looks at a world, which is turned over after each; then comes another
SIDES = 20, 140  # cells: the least and the most of a world's height and width
BOOKS = "the books of the rule's file"


class BookLaw(NamedTuple):
    """How a sum of cells may change: not at all, or by its exceptions one way only."""

    words: str
    codes: tuple
    may_fall: bool
    may_rise: bool


class Followed(NamedTuple):
    """What was found in one rule's worlds."""

    worlds: int
    looks: int
    broken: dict  # {words of a BookLaw: looks at which it was broken}
    walls: int  # looks at which a wall had changed


def laws_of(rule):
    """Return the BookLaws of a rule's books, without those that exceptions may change both ways."""
    laws = []
    for book in rule.definition.books:
        codes = tuple(sorted(book.codes))
        changes = _changes(rule.table, codes) if book.but else {0}
        laws.append(BookLaw(book.words, codes, min(changes) < 0, max(changes) > 0))
    return [law for law in laws if not (law.may_fall and law.may_rise)]


def _changes(table, codes):
    """Return the set of changes of a sum of cells that the outcomes of a table make."""
    found = set()
    for claim in (claim for layer in table.layers for claim in layer):
        before = np.isin(corners(claim.states, table.bits), codes).sum(axis=0)
        for outcome in claim.outcomes:
            found |= set((np.isin(corners(outcome.after, table.bits), codes).sum(axis=0) - before).tolist())
    return found


def follow(rule, laws, iterations, seed):
    """Follow random worlds of a rule for so many iterations in all; return what was Followed."""
    generator = np.random.default_rng(seed)
    looks, worlds, walls = -(-iterations // LOOK), 0, 0
    broken = {law.words: 0 for law in laws}
    for look in range(looks):
        if look % LIFE == 0:
            worlds += 1
            world = _strewn(rule, generator, seed + worlds)
        before, walls_before = _sums(world, laws), world.walls
        advance(world, rule, LOOK)
        for law, old, new in zip(laws, before, _sums(world, laws), strict=True):
            broken[law.words] += (new < old and not law.may_fall) or (new > old and not law.may_rise)
        walls += not np.array_equal(world.walls, walls_before)
        world.flip()
    return Followed(worlds, looks, broken, walls)


def _strewn(rule, generator, seed):
    """Return a World of a random size with all materials at random, in lumps."""
    height, width = generator.integers(*SIDES, 2).tolist()
    lump = int(generator.integers(1, 6))
    codes = generator.integers(0, len(rule.materials), (-(-height // lump), -(-width // lump)), np.uint8)
    cells = codes.repeat(lump, axis=0).repeat(lump, axis=1)[:height, :width]
    return World.from_materials(np.ascontiguousarray(cells), rule, seed)


def _sums(world, laws):
    counts = np.bincount(world.materials.ravel(), minlength=len(world.codes.names))
    return [int(counts[list(law.codes)].sum()) for law in laws]


def rows(rule, iterations, seed):
    """Yield the rows on a rule's books, after so many iterations of random worlds."""
    laws, name = laws_of(rule), rule.definition.name
    found = follow(rule, laws, iterations, seed)
    where = f"{found.looks:,} looks in {found.looks * LOOK:,} iterations of {found.worlds} worlds"
    for law in laws:
        change = "more than before" if law.may_fall else "less than before" if law.may_rise else "not as before"
        quantity = f"{name}: looks at which {law.words} is {change}, of {where}"
        yield report.same(quantity, found.broken[law.words], 0, BOOKS)
    yield report.same(f"{name}: looks at which a wall has changed, of {where}", found.walls, 0, BOOKS)
