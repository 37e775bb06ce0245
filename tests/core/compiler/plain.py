"""Any rule's table, one block at a time, and lattices of codes to run it on; shared with nothing in game/core."""

from math import fsum

MASK = 2**64 - 1
GOLDEN, LAYER, FAIR = 0x9E3779B97F4A7C15, 0xD1B54A32D192ED03, 0x8CB92BA72F3D8DD7


def mix(z):
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


class Place:
    """Where a block's random numbers come from."""

    def __init__(self, seed, iteration, row, column, width):
        words = (width + 127) // 128
        self.lane, word = (0, -1) if column == -1 else divmod(column, words)
        key = mix((mix((seed + GOLDEN) & MASK) + iteration * GOLDEN) & MASK)
        self.start = key + (row * (words + 1) + word) * 32 * GOLDEN

    def bit(self, step):
        return mix((self.start + step) & MASK) >> self.lane & 1

    def uniform(self, layer):
        number = 0
        for draw in range(32):
            number = 2 * number + self.bit(draw * GOLDEN + layer * LAYER)
        return number


def lookups(table):
    """Return for each layer {(state, face): [(slot, after), ...]}."""
    found = []
    for layer in table.layers:
        found.append({})
        for claim in layer:
            for at, state in enumerate(claim.states.tolist()):
                outcomes = [(outcome.slot, int(outcome.after[at])) for outcome in claim.outcomes]
                for face in (0, 1) if claim.face is None else (claim.face,):
                    found[-1][state, face] = outcomes
    return found


def block_after(layers, probabilities, state, place):
    """Return the state of a block after an iteration."""
    for number, claims in enumerate(layers):
        if (state, 0) not in claims and (state, 1) not in claims:
            continue
        outcomes = claims.get((state, place.bit(FAIR)), [])
        uniform = place.uniform(number)
        for last in range(len(outcomes)):
            slots = [slot for slot, _ in outcomes[: last + 1]]
            total = 1.0 if -1 in slots else fsum(probabilities[slot] for slot in slots)
            if uniform < min(2**32, round(2**32 * total)):
                return outcomes[last][1]
    return state


def step(table, layers, probabilities, cells, offset, seed, iteration):
    """Return the cells, a list of rows of codes, after an iteration of the partition at `offset` (x, y)."""
    height, width, bits = len(cells), len(cells[0]), table.bits
    after = [list(row) for row in cells]
    for y in range(-offset[1], height, 2):
        for x in range(-offset[0], width, 2):
            corners = [(y, x), (y, x + 1), (y + 1, x), (y + 1, x + 1)]
            codes = [cells[r][c] if 0 <= r < height and 0 <= c < width else table.outside for r, c in corners]
            state = sum(code << (bits * corner) for corner, code in enumerate(codes))
            new = block_after(layers, probabilities, state, Place(seed, iteration, y // 2, x // 2, width))
            for corner, (r, c) in enumerate(corners):
                if 0 <= r < height and 0 <= c < width:
                    after[r][c] = new >> (bits * corner) & (2**bits - 1)
                else:
                    assert new >> (bits * corner) & (2**bits - 1) == table.outside
    return after
