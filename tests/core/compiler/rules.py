"""Tables of rules made at random from pictures, as a reader of rule files makes them."""

import numpy as np

from game.core.rule_table import CERTAIN, Claim, Outcome, RuleTable, corners, state_of

MIRROR = (1, 0, 3, 2)
NEXT = -1


def random_table(generator, bits, layers=3, events=5):
    """Return a RuleTable with the codes of so many bits, nearly all in use; the last one is outside, and stays."""
    codes = 2**bits - int(generator.integers(0, 2))
    slots = tuple(f"chance {number}" for number in range(6))
    made, number = [], 0
    for _ in range(layers):
        made.append(_layer(generator, bits, codes, len(slots), range(number, number + events)))
        number += events
    return RuleTable(bits, codes, codes - 1, slots, tuple(made))


def _layer(generator, bits, codes, slots, numbers):
    claimed = np.full((2, 2 ** (4 * bits)), -1)
    pictures = []
    for number in numbers:
        classes = [generator.random(codes) < generator.choice([0.2, 0.5, 1.0]) for _ in range(4)]
        sinks = tuple(generator.choice(4, 2, replace=False)) if generator.random() < 0.5 else None
        outcomes = [_outcome(generator, codes, slots, bits) for _ in range(generator.integers(1, 4))]
        for _, change in outcomes:
            for corner, source in enumerate(change):
                if source != corner:  # what is outside does not change
                    classes[corner][codes - 1] = False
        here = [(number, classes, sinks, outcomes), (number, *_mirrored(classes, sinks, outcomes))]
        first = len(pictures)
        pictures += here
        for face in (0, 1):
            for way in (0, 1) if face == 0 else (1, 0):
                states = _matching(*pictures[first + way][1:3], bits, codes)
                states &= claimed[face] < 0
                claimed[face][states] = first + way
    made = []
    for first in range(0, len(pictures), 2):
        for alone in (False, True):
            for way in (0, 1):
                made += _claims(claimed, first + way, pictures[first + way], alone, bits, codes)
    return tuple(made)


def _claims(claimed, at, picture, alone, bits, codes):
    """Yield the claims of a picture: of states it has to itself if `alone`, else of those that a face decides about."""
    both = (claimed[0] == at) & (claimed[1] == at)
    for face in (None,) if alone else (0, 1):
        states = np.flatnonzero(both if face is None else (claimed[face] == at) & ~both).astype(np.uint16)
        outcomes = tuple(Outcome(slot, _after(states, change, bits, codes)) for slot, change in picture[3])
        if len(states):
            yield Claim(picture[0], states, outcomes, face)


def _matching(classes, sinks, bits, codes):
    states = np.arange(2 ** (4 * bits))
    cells = corners(states, bits)
    unused = np.zeros(2**bits - codes, bool)
    here = np.all([np.append(of, unused)[cell] for cell, of in zip(cells, classes, strict=True)], axis=0)
    if sinks:
        here &= cells[sinks[0]] > cells[sinks[1]]
    return here & ~np.all([cell == codes - 1 for cell in cells], axis=0)


def _outcome(generator, codes, slots, bits):
    """Return (slot, change at each corner): where its content comes from, 4 + a code, or NEXT for another code."""
    slot = CERTAIN if generator.random() < 0.2 else int(generator.integers(slots))
    change = list(generator.permutation(4)) if generator.random() < 0.6 else [0, 1, 2, 3]
    if generator.random() < 0.5:
        change[generator.integers(4)] = NEXT if bits == 2 else 4 + int(generator.integers(codes - 1))
    return slot, tuple(int(each) for each in change)


def _mirrored(classes, sinks, outcomes):
    def place(source):
        return MIRROR[source] if 0 <= source < 4 else source

    turned = [(slot, tuple(place(change[MIRROR[corner]]) for corner in range(4))) for slot, change in outcomes]
    sinks = tuple(MIRROR[corner] for corner in sinks) if sinks else None
    return [classes[MIRROR[corner]] for corner in range(4)], sinks, turned


def _after(states, change, bits, codes):
    before = corners(states.astype(np.int64), bits)
    new = []
    for corner, source in enumerate(change):
        code = np.full(len(states), source - 4)
        new.append((before[corner] + 1) % (codes - 1) if source == NEXT else before[source] if source < 4 else code)
    return state_of(new, bits).astype(np.uint16)
