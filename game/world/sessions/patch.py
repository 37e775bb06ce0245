"""A patch: cells of a world kept before an act, to see whether it changes any of them."""

import numpy as np

from game.core.planes import SAND, WALLS

BAND_WORDS = 2**16  # of a plane, compared at a time: worlds that differ mostly do so soon


class Patch:
    """A copy of the cells in a box, and what else an act on them may change."""

    def __init__(self, world, box):
        """`box`: first column and row, then those after the last; it may reach out of the lattice."""
        self._planes, self._fixtures = world.planes, world.fixtures
        self._rows, self._words = _rows(box, world.layout), _words(box, world.layout)
        self._cells = self._cut(world)

    def settle(self, world):
        """Return whether `world` has changed since; if not, leave it no room for colours that it had not before."""
        if self._fixtures != world.fixtures or _differ(self._cells, self._cut(world), world.layout.bits):
            return True
        world.planes = self._planes
        return False

    def _cut(self, world):
        rows = _words_of(world)[:, self._rows]
        return np.take(rows, self._words, axis=2)


def alike(one, other):
    """Return whether two worlds have the same future under any rule."""
    if any(getattr(one, each) != getattr(other, each) for each in ("codes", "layout", "iteration", "seed", "fixtures")):
        return False
    if one.planes is other.planes:
        return True
    rows, band = one.layout.rows, max(1, BAND_WORDS // one.layout.stride)
    mine, others = _words_of(one), _words_of(other)
    bands = (slice(top, top + band) for top in range(0, rows, band))
    return not any(_differ(mine[:, each], others[:, each], one.layout.bits) for each in bands)


def _words_of(world):
    """Return the (planes, rows, words) of a world, without seams: those hold what an iteration left there."""
    where = world.layout
    rows = world.planes[:, : where.rows * where.stride].reshape(len(world.planes), where.rows, where.stride)
    return rows[:, :, : where.words]


def _differ(one, other, bits):
    """Return whether words of planes differ; a world without colours is like one all of whose sand is amber."""
    if not np.array_equal(one[: 4 * bits], other[: 4 * bits]):
        return True
    mine, others = _dyes(one, bits), _dyes(other, bits)
    if mine.size and others.size:
        return not np.array_equal(mine, others)
    return bool(mine.any() or others.any())


def _dyes(words, bits):
    """Return the bits of colour where there is sand; elsewhere those of moved grains may be left."""
    dyes = words[4 * bits :]
    return dyes.reshape(len(dyes) // 4, 4, *words.shape[1:]) & words[SAND:WALLS]


def _rows(box, where):
    """Return the plane rows that hold a box."""
    return slice(max(0, box[1]) // 2, -(-max(0, min(box[3], where.height)) // 2))


def _words(box, where):
    """Return the words of a plane row that hold a box: neighbours in turn, from the last one on the first again."""
    first, last = max(0, box[0]) // 2, -(-max(0, min(box[2], where.width)) // 2)
    return np.arange(first, min(last, first + where.words)) % where.words
