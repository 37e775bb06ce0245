"""One iteration, and batches of them, on striped planes: a kernel for each kind of rule.

An iteration goes down the lattice band by band. In a band a first pass over all words makes the moves that are certain
and flags words with candidates, blocks whose event is left to chance; a second pass visits only those and draws. Bands
in which nothing can move are left alone.

All planes are one flat array here, and a corner is the place in it where its words start: eight arrays in its stead
made each call five times as dear, since the compiler then has every pair of them checked for overlap.
"""

from typing import NamedTuple

import numpy as np

from game.core.block import events
from game.core.chance import STAGE, iteration_key, random_word, seed_stream
from game.core.grain_colours import (
    Tracks,
    add_tracks,
    bits_of_colours,
    follow_all,
    follow_few,
    leave_tracks,
    many_moved,
)
from game.core.jit import gate, kernel
from game.core.planes import SHIFTED_WALLS, WALLS
from game.core.seam import close_seams, open_seams

BAND = 1024  # words of blocks in a band, about: with less, calls cost more than work; with more, less can be skipped
IN_CACHE = 8192  # words of blocks that bands in flight may have together: with walls 1/2 MiB, for the second cache
CROWD = 16  # where more than one word in so many has candidates, drawing for all words at once is cheaper
NONE_YET = np.int64(0)  # draws made; typed, since numba compiles everything anew for a literal 0
CYCLE = 4  # iterations until every partition of a schedule has had its turn

_ZERO = np.uint64(0)
_ONE, _TWO, _THREE, _SEVEN = np.uint64(1), np.uint64(2), np.uint64(3), np.uint64(7)
_FULL = np.uint64(2**64 - 1)


class Room(NamedTuple):
    """Working memory for the words of one band."""

    flags: np.ndarray  # uint8: the word has candidates; padded to whole groups of eight
    undecided: np.ndarray  # uint64: the candidates of the word that draws so far left undecided
    flagged: np.ndarray  # uint64: the numbers of the flagged words; one more is written behind the last
    tracks: Tracks | None  # where grains went, if they have colours


class Corners(NamedTuple):
    """Where the words at the four corners of the blocks start in the flat planes: sand, then walls."""

    a: np.uint64
    b: np.uint64
    c: np.uint64
    d: np.uint64
    wa: np.uint64
    wb: np.uint64
    wc: np.uint64
    wd: np.uint64


@gate
def corners(length, stride, x, y, first):
    """Return the Corners of the words of blocks from `first` in the partition at (x, y); a plane has `length` words."""
    upper, lower = 2 * y, 2 - 2 * y
    below = first + y * stride
    right_walls_above = SHIFTED_WALLS + y if x else WALLS + upper + 1
    right_walls_below = SHIFTED_WALLS + 1 - y if x else WALLS + lower + 1
    return Corners(
        np.uint64((upper + x) * length + first),
        np.uint64((upper + 1 - x) * length + first + x),
        np.uint64((lower + x) * length + below),
        np.uint64((lower + 1 - x) * length + below + x),
        np.uint64((WALLS + upper + x) * length + first),
        np.uint64(right_walls_above * length + first + x),
        np.uint64((WALLS + lower + x) * length + below),
        np.uint64(right_walls_below * length + below + x),
    )


@gate
def corner_words(planes, at, i):
    """Return word i of sand at the corners a b c d, then of what is occupied there."""
    a, b, c, d = planes[at.a + i], planes[at.b + i], planes[at.c + i], planes[at.d + i]
    return a, b, c, d, a | planes[at.wa + i], b | planes[at.wb + i], c | planes[at.wc + i], d | planes[at.wd + i]


@gate
def put(planes, at, i, a, b, c, d):
    """Write word i of sand at the corners."""
    planes[at.a + i] = a
    planes[at.b + i] = b
    planes[at.c + i] = c
    planes[at.d + i] = d


