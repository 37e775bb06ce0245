"""Iterations of a world with colours in which nothing is left to chance: grains move together with their colours.

Where many words of a band move, one loop over all of them takes sand and colours along, so that neither is fetched
twice. Where few do, they are found first, and nothing else is written, nor are the colours of the others read.

Where a schedule has the lower blocks of two columns and next the upper ones, both iterations run on a band before the
next band is fetched: an upper block shares cells only with the lower ones beside it and above it.
"""

import numpy as np

from game.core.block import events
from game.core.grain_colours import bits_of_colours, follow, moved_along
from game.core.jit import apart, gate, kernel, load, store
from game.core.planes import COLOURS, DEPTH, SAND
from game.core.seam import close_seam, close_seams, open_seam, open_seams
from game.core.step import CYCLE, corner_words, corners, is_still, list_flagged, put

IN_CACHE = 4096  # words of blocks that bands in flight may have together: with colours 3/4 MiB, for the second cache
CROWD = 12  # where more than one word in so many moves, moving all words at once is cheaper

_ZERO, _ONE = np.uint64(0), np.uint64(1)


@gate
def leaving(fl, fr, tl, tr):
    """Return the blocks where a grain leaves a, leaves b, comes to c, comes to d."""
    return fl | tr, fr | tl, fl | tl, fr | tr


@gate
def move_all(planes, at, bits, size):
    """Move every grain that can move and its colour, in place; return in how many words there is one."""
    low, middle, high = bits
    moved = _ZERO
    apart()
    for i in range(size):
        a, b, c, d, wa, wb, wc, wd = load(planes, at, i, 0)
        fl, fr, tl, tr = events(a, b, a | wa, b | wb, c | wc, d | wd)
        from_a, from_b, to_c, to_d = leaving(fl, fr, tl, tr)
        store(planes, (at.a, at.b, at.c, at.d), i, (a ^ from_a, b ^ from_b, c ^ to_c, d ^ to_d), 0)
        a, b, c, d = load(planes, low, i, 8)
        store(planes, (low.c, low.d), i, moved_along(a, b, c, d, from_a, from_b, to_c, to_d), 10)
        a, b, c, d = load(planes, middle, i, 12)
        store(planes, (middle.c, middle.d), i, moved_along(a, b, c, d, from_a, from_b, to_c, to_d), 14)
        a, b, c, d = load(planes, high, i, 16)
        store(planes, (high.c, high.d), i, moved_along(a, b, c, d, from_a, from_b, to_c, to_d), 18)
        moved += np.uint64((from_a | from_b) != _ZERO)
    return moved


@gate
def flag_moving(planes, at, size, flags):
    """Flag the words in which a grain can move; return whether there is one."""
    some = _ZERO
    for i in range(size):
        a, b, _, _, oa, ob, oc, od = corner_words(planes, at, i)
        fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
        moving = fl | fr | tl | tr
        flags[i] = moving != _ZERO
        some |= moving
    return some != _ZERO


@gate
def move_word(planes, at, bits, i):
    """Move every grain of word i that can move and its colour, in place."""
    a, b, c, d, oa, ob, oc, od = corner_words(planes, at, i)
    fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
    from_a, from_b, to_c, to_d = leaving(fl, fr, tl, tr)
    put(planes, at, i, a ^ from_a, b ^ from_b, c ^ to_c, d ^ to_d)
    follow(planes, bits[0], i, from_a, from_b, to_c, to_d)
    follow(planes, bits[1], i, from_a, from_b, to_c, to_d)
    follow(planes, bits[2], i, from_a, from_b, to_c, to_d)


@gate
def move_few(planes, at, bits, x, stride, size, flags, flagged):
    """Move the grains that can move and their colours word by word, in place; return in how many words there is one.

    The seams of the sand are open, those of the colours are opened where they are needed.
    """
    if not flag_moving(planes, at, size, flags):
        return _ZERO
    number = list_flagged(flags, size, flagged)
    stride = np.uint64(stride)
    words = stride - _ONE
    for k in range(number):
        i = flagged[k]
        at_seam = x and (i + _ONE) % stride == words
        if at_seam:
            for bit in bits:
                open_seam(planes, bit.b + i, words)
                open_seam(planes, bit.d + i, words)
        move_word(planes, at, bits, i)
        if at_seam:
            for bit in bits:
                close_seam(planes, bit.d + i, words)
    return number


