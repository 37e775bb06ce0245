"""One visit to a block: its sand moves in all replicas of a group at once, bit by bit.

Events are found first; those left to chance are drawn; then all accepted ones happen. In between, what is known of each
word waits in a scratch array.
"""

import numpy as np

from game.core.block import events
from game.core.chance import random_word
from game.core.jit import gate

MOST_WORDS = 64  # words of a group at most: rows of scratch have room for no more

# Starts of the rows of scratch. The distances are constants so that the compiler sees that rows do not overlap.
KEYS, _ACCEPTED, _REST, _KINDS = (row * MOST_WORDS for row in range(4))
SCRATCH = _KINDS + 7 * MOST_WORDS

_ZERO = np.uint64(0)


@gate
def kinds(a, b, c, d, wa, wb, wc, wd):
    """Return (any event, lone falls, the seven kinds of event left to chance) in a rule's order."""
    oa, ob, oc, od = a | wa, b | wb, c | wc, d | wd
    fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
    seven = (
        tl,
        tr,
        (fl & ob & ~od) | (fr & oa & ~oc),
        fl & ~ob & od,
        fr & ~oa & oc,
        fl & ob & od,
        fr & oa & oc,
    )
    return fl | fr | tl | tr, (fl & ~(ob | od)) | (fr & ~(oa | oc)), seven


@gate
def seven_of(array, first, step):
    """Return seven values of an array, `step` apart.

    Written out here and below, as a loop over kinds keeps the compiler from vectorising the loop over words around it.
    """
    return (
        array[first],
        array[first + step],
        array[first + 2 * step],
        array[first + 3 * step],
        array[first + 4 * step],
        array[first + 5 * step],
        array[first + 6 * step],
    )


@gate
def chosen(seven, masks):
    """Return the replicas whose kind of event has its mask set."""
    return (
        (seven[0] & masks[0])
        | (seven[1] & masks[1])
        | (seven[2] & masks[2])
        | (seven[3] & masks[3])
        | (seven[4] & masks[4])
        | (seven[5] & masks[5])
        | (seven[6] & masks[6])
    )


@gate
def find_events(a, b, c, d, wa, wb, wc, wd, scratch, always):
    """Note the events that are certain and those left to chance; return the replicas with either, all words in one."""
    certain, undecided = _ZERO, _ZERO
    for k in range(a.size):
        event, alone, seven = kinds(a[k], b[k], c[k], d[k], wa, wb, wc, wd)
        accepted = alone | chosen(seven, always)
        scratch[_ACCEPTED + k] = accepted
        scratch[_REST + k] = event & ~accepted
        certain |= accepted
        undecided |= event & ~accepted
    return certain, undecided


@gate
def sort_events(a, b, c, d, wa, wb, wc, wd, scratch):
    """Note which kind of event each replica has."""
    for k in range(a.size):
        _, _, seven = kinds(a[k], b[k], c[k], d[k], wa, wb, wc, wd)
        scratch[_KINDS + k] = seven[0]
        scratch[_KINDS + MOST_WORDS + k] = seven[1]
        scratch[_KINDS + 2 * MOST_WORDS + k] = seven[2]
        scratch[_KINDS + 3 * MOST_WORDS + k] = seven[3]
        scratch[_KINDS + 4 * MOST_WORDS + k] = seven[4]
        scratch[_KINDS + 5 * MOST_WORDS + k] = seven[5]
        scratch[_KINDS + 6 * MOST_WORDS + k] = seven[6]


@gate
def draw(words, scratch, place, digits, number):
    """Compare the next random bit of each undecided replica with the next digit of its probability.

    Return the replicas that are still undecided, all words in one.
    """
    undecided = _ZERO
    for k in range(words):
        random = random_word(scratch[KEYS + k], place, number)
        digit = chosen(seven_of(scratch, _KINDS + k, MOST_WORDS), digits)
        rest = scratch[_REST + k]
        scratch[_ACCEPTED + k] |= rest & digit & ~random
        rest &= ~(random ^ digit)
        scratch[_REST + k] = rest
        undecided |= rest
    return undecided


@gate
def move(a, b, c, d, wa, wb, wc, wd, scratch):
    """Let the accepted events happen, in place; return the replicas that moved, all words in one."""
    moved = _ZERO
    for k in range(a.size):
        fl, fr, tl, tr = events(a[k], b[k], a[k] | wa, b[k] | wb, c[k] | wc, d[k] | wd)
        accepted = scratch[_ACCEPTED + k]
        a[k] ^= accepted & (fl | tr)
        b[k] ^= accepted & (fr | tl)
        c[k] ^= accepted & (fl | tl)
        d[k] ^= accepted & (fr | tr)
        moved |= accepted
    return moved


@gate
def wall_words(walls, y, x):
    """Return a word for each corner of the block at [y, x], all ones where it is wall, else zero."""
    return (
        _ZERO - np.uint64(walls[y, x]),
        _ZERO - np.uint64(walls[y, x + 1]),
        _ZERO - np.uint64(walls[y + 1, x]),
        _ZERO - np.uint64(walls[y + 1, x + 1]),
    )


@gate
def visit(cells, walls, y, x, scratch, place, always, bits):
    """Move the sand of the block with its upper left corner at [y, x]; return (whether any moved, whether any could).

    place: a uint64 that no other block of the iteration has. scratch: (SCRATCH,) uint64, with the words' keys at KEYS.
    """
    a, b, c, d = cells[y, x], cells[y, x + 1], cells[y + 1, x], cells[y + 1, x + 1]
    wa, wb, wc, wd = wall_words(walls, y, x)
    certain, undecided = find_events(a, b, c, d, wa, wb, wc, wd, scratch, always)
    if (certain | undecided) == _ZERO:
        return False, False
    if undecided != _ZERO:
        sort_events(a, b, c, d, wa, wb, wc, wd, scratch)
        for number in range(len(bits)):
            if draw(a.size, scratch, place, seven_of(bits[number], 0, 1), np.uint64(number)) == _ZERO:
                break
    return move(a, b, c, d, wa, wb, wc, wd, scratch) != _ZERO, True
