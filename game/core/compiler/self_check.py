"""The self-check: a pass against the table it was made from, on all block states there are."""

import ctypes

import numpy as np

from game.core.chance import DRAWS
from game.core.compiler.effects import EMPTY, effect_of
from game.core.compiler.plan import ALWAYS, CHANCE, thresholds_of
from game.core.compiler.vector_ir import chances_of
from game.core.planes import LINE
from game.core.rule_table import FAIR_STEP, LAYER_STEP, corners

BLOCKS = 2048  # on either face at least, so that each state is drawn for more than once where there are few
NEARLY = 2**32 - 1  # a threshold that nearly all random numbers are below

_WORD = 64
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_MASK = 2**64 - 1


def agrees(address, table, plan, kinds, payload, lanes):
    """Return whether the pass at an address does to all block states what its RuleTable says, for some thresholds."""
    generator = np.random.default_rng(len(table.used_states))
    states, origin, may = _blocks(table.used_states, generator)
    belongings = generator.integers(0, 2**payload, (4, len(states)))
    for bound in _bounds(table, generator):
        found = _run(address, table, chances_of(plan, bound), states, belongings, payload, origin, may)
        if not _same(found, _expected(table, kinds, bound, states, belongings, origin, may)):
            return False
    return True


def _blocks(used, generator):
    """Return (states of blocks, origin of each word of them, which take part), all in words.

    Those that take part have each of the `used` states as often on one face of the fair bit as on the other.
    """
    each = len(used) * -(-BLOCKS // len(used))
    words = -(-2 * each * 9 // 8 // (_WORD * LINE)) * LINE
    origin = generator.integers(0, 2**64, words, np.uint64)
    states, may = generator.choice(used, words * _WORD), np.zeros(words * _WORD, bool)
    faces = _bits(origin, FAIR_STEP)
    for face in (0, 1):
        places = np.flatnonzero(faces == face)[:each]
        states[places], may[places] = np.resize(used, each), True
    return states, origin, may


def _bounds(table, generator):
    """Yield functions of (layer, slots): thresholds at random, then for each outcome those that let it happen."""
    some = {}
    for layer, claims in enumerate(table.layers):
        for slots in sorted({slots for claim in claims for slots in thresholds_of(claim)}, key=len):
            least = some.get((layer, slots[:-1]), 0)
            some[layer, slots] = int(generator.integers(least, NEARLY))
    yield lambda layer, slots: some[layer, slots]
    for layer, claims in enumerate(table.layers):
        for level in range(max((len(claim.outcomes) for claim in claims), default=0)):
            yield lambda at, slots, layer=layer, level=level: NEARLY * (at == layer and len(slots) > level)


def _run(address, table, chances, states, belongings, payload, origin, may):
    """Return (blocks after, belongings after, what the pass returned)."""
    total, words = table.bits + payload, len(origin)
    planes = np.empty((4, total, words), np.uint64)
    for corner, codes in enumerate(corners(states, table.bits)):
        cells = codes | belongings[corner] << table.bits
        for number in range(total):
            planes[corner, number] = np.packbits(cells >> number & 1 == 1, bitorder="little").view(np.uint64)
    at = np.arange(4 * total, dtype=np.int64) * words
    taking = np.packbits(may, bitorder="little").view(np.uint64)
    arrays = [each.ctypes.data for each in (planes, at, taking, origin)]
    call = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_uint64] * 7)(address)
    told = call(*arrays, 0, chances.ctypes.data, words)
    bits = np.unpackbits(planes.view(np.uint8), axis=2, bitorder="little").astype(np.int64)
    codes = [sum(bits[corner, number] << number for number in range(total)) for corner in range(4)]
    after = sum((code & (2**table.bits - 1)) << (table.bits * corner) for corner, code in enumerate(codes))
    return after, np.array([code >> table.bits for code in codes]), told


def _same(found, expected):
    """Return whether what a pass did is what is expected; what belongs to empty cells means nothing."""
    (after, belongings, told), (wanted, wanted_belongings, meant, told_wanted) = found, expected
    return bool((after == wanted).all() and (belongings == wanted_belongings)[meant].all() and told == told_wanted)


def _expected(table, kinds, bound, states, belongings, origin, may):
    """Return (blocks after, belongings after, where those mean something, what a pass returns)."""
    after, kept, stirred, carried = states.copy(), belongings.copy(), False, belongings.any()
    free, face = may.copy(), _bits(origin, FAIR_STEP)
    used, taking = table.used_states, np.flatnonzero(may)
    by_state = taking[np.argsort(states[taking], kind="stable")].reshape(len(used), -1)
    for number, claims in enumerate(table.layers):
        uniform = _uniform(origin, number)
        open_to_all = free.copy()
        for claim in claims:
            blocks = by_state[np.searchsorted(used, claim.states)].ravel()
            blocks = blocks[open_to_all[blocks]]
            stirred |= len(blocks) > 0
            blocks = blocks if claim.face is None else blocks[face[blocks] == claim.face]
            low = 0
            for slots, outcome in zip(thresholds_of(claim), claim.outcomes, strict=True):
                high = {ALWAYS: 2**32, CHANCE: bound(number, slots)}.get(kinds[slots], 0)
                chosen = blocks[(uniform[blocks] >= low) & (uniform[blocks] < high)]
                after[chosen] = outcome.after[np.searchsorted(claim.states, states[chosen])]
                free[chosen] = False
                if carried:
                    sources = effect_of(claim.states, outcome.after, table.bits).sources
                    kept[:, chosen] = belongings[sources, :][:, chosen]
                low = max(low, high)
    meant = np.array(corners(after, table.bits)) != EMPTY
    return after, kept, meant, int(stirred) + 2 * bool((may & ~free).any())


def _uniform(origin, layer):
    """Return the 32-bit uniform number of each block in a layer."""
    drawn = (_bits(origin, layer * LAYER_STEP + draw * int(_GOLDEN)) for draw in range(DRAWS))
    return sum(bits << (DRAWS - 1 - draw) for draw, bits in enumerate(drawn))


def _bits(origin, step):
    """Return the random bits of all blocks that a step from the origin of their words gives: 0 and 1."""
    z = origin + np.uint64(step & _MASK)
    for shift, multiplier in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)):
        z = (z ^ (z >> np.uint64(shift))) * np.uint64(multiplier)
    z ^= z >> np.uint64(31)
    return np.unpackbits(z.view(np.uint8), bitorder="little").astype(np.int64)