@gate
def at_seams(act, planes, length, stride, even, odd, crowded):
    """Open or close (`act`) the seams of even and of odd rows, (first, end) each.

    They are the sand's and, where it is crowded, the colours' as well.
    """
    for bit in range(1 + DEPTH if crowded else 1):
        start = np.uint64((COLOURS + 4 * (bit - 1) if bit else SAND) * length)
        act(planes, start + np.uint64(even[0] * stride), even[1] - even[0], stride)
        act(planes, start + np.uint64(2 * length + odd[0] * stride), odd[1] - odd[0], stride)


@gate
def move_band(planes, shape, band, offsets, first, last, crowded, flags, flagged):
    """Run the iterations from `first` to before `last`, whose blocks start in the same column, on a band, in place.

    Return the last of them in which something stirred, or first - 1, and the most words that moved in one.
    """
    length, rows, stride, band_rows = shape
    row, end = band * band_rows, min(rows, (band + 1) * band_rows)
    x, first_y = offsets[first % len(offsets)]
    last_y = offsets[(last - 1) % len(offsets)][1]
    even, odd = (row + last_y, min(end + first_y, rows)), (row, min(end, rows - last_y))
    if x:
        at_seams(open_seams, planes, length, stride, even, odd, crowded)
    stirred, most = first - 1, _ZERO
    for t in range(first, last):
        y = offsets[t % len(offsets)][1]
        at = corners(length, stride, x, y, row * stride)
        bits, size = bits_of_colours(at, length), np.uint64((min(end, rows - y) - row) * stride)
        if crowded:
            moved = move_all(planes, at, bits, size)
        else:
            moved = move_few(planes, at, bits, x, stride, size, flags, flagged)
        if moved:
            stirred = t
        most = max(most, moved)
    if x and most:
        at_seams(close_seams, planes, length, stride, even, odd, crowded)
    return stirred, most


@gate
def plan_steps(steps, offsets, iterations):
    """Write where steps of one or two iterations start, from steps[0] on, and where the last ends; return how many."""
    number, t = 0, steps[0]
    while number < len(steps) - 1 and t < iterations:
        x, y = offsets[t % len(offsets)]
        next_x, next_y = offsets[(t + 1) % len(offsets)]
        t += 2 if t + 1 < iterations and x == next_x and y > next_y else 1
        number += 1
        steps[number] = t
    return number


@kernel
def advance_together(planes, shape, quiet, busy, changed, stamp, offsets, iterations):
    """Run a batch of iterations in place, every event certain and every grain coloured; compare `advance_planes`.

    busy: for each band, in how many words a grain moved when it last ran; it decides how the band is worked off.
    """
    _, _, stride, band_rows = shape
    size = -(-band_rows * stride // 8) * 8
    flags, flagged = np.empty(size, np.uint8), np.empty(size + 1, np.uint64)
    steps, bands = np.zeros(max(1, IN_CACHE // (band_rows * stride)) + 1, np.int64), len(quiet)
    while steps[0] < iterations:
        depth = plan_steps(steps, offsets, iterations)
        for front in range(bands + depth - 1):
            for k in range(max(0, front - bands + 1), min(depth, front + 1)):
                band = front - k
                if is_still(quiet, band):
                    continue
                first, last = steps[k], steps[k + 1]
                crowded = busy[band] * CROWD > band_rows * stride
                stirred, busy[band] = move_band(planes, shape, band, offsets, first, last, crowded, flags, flagged)
                if stirred >= first:
                    quiet[band] = last - 1 - stirred
                    changed[band] = stamp
                else:
                    quiet[band] = min(quiet[band] + last - first, CYCLE)
        steps[0] = steps[depth]