@gate
def move_certain(planes, at, size):
    """Move every grain that can move, in place; return whether there is any."""
    moved = _ZERO
    for i in range(size):
        a, b, c, d, oa, ob, oc, od = corner_words(planes, at, i)
        fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
        put(planes, at, i, a ^ (fl | tr), b ^ (fr | tl), c ^ (fl | tl), d ^ (fr | tr))
        moved |= fl | fr | tl | tr
    return moved != _ZERO


@gate
def certain_falls(fl, fr, oa, ob, oc, od, seven):
    """Return which falls are not left to chance: all of them, or with `seven` those of lone grains."""
    if seven is None:
        return fl, fr
    return fl & ~(ob | od), fr & ~(oa | oc)


@gate
def fall(planes, at, size, flags, seven, tracks):
    """Make the certain falls, in place, and flag the words with candidates.

    Return whether anything fell and whether a word is flagged. What fell has left no new candidate behind.
    """
    fell, some = _ZERO, _ZERO
    for i in range(size):
        a, b, c, d, oa, ob, oc, od = corner_words(planes, at, i)
        fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
        left, right = certain_falls(fl, fr, oa, ob, oc, od, seven)
        put(planes, at, i, a ^ left, b ^ right, c ^ left, d ^ right)
        if tracks is not None:
            leave_tracks(tracks, i, left, right, left)
        candidates = (fl ^ left) | (fr ^ right) | tl | tr
        flags[i] = candidates != _ZERO
        fell |= left | right
        some |= candidates
    return fell != _ZERO, some != _ZERO


@gate
def list_flagged(flags, size, flagged):
    """Write the numbers of the flagged words to `flagged` and return how many there are.

    In a group with a flag every word is written, and the next one over it unless it was flagged: a branch for each word
    would be foretold wrongly about as often as there is a candidate, which costs more than the whole group.
    """
    groups, count = flags.view(np.uint64), _ZERO
    whole = (size + _SEVEN) >> _THREE
    for i in range(size, whole << _THREE):
        flags[i] = 0
    for group in range(whole):
        if groups[group] != _ZERO:
            first = np.uint64(group) << _THREE
            for lane in range(8):
                i = first + np.uint64(lane)
                flagged[count] = i
                count += np.uint64(flags[i])
    return count


@gate
def kinds_of(fl, fr, tl, tr, oa, ob, oc, od, seven):
    """Return the blocks of each kind of event left to chance, in the order of the rule's probabilities."""
    if seven is None:
        return tl, tr, _ZERO, _ZERO, _ZERO, _ZERO, _ZERO
    pair = (fl & ob & ~od) | (fr & oa & ~oc)
    return tl, tr, pair, fl & ~ob & od, fr & ~oa & oc, fl & ob & od, fr & oa & oc


@gate
def chosen(kinds, masks):
    """Return the blocks whose kind of event has its mask set."""
    topples = (kinds[0] & masks[0]) | (kinds[1] & masks[1])
    low = (kinds[3] & masks[3]) | (kinds[4] & masks[4])
    full = (kinds[5] & masks[5]) | (kinds[6] & masks[6])
    return topples | (kinds[2] & masks[2]) | low | full


@gate
def compare(random, digit, accepted, rest):
    """Compare one more binary digit of uniform numbers with that of p: return who is accepted and who undecided."""
    return accepted | (rest & digit & ~random), rest & ~(random ^ digit)


@gate
def masks_of(row):
    """Return a row of masks as a tuple: values, which no store to the planes can change under the compiler's eyes."""
    return row[0], row[1], row[2], row[3], row[4], row[5], row[6]


@gate
def stage_of(digits, draw):
    """Return the masks of the STAGE draws from `draw` on."""
    return masks_of(digits[draw]), masks_of(digits[draw + 1]), masks_of(digits[draw + 2]), masks_of(digits[draw + 3])


