"""Decor: what stands still in the picture of a glass: its inside, reflections, wooden caps, and posts behind it.

All of it is read off the walls alone. Every row is cut into runs of walls and of what is free; free runs that touch are
one room, and a room that does not reach the border of the lattice is inside of a glass. Wall runs nearly as long as
the longest are caps, and posts stand behind the ends of two caps.
"""

import numpy as np

from game.core.jit import gate, kernel
from game.core.planes import pack, unpack

FREE, INSIDE, GLEAM, POST = range(4)  # of a cell without a wall
WOOD = 1  # of a wall

CAP = 0.6  # of the longest run of walls: what is at least as long is a cap
SHORTEST_CAP = 0.125  # of the width of the lattice
THINNEST_GLASS = 12  # cells: inside of a narrower room nothing gleams
BELLY = 0.62  # of a room's longest run: only runs at least as long gleam
GLEAMS = (0.09, 0.125), (0.885, 0.9)  # where, in parts of a run
POST_GAP, POST_WIDTH = 120, 36  # to a cell of post or of the gap beside it: so many cells of cap


def decor_of(walls, where):
    """Return the decor planes of a lattice's walls, given as four planes: (8, length) uint64, the first bits first."""
    places = places_of(unpack(walls, where).view(np.bool_))
    return pack(places, where._replace(codes=4, outside=FREE))


def places_of(walls):
    """Return what decorates each cell, (H, W) uint8, from (H, W) bool walls; a glass on its side has what it had."""
    places = _decorated(walls)
    if (places == POST).any():
        return places
    lying = np.rot90(_decorated(np.rot90(walls)), -1)
    return np.ascontiguousarray(lying) if (lying == POST).any() else places


def _decorated(walls):
    places = np.zeros(walls.shape, np.uint8)
    decorate(np.ascontiguousarray(walls).view(np.uint8), places)
    return places


@gate
def _root(parents, run):
    while parents[run] != run:
        parents[run] = parents[parents[run]]
        run = parents[run]
    return run


@gate
def _count_runs(walls):
    """Return how many runs there are, of walls and of what is free."""
    number = 0
    for y in range(walls.shape[0]):
        number += 1
        for x in range(1, walls.shape[1]):
            number += walls[y, x] != walls[y, x - 1]
    return number


@gate
def _find_runs(walls, lefts, firsts):
    """Write where each run starts to `lefts`, and which is the first one of each row to `firsts`."""
    height, width = walls.shape
    run = 0
    for y in range(height):
        firsts[y] = run
        for x in range(width):
            if x == 0 or walls[y, x] != walls[y, x - 1]:
                lefts[run] = x
                run += 1
    firsts[height] = run


@gate
def _right(lefts, firsts, y, run, width):
    """Return where a run of row y ends."""
    return lefts[run + 1] if run + 1 < firsts[y + 1] else width


@gate
def _join_rooms(walls, lefts, firsts, parents):
    """Give free runs that touch one root."""
    height, width = walls.shape
    for y in range(1, height):
        above, here = firsts[y - 1], firsts[y]
        while above < firsts[y] and here < firsts[y + 1]:
            end_above, end_here = _right(lefts, firsts, y - 1, above, width), _right(lefts, firsts, y, here, width)
            if not walls[y - 1, lefts[above]] and not walls[y, lefts[here]]:
                parents[_root(parents, here)] = _root(parents, above)
            above += end_above <= end_here
            here += end_here <= end_above


@gate
def _measure(walls, lefts, firsts, parents, is_open, longest):
    """Find which rooms reach the border, and each one's longest run; return the longest run of walls."""
    height, width = walls.shape
    cap = 0
    for y in range(height):
        for run in range(firsts[y], firsts[y + 1]):
            left, right = lefts[run], _right(lefts, firsts, y, run, width)
            if walls[y, left]:
                cap = max(cap, right - left)
                continue
            room = _root(parents, run)
            longest[room] = max(longest[room], right - left)
            if y == 0 or y == height - 1 or left == 0 or right == width:
                is_open[room] = True
    return cap


@gate
def _fill_inside(row, left, right, longest):
    """Mark a run of a room, and where it gleams."""
    size = right - left
    row[left:right] = INSIDE
    if longest >= THINNEST_GLASS and size >= BELLY * longest:
        for start, end in GLEAMS:
            first = left + int(start * size)
            row[first : max(first + 1, left + int(end * size))] = GLEAM


@gate
def _cap_and_posts(walls, places, y, left, right, since):
    """Mark a run as a row of a cap, and what posts end at it; `since`: where the post in a column starts, or -1.

    Posts stand at the ends of a cap's first row, and start where the cap does not cover them any more.
    """
    middle = (left + right) // 2
    is_first = y == 0 or not (walls[y - 1, middle] and places[y - 1, middle] == WOOD)
    gap, thick = max(1, (right - left) // POST_GAP), max(1, (right - left) // POST_WIDTH)
    for x in range(left, right):
        places[y, x] = WOOD
        if since[x] >= 0:
            for above in range(since[x], y):
                if not walls[above, x] and places[above, x] == FREE:
                    places[above, x] = POST
            since[x] = y + 1
        if is_first:
            since[x] = y + 1 if gap <= min(x - left, right - 1 - x) < gap + thick else -1


@kernel
def decorate(walls, places):
    """Write what decorates each cell to `places`, (H, W) uint8 of zeros, from (H, W) uint8 walls."""
    height, width = walls.shape
    number = _count_runs(walls)
    lefts, firsts = np.empty(number, np.int32), np.empty(height + 1, np.int64)
    _find_runs(walls, lefts, firsts)
    parents, is_open = np.empty(number, np.int64), np.zeros(number, np.bool_)
    longest, since = np.zeros(number, np.int32), np.empty(width, np.int64)
    since[:] = -1
    for run in range(number):
        parents[run] = run
    _join_rooms(walls, lefts, firsts, parents)
    cap = max(CAP * _measure(walls, lefts, firsts, parents, is_open, longest), SHORTEST_CAP * width)
    for y in range(height):
        for run in range(firsts[y], firsts[y + 1]):
            left, right = lefts[run], _right(lefts, firsts, y, run, width)
            if walls[y, left]:
                if right - left >= cap:
                    _cap_and_posts(walls, places, y, left, right, since)
            elif not is_open[_root(parents, run)]:
                _fill_inside(places[y], left, right, longest[_root(parents, run)])
