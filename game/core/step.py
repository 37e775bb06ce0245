"""One iteration, and batches of them, on striped planes: a kernel for each kind of rule.

An iteration goes down the lattice chunk by chunk. In a chunk a first pass over all words makes the moves that are
certain and notes the candidates, blocks whose event is left to chance; a second pass visits only words with candidates
and draws.
"""

import numpy as np

from game.core.block import events
from game.core.chance import iteration_key, random_word
from game.core.jit import gate, kernel
from game.core.planes import SHIFTED_WALLS, WALLS

CHUNK = 512  # words whose candidates wait in a buffer: 4 KiB, so that they stay in the first cache

_ZERO = np.uint64(0)
_ONE = np.uint64(1)


@gate
def corners(planes, stride, x, y, first, size):
    """Return sand and walls, a b c d each, of the `size` words of blocks from `first` in the partition at (x, y)."""
    upper, lower = 2 * y, 2 - 2 * y
    below, right = first + y * stride + size, first + x + size
    below_right = below + x
    left_walls = WALLS + x
    right_walls_above = SHIFTED_WALLS + y if x else WALLS + upper + 1
    right_walls_below = SHIFTED_WALLS + 1 - y if x else WALLS + lower + 1
    return (
        planes[upper + x, first : first + size],
        planes[upper + 1 - x, right - size : right],
        planes[lower + x, below - size : below],
        planes[lower + 1 - x, below_right - size : below_right],
        planes[left_walls + upper, first : first + size],
        planes[right_walls_above, right - size : right],
        planes[left_walls + lower, below - size : below],
        planes[right_walls_below, below_right - size : below_right],
    )


@gate
def open_seams(planes, rows, stride):
    """Give the last word of each row its right-hand neighbours, before an iteration with odd x."""
    for parity in range(2):
        even = planes[2 * parity]
        for start in range(0, rows * stride, stride):
            even[start + stride - 1] = even[start] >> _ONE


@gate
def close_seams(planes, rows, stride):
    """Take what the iteration made of the seams back into the first words; column 0 belonged to no block."""
    for parity in range(2):
        even = planes[2 * parity]
        for start in range(0, rows * stride, stride):
            even[start] = (even[start + stride - 1] << _ONE) | (even[start] & _ONE)


@gate
def move_certain(a, b, c, d, wa, wb, wc, wd):
    """Move every grain that can move, in place."""
    for i in range(a.size):
        fl, fr, tl, tr = events(a[i], b[i], a[i] | wa[i], b[i] | wb[i], c[i] | wc[i], d[i] | wd[i])
        a[i] ^= fl | tr
        b[i] ^= fr | tl
        c[i] ^= fl | tl
        d[i] ^= fr | tr


@gate
def fall_all(a, b, c, d, wa, wb, wc, wd, candidates):
    """Let every free column fall, in place; note the topples in `candidates` and return whether there are any."""
    some = _ZERO
    for i in range(a.size):
        fl, fr, tl, tr = events(a[i], b[i], a[i] | wa[i], b[i] | wb[i], c[i] | wc[i], d[i] | wd[i])
        a[i] ^= fl
        b[i] ^= fr
        c[i] ^= fl
        d[i] ^= fr
        candidates[i] = tl | tr
        some |= tl | tr
    return some != _ZERO


@gate
def fall_alone(a, b, c, d, wa, wb, wc, wd, candidates):
    """Let lone grains fall, in place; note every other event in `candidates` and return whether there are any."""
    some = _ZERO
    for i in range(a.size):
        oa, ob, oc, od = a[i] | wa[i], b[i] | wb[i], c[i] | wc[i], d[i] | wd[i]
        fl, fr, tl, tr = events(a[i], b[i], oa, ob, oc, od)
        alone_left, alone_right = fl & ~(ob | od), fr & ~(oa | oc)
        a[i] ^= alone_left
        b[i] ^= alone_right
        c[i] ^= alone_left
        d[i] ^= alone_right
        candidates[i] = (fl ^ alone_left) | (fr ^ alone_right) | tl | tr
        some |= candidates[i]
    return some != _ZERO


