"""Iterations on striped planes, in batches and band by band, by the pass of a rule.

A pass knows blocks; this knows where they are. Bands in which nothing can move are left alone. Outside of the lattice
all cells have one code, and every cell is in a block in every iteration: where blocks start in an odd column, the row
starts with one whose left corners are outside, where they start in an odd row so does the lattice with its upper ones.
"""

from functools import lru_cache

import numpy as np

from game.core.chance import iteration_key, seed_stream
from game.core.jit import gate, numba_kernel
from game.core.loops.calls import call_pass
from game.core.planes import LINE

BAND = 512  # words of blocks in a band, about: with less, calls cost more than work; with more, less can be skipped
IN_CACHE = 65536  # words of planes that bands in flight may have together: 1/2 MiB, for the second cache
CYCLE = 4  # iterations until every partition of a schedule has had its turn

_ZERO, _ONE, _TOP = np.uint64(0), np.uint64(1), np.uint64(63)
_FULL = np.uint64(2**64 - 1)
_STEP = np.uint64(32 * 0x9E3779B97F4A7C15 % 2**64)  # from the draws of a word of blocks to those of the next


@gate
def open_seams(planes, upper, lower, rows, stride, outside):
    """Give the last words of rows of two planes of even columns their right-hand neighbours, in the seams behind them.

    upper, lower: where the first of the rows is in either plane. outside: a word of what is outside.
    """
    last = outside << _TOP
    for row in range(0, rows * stride, stride):
        planes[upper + row + stride - 1] = (planes[upper + row] >> _ONE) | last
        planes[lower + row + stride - 1] = (planes[lower + row] >> _ONE) | last


@gate
def close_seams(planes, upper, lower, rows, stride):
    """Take what the iteration made of the seams back into the rows' first words, whose lowest bit was no seam's."""
    for row in range(0, rows * stride, stride):
        planes[upper + row] = (planes[upper + row + stride - 1] << _ONE) | (planes[upper + row] & _ONE)
        planes[lower + row] = (planes[lower + row + stride - 1] << _ONE) | (planes[lower + row] & _ONE)


@gate
def run_rows(run, planes, length, stride, y, x, upper, lower, rows, row, key, room, at):
    """Run one iteration on rows of blocks, in place; return what the pass does.

    y, x: the partition's offset. upper, lower: the plane rows of the upper and of the lower corners of the first row of
    blocks, which is number `row` of the partition. room: one of `rooms_for`. at: where to note where the planes
    begin, four for each bit; int64.
    """
    address, outside, changing, chances = run
    bits = len(outside)
    above, below = (2 * y) * length + upper * stride, (2 - 2 * y) * length + lower * stride
    for bit in range(bits):
        start = 4 * bit * length
        at[bit] = start + above + x * length - x
        at[bits + bit] = start + above + (1 - x) * length
        at[2 * bits + bit] = start + below + x * length - x
        at[3 * bits + bit] = start + below + (1 - x) * length
        if x and changing[bit]:
            open_seams(planes, at[bits + bit], at[3 * bits + bit], rows, stride, outside[bit])
    place = key + np.uint64(row * stride - x) * _STEP
    told = call_pass(address, planes, at, room[x], room[2], place, chances, rows * stride)
    if x and told:
        for bit in range(bits):
            if changing[bit]:
                close_seams(planes, at[bits + bit], at[3 * bits + bit], rows, stride)
    return told


@gate
def open_lasting_seams(run, planes, length, stride, first, rows):
    """Open the seams of bits that never change in `rows` plane rows from `first`: they stay open for a batch."""
    _, outside, changing, _ = run
    for bit in range(len(outside)):
        if not changing[bit]:
            start = 4 * bit * length + first * stride
            open_seams(planes, start, start + 2 * length, rows, stride, outside[bit])


@lru_cache(maxsize=16)
def rooms_for(rows, stride):
    """Return `may` by x and `origin` as passes want them, for so many rows of blocks and for one: (2, 3, words) uint64.

    They are only to be read. The seam is no block where x is even. Where it is odd the first bit of a row's first word
    is the block that is half outside on the left.
    """
    rooms = np.zeros((2, 3, rows * stride + LINE), np.uint64)
    for room, size in zip(rooms, (rows * stride, stride), strict=True):
        room[:2, :size] = _FULL
        room[0, stride - 1 : size : stride] = 0
        room[1, :size:stride] = 1
        room[2, :size] = np.arange(size, dtype=np.uint64) * _STEP
    return rooms


@gate
def is_still(quiet, band):
    """Say whether a band and its neighbours were quiet for a whole cycle: then nothing can move in it."""
    above, below = max(band - 1, 0), min(band + 1, len(quiet) - 1)
    return quiet[above] >= CYCLE and quiet[band] >= CYCLE and quiet[below] >= CYCLE


def advance_planes(planes, shape, run, edges, bands, stamp, offsets, seed, iteration, iterations):
    """Run a batch of iterations in place.

    planes: all of them, flat: four for each bit of a cell. shape: (words in a plane, plane rows, stride, plane rows in
    a band). run, edges: see `Pass`. bands: `quiet` and `changed`, a value for each band, see `ActiveBands`; what stirs
    is stamped. offsets: (x, y) of the first iterations, repeated. seed, iteration: uint64.
    """
    _, _, stride, band_rows = shape
    rooms, notes = rooms_for(band_rows, stride), np.zeros(4 * len(run[1]) + len(bands[0]), np.int64)
    advance_bands(planes, shape, run, edges, bands, stamp, offsets, seed, iteration, iterations, rooms, notes)


@numba_kernel
def advance_bands(planes, shape, run, edges, bands, stamp, offsets, seed, iteration, iterations, rooms, notes):
    """Run a batch of iterations in place, as `advance_planes` does.

    rooms: see `rooms_for`. notes: zeros; where the planes begin, see `run_rows`, and for each band whether its lasting
    seams are open. Iterations are skewed: a band runs through several of them while it is in the cache, each one band
    further up than the one before, since what happens in a band depends on that band and the one below, an iteration
    earlier.
    """
    length, rows, stride, band_rows = shape
    top, bottom = edges
    quiet, changed = bands
    opened = 4 * len(run[1])
    skew = max(1, IN_CACHE // (opened * band_rows * stride))
    stream = seed_stream(seed)
    for start in range(0, iterations, skew):
        depth = min(skew, iterations - start)
        for front in range(len(quiet) + depth - 1):
            for k in range(max(0, front - len(quiet) + 1), min(depth, front + 1)):
                band = front - k
                if is_still(quiet, band):
                    continue
                t = start + k
                x, y = offsets[t % len(offsets), 0], offsets[t % len(offsets), 1]
                key = iteration_key(stream, iteration + np.uint64(t))
                row = band * band_rows
                here = min(band_rows, rows - row - (0 if bottom else y))
                if x and not notes[opened + band]:
                    open_lasting_seams(run, planes, length, stride, row, min(band_rows + 1, rows - row))
                    notes[opened + band] = True
                upper, lower, number, room, told = row, row + y, row, 0, 0
                for _ in range(2 if top and y and band == 0 else 1):  # a loop: to compile the work twice takes longer
                    if here > 0:
                        own = rooms[room]
                        told |= run_rows(run, planes, length, stride, y, x, upper, lower, here, number, key, own, notes)
                    # then the row of blocks that is half above the lattice
                    upper, lower, number, room, here = rows, 0, -1, 1, 1
                if told:
                    quiet[band] = 0
                    changed[band] = stamp
                else:
                    quiet[band] = min(quiet[band] + 1, CYCLE)