@gate
def draw_stage(stage, kinds, place, draw, key, accepted, rest):
    """Make STAGE draws at once for the candidates `rest`; return who is accepted by now and who undecided."""
    accepted, rest = compare(random_word(key, place, draw), chosen(kinds, stage[0]), accepted, rest)
    accepted, rest = compare(random_word(key, place, draw + _ONE), chosen(kinds, stage[1]), accepted, rest)
    accepted, rest = compare(random_word(key, place, draw + _TWO), chosen(kinds, stage[2]), accepted, rest)
    return compare(random_word(key, place, draw + _THREE), chosen(kinds, stage[3]), accepted, rest)


@gate
def draw_few(planes, at, i, rest, first_draw, place, key, chance, seven, tracks):
    """Decide the candidates `rest` of word i from `first_draw` on, and move those accepted, in place."""
    a, b, c, d, oa, ob, oc, od = corner_words(planes, at, i)
    fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
    kinds = kinds_of(fl, fr, tl, tr, oa, ob, oc, od, seven)
    rest &= fl | fr | tl | tr
    accepted = rest & chosen(kinds, masks_of(chance.always))
    rest &= ~accepted
    draw = first_draw
    while draw < chance.draws and rest != _ZERO:
        stage = stage_of(chance.digits, draw)
        accepted, rest = draw_stage(stage, kinds, place + i, np.uint64(draw), key, accepted, rest)
        draw += STAGE
    fl, fr, tl, tr = fl & accepted, fr & accepted, tl & accepted, tr & accepted
    put(planes, at, i, a ^ (fl | tr), b ^ (fr | tl), c ^ (fl | tl), d ^ (fr | tr))
    if tracks is not None:
        add_tracks(tracks, i, fl | tr, fr | tl, fl | tl)


@gate
def draw_many(planes, at, size, undecided, first_draw, place, key, chance, seven, tracks):
    """Make STAGE draws for the candidates of all words, from `first_draw` on, and move those accepted, in place.

    Return how many words have candidates left over, which are in `undecided`, as those of the stage before are. The
    loop has no branches, so that eight words are worked out at a time.
    """
    fresh = _FULL if first_draw == 0 else _ZERO  # before the first draw all candidates are undecided
    always, stage, left_over = masks_of(chance.always), stage_of(chance.digits, first_draw), _ZERO
    draw = np.uint64(first_draw)
    for i in range(size):
        a, b, c, d, oa, ob, oc, od = corner_words(planes, at, i)
        fl, fr, tl, tr = events(a, b, oa, ob, oc, od)
        kinds = kinds_of(fl, fr, tl, tr, oa, ob, oc, od, seven)
        rest = (fl | fr | tl | tr) & (undecided[i] | fresh)
        accepted = rest & chosen(kinds, always)
        accepted, rest = draw_stage(stage, kinds, place + i, draw, key, accepted, rest & ~accepted)
        fl, fr, tl, tr = fl & accepted, fr & accepted, tl & accepted, tr & accepted
        put(planes, at, i, a ^ (fl | tr), b ^ (fr | tl), c ^ (fl | tl), d ^ (fr | tr))
        if tracks is not None:
            add_tracks(tracks, i, fl | tr, fr | tl, fl | tl)
        undecided[i] = rest
        left_over += np.uint64(rest != _ZERO)
    return left_over


@gate
def move_by_chance(planes, at, size, place, room, key, chance, seven):
    """Move the sand in `size` words of blocks, in place; return whether there was an event, or could have been one."""
    fell, some = fall(planes, at, size, room.flags, seven, room.tracks)
    if not some:
        return fell
    flagged = list_flagged(room.flags, size, room.flagged)
    if flagged * CROWD <= size:
        for k in range(flagged):
            draw_few(planes, at, room.flagged[k], _FULL, NONE_YET, place, key, chance, seven, room.tracks)
        return True
    draw, words = NONE_YET, flagged
    while words * CROWD > size and draw < max(1, chance.draws):  # what is always accepted needs no draw, but a pass
        words = draw_many(planes, at, size, room.undecided, draw, place, key, chance, seven, room.tracks)
        draw += STAGE
    if words and draw < chance.draws:
        for i in range(size):
            if room.undecided[i] != _ZERO:
                draw_few(planes, at, i, room.undecided[i], draw, place, key, chance, seven, room.tracks)
    return True


