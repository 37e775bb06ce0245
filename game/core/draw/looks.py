"""Looks: what a cell looks like, by what it is and what lies around it, worked out for 64 cells at a time.

What is around that matters depends on what a cell holds: light falls on powders and liquids that nothing covers, and
on solids from above and from the left; beside solids there is shadow.
"""

from typing import NamedTuple

import numpy as np

from game.core.compiler.word_pass import FULL

MOST_LOOKS = 64  # six bits
# What there is to look like. A surface has nothing on it, and lies on what is under it; a rim has no solid above or at
# its left, an edge none below or at its right; a glass has an inside, in which it gleams, wooden caps, and posts.
AIR, AIR_BY_WALL, INSIDE, INSIDE_BY_WALL, GLEAM, POST = range(6)
WOOD, WOOD_RIM, WOOD_EDGE = range(6, 9)
GRAIN, SURFACE, UNDER, GRAIN_BY_WALL = range(9, 13)
WALL, RIM, EDGE = range(13, 16)
LIQUID, LIQUID_SURFACE = range(16, 18)
GAS, GAS_INSIDE = range(18, 20)
SHAPES = {  # of what is of each class
    "powder": (GRAIN, SURFACE, UNDER, GRAIN_BY_WALL),
    "liquid": (LIQUID, LIQUID_SURFACE),
    "gas": (GAS, GAS_INSIDE),
    "solid": (WALL, RIM, EDGE),
}
FALLING = "powder", "liquid"
DENSE = "powder", "liquid", "solid"  # what light does not pass through
DYES = 8  # colours of sand, where it has any
DYED_SAND = 32  # the first look of sand with a colour: GRAIN in each colour, then SURFACE in each, and so on


class Substance(NamedTuple):
    """What cells with some codes hold, all of which look alike."""

    kind: str  # "powder", "liquid", "gas" or "solid"
    codes: tuple
    colour: tuple | None = None  # RGB in 0 … 255; None: that of the theme's sand or walls
    glows: bool = False  # it lights up what is near
    translucent: bool = False  # what is behind it shows faintly, as with every gas


class Substances(NamedTuple):
    """What the cells of a world can hold beside air, whose code is 0."""

    all: tuple  # of Substance, by their first code
    bits: int = 2  # of a code
    outside: int = 2  # the code of walls


class Look(NamedTuple):
    """One way to look."""

    shape: int
    substance: Substance | None = None


SAND = Substances((Substance("powder", (1,)), Substance("solid", (2,))))


class Around(NamedTuple):
    """The bits of the codes of some cells and of those around them: lists of words, the lowest bit first."""

    own: list
    above: list
    above_that: list
    below: list
    left: list
    right: list


def looks_of(substances):
    """Return the Looks of a world, by number. In worlds of sand a look's number is its shape."""
    own = [Look(shape, each) for each in substances.all for shape in SHAPES[each.kind]]
    looks = [*map(Look, range(GRAIN)), *own]
    return looks if len(looks) <= MOST_LOOKS else [Look(AIR), Look(AIR_BY_WALL), *own]


def has_glass(substances):
    """Return whether there is room among the looks of a world for those of a glass."""
    return Look(INSIDE) in looks_of(substances)


def sand_of(substances):
    """Return the Substance that may have colours, the theme's sand, if there is one and room for its looks."""
    if len(looks_of(substances)) > DYED_SAND:
        return None
    return next((each for each in substances.all if each.kind == "powder" and each.colour is None), None)


def dyed(look):
    """Return the looks of sand in each colour, in a world with colours, by its shape: DYES numbers."""
    return np.arange(DYES) + DYED_SAND + DYES * (look - GRAIN)


