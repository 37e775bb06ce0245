"""The plain twin of the automaton: one block at a time, readable top to bottom, shared with nothing in game/core.

Cells are a list of rows of characters: '.' empty, 'o' sand, '#' wall. A block's four corners are

    a b      upper left, upper right
    c d      lower left, lower right
"""

SCHEDULES = {
    "margolus": [(0, 0), (1, 1)],
    "paper": [(0, 0), (1, 1), (0, 1), (1, 0)],
    "balanced": [(0, 0), (1, 1), (1, 0), (0, 1)],
}

ALWAYS = "always"  # the event needs no chance


def event(a, b, c, d):
    """Return (cells after, name of the probability) for the one event a block can have, or None."""
    left_falls = a == "o" and c == "."
    right_falls = b == "o" and d == "."
    if left_falls and right_falls:
        return (".", ".", "o", "o"), "fall_pair"
    if left_falls:
        return (".", b, "o", d), {
            (True, True): ALWAYS,
            (False, True): "fall_pair",
            (True, False): "fall_low_left",
            (False, False): "fall_full_left",
        }[b == ".", d == "."]
    if right_falls:
        return (a, ".", c, "o"), {
            (True, True): ALWAYS,
            (False, True): "fall_pair",
            (True, False): "fall_low_right",
            (False, False): "fall_full_right",
        }[a == ".", c == "."]
    if a == "o" and b == "." and d == ".":
        return (".", ".", c, "o"), "topple_right"
    if b == "o" and a == "." and c == ".":
        return (".", ".", "o", d), "topple_left"
    return None


# --- chance: a uniform number for each block, from (seed, iteration, place) alone ---

MASK = 2**64 - 1
GOLDEN = 0x9E3779B97F4A7C15


def mix(z):
    """Return splitmix64's finaliser of z (Steele, Lea & Flood 2014)."""
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def uniform32(seed, iteration, row, column, blocks_across):
    """Return the 32-bit uniform number of block (row, column) of the partition: bit by bit, most significant first."""
    words = -(-blocks_across // 64)  # a row of blocks is dealt out to this many words in turn ...
    lane, word = divmod(column, words)  # ... so this is the block's bit and its word
    if column == -1:  # half outside on the left: the word before the row's first
        lane, word = 0, -1
    place = row * (words + 1) + word
    key = mix((mix((seed + GOLDEN) & MASK) + iteration * GOLDEN) & MASK)
    number = 0
    for draw in range(32):
        bits = mix((key + (place * 32 + draw) * GOLDEN) & MASK)
        number = 2 * number + ((bits >> lane) & 1)
    return number


def step(cells, probabilities, schedule, seed, iteration):
    """Return the cells after one iteration. Every cell is in a block; outside the lattice is wall on all four sides."""
    height, width = len(cells), len(cells[0])
    blocks_across = -(-width // 2)
    left, top = SCHEDULES[schedule][iteration % len(SCHEDULES[schedule])]
    after = [list(row) for row in cells]

    def cell(y, x):
        return cells[y][x] if 0 <= y < height and 0 <= x < width else "#"

    for y in range(-top, height, 2):
        for x in range(-left, width, 2):
            found = event(cell(y, x), cell(y, x + 1), cell(y + 1, x), cell(y + 1, x + 1))
            if found is None:
                continue
            corners, name = found
            if name != ALWAYS:
                threshold = round(probabilities[name] * 2**32)
                if uniform32(seed, iteration, y // 2, x // 2, blocks_across) >= threshold:
                    continue
            for (dy, dx), state in zip(((0, 0), (0, 1), (1, 0), (1, 1)), corners, strict=True):
                if 0 <= y + dy < height and 0 <= x + dx < width:
                    after[y + dy][x + dx] = state
    return after


def run(cells, probabilities, schedule, seed, iterations, start=0):
    """Return the cells after `iterations` iterations, the first of them numbered `start`."""
    for iteration in range(start, start + iterations):
        cells = step(cells, probabilities, schedule, seed, iteration)
    return cells