@gate
def topple_some(a, b, c, d, candidates, first, key, always, bits):
    """Let each candidate topple with its probability, in place."""
    for i in range(a.size):
        rest = candidates[i]
        if rest == _ZERO:
            continue
        left, right = rest & b[i], rest & a[i]
        accepted = (left & always[0]) | (right & always[1])
        rest &= ~accepted
        for draw in range(len(bits)):
            if rest == _ZERO:
                break
            random = random_word(key, np.uint64(first + i), np.uint64(draw))
            digit = (left & bits[draw, 0]) | (right & bits[draw, 1])
            accepted |= rest & digit & ~random
            rest &= ~(random ^ digit)
        left &= accepted
        right &= accepted
        a[i] ^= right
        b[i] ^= left
        c[i] ^= left
        d[i] ^= right


@gate
def move_some(a, b, c, d, wa, wb, wc, wd, candidates, first, key, always, bits):
    """Let each candidate's event happen with its probability, in place."""
    for i in range(a.size):
        rest = candidates[i]
        if rest == _ZERO:
            continue
        oa, ob, oc, od = a[i] | wa[i], b[i] | wb[i], c[i] | wc[i], d[i] | wd[i]
        fl, fr, tl, tr = events(a[i], b[i], oa, ob, oc, od)
        kinds = (
            tl,
            tr,
            (fl & ob & ~od) | (fr & oa & ~oc),
            fl & ~ob & od,
            fr & ~oa & oc,
            fl & ob & od,
            fr & oa & oc,
        )
        accepted = chosen(kinds, always)
        rest &= ~accepted
        for draw in range(len(bits)):
            if rest == _ZERO:
                break
            random = random_word(key, np.uint64(first + i), np.uint64(draw))
            digit = chosen(kinds, bits[draw])
            accepted |= rest & digit & ~random
            rest &= ~(random ^ digit)
        a[i] ^= accepted & (fl | tr)
        b[i] ^= accepted & (fr | tl)
        c[i] ^= accepted & (fl | tl)
        d[i] ^= accepted & (fr | tr)


@gate
def chosen(kinds, masks):
    """Return the blocks whose kind of event has its mask set."""
    found = _ZERO
    for kind in range(7):
        found |= kinds[kind] & masks[kind]
    return found


@gate
def move_chunk(planes, stride, x, y, first, size, key, buffer, topples, all_seven):
    """Move the sand in `size` words of blocks from `first`, in place."""
    a, b, c, d, wa, wb, wc, wd = corners(planes, stride, x, y, first, size)
    candidates = buffer[:size]
    if topples is not None:
        if fall_all(a, b, c, d, wa, wb, wc, wd, candidates):
            topple_some(a, b, c, d, candidates, first, key, topples[0], topples[1])
    elif all_seven is not None:
        if fall_alone(a, b, c, d, wa, wb, wc, wd, candidates):
            move_some(a, b, c, d, wa, wb, wc, wd, candidates, first, key, all_seven[0], all_seven[1])
    else:
        move_certain(a, b, c, d, wa, wb, wc, wd)


@kernel
def advance_planes(planes, rows, stride, offsets, seed, iteration, iterations, topples, all_seven):
    """Run a batch of iterations in place.

    offsets: (x, y) of the first iterations, repeated. seed, iteration: uint64. topples, all_seven: what
    `chance.bit_masks` gives for (topple_left, topple_right) or for all seven probabilities, where the rule leaves them
    to chance; else None, and then the code for them is not even compiled.
    """
    buffer = np.empty(CHUNK, np.uint64)
    for t in range(iterations):
        x, y = offsets[t % len(offsets)]
        key = iteration_key(seed, iteration + np.uint64(t))
        words = (rows - y) * stride
        if x:
            open_seams(planes, rows, stride)
        for first in range(0, words, CHUNK):
            move_chunk(planes, stride, x, y, first, min(CHUNK, words - first), key, buffer, topples, all_seven)
        if x:
            close_seams(planes, rows, stride)