def look_bits(substances, around, decor=(), colours=()):
    """Return the six bits of looks, or as many as they need, the lowest first.

    decor: the two bits of `core.draw.glass_decor`, or none. colours: the three bits of sand's colours, or none.
    """
    looks, masks = looks_of(substances), _masks(substances, around, decor)
    sand = sand_of(substances) if colours else None
    dyed_looks = SHAPES["powder"] if sand else ()
    bits = []
    for bit in range(6 if sand else (len(looks) - 1).bit_length()):
        found = [
            masks[look]
            for number, look in enumerate(looks)
            if look in masks and number >> bit & 1 and not (sand and look.substance == sand)
        ]
        if sand and bit < len(colours):
            found.append(_among(around.own, sand.codes, substances) & colours[bit])
        elif sand:
            place = DYES.bit_length() - 1
            numbers = [DYED_SAND // DYES + shape - GRAIN for shape in dyed_looks]
            found += [
                masks[Look(shape, sand)]
                for shape, number in zip(dyed_looks, numbers, strict=True)
                if number >> (bit - place) & 1
            ]
        bits.append(_any(found))
    return bits


def counted(substances, around, decor=(), colours=()):
    """Return where there are cells of each sort that is counted where a pixel holds many, see `counted_looks`."""
    air, lit = _among(around.own, (0,), substances), ~_is(DENSE, around.above, substances)
    sorts = []
    for each in substances.all:
        sorts.append(_among(around.own, each.codes, substances))
        if each.kind in FALLING:
            sorts.append(sorts[-1] & lit)
    if decor:
        first, second = decor
        wood = _among(around.own, (substances.outside,), substances) & first
        sorts += [wood, air & first & ~second, air & second & ~first, air & first & second]
    sand = sand_of(substances)
    if colours and sand:
        grains = _among(around.own, sand.codes, substances)
        for dye in range(1, DYES):
            digits = (each if dye >> bit & 1 else ~each for bit, each in enumerate(colours))
            sorts.append(_all([grains, *digits]))
    return sorts


def counted_looks(substances):
    """Return the sorts of cells that are counted, as pairs of (look, what it replaces): always, with decor, in colours.

    The looks are Looks, those of sand in a colour numbers.
    """
    always, sand = [], sand_of(substances)
    for each in substances.all:
        looks = [Look(shape, each) for shape in SHAPES[each.kind]]
        always.append((looks[0], Look(AIR)))
        if each.kind in FALLING:
            always.append((looks[1], looks[0]))
    wall = next(each for each in substances.all if substances.outside in each.codes)
    decor = [(Look(WOOD), Look(WALL, wall)), *((Look(shape), Look(AIR)) for shape in (INSIDE, GLEAM, POST))]
    grains = dyed(GRAIN)
    return always, decor, [(each, grains[0]) for each in grains[1:]] if sand else []


def falling_substances(substances):
    """Return the Substances that fall."""
    return [each for each in substances.all if each.kind in FALLING]


def falling(substances, own):
    """Return where there is something that falls, and where it could."""
    return _is(FALLING, own, substances), ~_is(("solid",), own, substances)


def walls_of(substances, own):
    """Return where there is what is outside the lattice."""
    return _among(own, (substances.outside,), substances)


def _masks(substances, around, decor):
    """Return {Look: where cells look so}."""
    left, right, above, below = (
        _is(("solid",), bits, substances) for bits in (around.left, around.right, around.above, around.below)
    )
    covered = _is(DENSE, around.above, substances)
    beside = left | right | above
    masks = _background(_among(around.own, (0,), substances), beside | below, decor)
    rim = ~(left & above)
    edge = ~(rim | (right & below))
    for each in substances.all:
        own, shapes = _among(around.own, each.codes, substances), SHAPES[each.kind]
        if each.kind == "powder":
            top = _is(("powder",), around.above, substances)
            lower = top & ~_is(DENSE, around.above_that, substances) & ~beside
            parts = covered & ~beside & ~lower, ~covered, lower, covered & beside
        elif each.kind == "liquid":
            parts = covered, ~covered
        elif each.kind == "gas":
            inside = decor[0] & ~decor[1] if decor else None
            parts = (~inside, inside) if decor else (FULL,)
        else:
            parts = ~(rim | edge), rim, edge
        masks |= {Look(shape, each): own & part for shape, part in zip(shapes, parts, strict=False)}
        if decor and substances.outside in each.codes:
            wood = _among(around.own, (substances.outside,), substances) & decor[0]
            masks |= {Look(shape): wood & part for shape, part in zip((WOOD, WOOD_RIM, WOOD_EDGE), parts, strict=True)}
            for shape in shapes:
                masks[Look(shape, each)] &= ~wood
    return masks


def _background(air, near, decor):
    if not decor:
        return {Look(AIR): air & ~near, Look(AIR_BY_WALL): air & near}
    first, second = decor
    free, inside = air & ~second & ~first, air & ~second & first
    return {
        Look(AIR): free & ~near,
        Look(AIR_BY_WALL): free & near,
        Look(INSIDE): inside & ~near,
        Look(INSIDE_BY_WALL): inside & near,
        Look(GLEAM): air & second & ~first,
        Look(POST): air & second & first,
    }


def _is(kinds, bits, substances):
    """Return where codes are those of substances of some kinds."""
    return _among(bits, [code for each in substances.all if each.kind in kinds for code in each.codes], substances)


def _among(bits, codes, substances):
    """Return where the codes are among some; others than those of the substances and of air never occur."""
    used = {0, *(code for each in substances.all for code in each.codes)}
    return _decided(list(bits), set(codes), used - set(codes))


def _decided(bits, wanted, unwanted):
    """Return where codes are `wanted`, as a word or 0 or FULL, from the highest bit down."""
    if not wanted or not unwanted:
        return FULL if wanted else 0
    *rest, bit = bits
    one = 1 << len(rest)
    low, high = (
        [{code & (one - 1) for code in codes if bool(code & one) == is_high} for codes in (wanted, unwanted)]
        for is_high in (False, True)
    )
    if not any(high):
        return _decided(rest, *low)
    if not any(low):
        return _decided(rest, *high)
    low, high = _decided(rest, *low), _decided(rest, *high)
    parts = []
    for word, side in ((low, ~bit), (high, bit)):
        if not isinstance(word, int):
            parts.append(word & side)
        elif word:
            parts.append(side)
    return _any(parts)


def _any(words):
    """Return the or of some words."""
    result = words[0] if words else 0
    for each in words[1:]:
        result = result | each
    return result


def _all(words):
    result = words[0]
    for each in words[1:]:
        result = result & each
    return result