@gate
def move_colours(planes, at, length, x, rows, stride, listed, tracks):
    """Let the colours of a band follow its sand, in place, if there are any."""
    if tracks is not None:
        bits, size = bits_of_colours(at, length), np.uint64(rows * stride)
        if many_moved(tracks, size):
            follow_all(planes, bits, x, rows, stride, tracks)
        else:
            number = list_flagged(tracks.moved, size, listed)
            follow_few(planes, bits, x, stride, listed, number, tracks)


@gate
def move_band(planes, length, stride, x, y, first_row, rows, room, key, certain, chance, seven):
    """Run one iteration on the `rows` plane rows from `first_row`, in place; return whether anything stirred."""
    first, size = first_row * stride, np.uint64(rows * stride)
    at = corners(length, stride, x, y, first)
    upper, lower = at.b - _ONE, at.d - _ONE
    if x:
        open_seams(planes, upper, rows, stride)
        open_seams(planes, lower, rows, stride)
    stirred = False
    if certain is not None:
        stirred = move_certain(planes, at, size)
    if chance is not None:
        stirred = move_by_chance(planes, at, size, np.uint64(first), room, key, chance, seven)
    if x and stirred:
        close_seams(planes, upper, rows, stride)
        close_seams(planes, lower, rows, stride)
    if stirred:
        move_colours(planes, at, length, x, rows, stride, room.flagged, room.tracks)
    return stirred


@gate
def is_still(quiet, band):
    """Say whether a band and its neighbours were quiet for a whole cycle: then nothing can move in it."""
    above, below = max(band - 1, 0), min(band + 1, len(quiet) - 1)
    return quiet[above] >= CYCLE and quiet[band] >= CYCLE and quiet[below] >= CYCLE


@kernel
def advance_planes(
    planes, shape, quiet, changed, stamp, offsets, seed, iteration, iterations, certain, chance, seven, tracks
):
    """Run a batch of iterations in place.

    planes: all of them, flat. shape: (words in a plane, plane rows, stride, plane rows in a band). quiet, changed: a
    value for each band, see `world.Activity`; what stirs is stamped. offsets: (x, y) of the first iterations, repeated.
    seed, iteration: uint64. The code for what is None is not even compiled: certain, unless every event is; chance, the
    rule's `Chance`, unless one is not; seven, unless falls are left to chance as well as topples; tracks, room for
    those of a band, unless grains have colours. With colours and every event certain, see `advance_together`.

    Iterations are skewed: a band runs through several of them while it is in the cache, each one band further up than
    the one before, since what happens in a band depends on that band and the one below, an iteration earlier.
    """
    length, rows, stride, band_rows = shape
    size = -(-band_rows * stride // 8) * 8
    room = Room(np.empty(size, np.uint8), np.empty(size, np.uint64), np.empty(size + 1, np.uint64), tracks)
    skew = max(1, IN_CACHE // (band_rows * stride))
    stream, bands = seed_stream(seed), len(quiet)
    for start in range(0, iterations, skew):
        depth = min(skew, iterations - start)
        for front in range(bands + depth - 1):
            for k in range(max(0, front - bands + 1), min(depth, front + 1)):
                band = front - k
                if is_still(quiet, band):
                    continue
                t = start + k
                x, y = offsets[t % len(offsets)]
                first_row = band * band_rows
                here = min(band_rows, rows - y - first_row)
                key = iteration_key(stream, iteration + np.uint64(t))
                if move_band(planes, length, stride, x, y, first_row, here, room, key, certain, chance, seven):
                    quiet[band] = 0
                    changed[band] = stamp
                else:
                    quiet[band] = min(quiet[band] + 1, CYCLE)
