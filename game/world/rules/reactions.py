"""Reactions: what a material becomes, alone and with others, as the events of its rule say."""

from collections import Counter
from functools import lru_cache
from typing import NamedTuple

from game.world.rules.dials import picture_of
from game.world.rules.events import OwnNumber

COUNTS = {2: "two", 3: "three", 4: "four"}


class Reaction(NamedTuple):
    """What an event does with a material."""

    event: str  # its name
    layer: str
    chance: float | tuple  # how likely it is in a block; (least, most) where that hangs on what it meets
    words: str  # as in "with lava becomes stone and steam"
    picture: tuple  # see dials.Dial


def reactions(rule, code):
    """Return the Reactions of a material, in the order of the file."""
    found = []
    for event, outcome, cells in _changing(rule.definition.plain):
        mine = next((cell for cell in cells if code in event.codes[cell[0]]), None)
        if mine:
            known = {mine[0]: code}
            words = _told(rule.definition, event, cells, mine, known)
            chance = _chance(rule, event, event.chances[outcome], known)
            picture = picture_of(rule.definition, event, outcome, known)
            found.append(Reaction(event.name, event.layer, chance, words, picture))
    return found


def behaviour(definition, code):
    """Return in words how a material moves, as far as its class and its density say."""
    me, others = definition.materials[code], definition.materials
    if me.kind == "solid":
        return "A solid: it stays where it is."
    told, kinds = definition.codes.told, ("gas",) if me.kind == "gas" else ("liquid",)
    fluids = [(number, each) for number, each in enumerate(others) if each.kind in kinds]
    heavier = dict.fromkeys(told[number] for number, each in fluids if each.density > me.density)
    lighter = dict.fromkeys(told[number] for number, each in fluids if each.density < me.density)
    words = f"A {me.kind} of density {me.density:g}."
    words += f" It sinks in {_listed(lighter)}." if lighter else ""
    return words + (f" It {'rises in' if me.kind == 'gas' else 'floats on'} {_listed(heavier)}." if heavier else "")


@lru_cache(maxsize=8)
def _changing(told):
    """Return (event, outcome, its cells as (sign before, sign after)) for all that does more than move."""
    found = []
    for event in told.told_events():
        for outcome, after in enumerate(event.picture.afters):
            pairs = zip("".join(event.picture.before), "".join(after), strict=True)
            cells = [pair for pair in pairs if _is_involved(told, event, *pair)]
            kinds = (Counter(_kind(told, event, pair[side]) for pair in cells) for side in (0, 1))
            if len({tuple(sorted(each.items())) for each in kinds}) > 1:
                found.append((event, outcome, cells))
    return tuple(found)


def _is_involved(told, event, before, after):
    """Return whether a cell changes, or has to hold one of few materials."""
    return before != "?" and (before != after or 2 * len(event.codes[before]) < len(told.materials))


def _kind(told, event, sign):
    """Return what a sign stands for: a material's name to the player, or the sign itself if it may be several."""
    names = told.codes.told_of(event.codes[sign])
    return names[0] if len(names) == 1 else sign


def _told(told, event, cells, mine, known):
    """Return what becomes of a material with the others, in words."""
    others = [_named(told, event, cell[0], known) for cell in cells if cell is not mine]
    after = Counter(_named(told, event, cell[1], known) for cell in cells)
    air = told.materials[0].name
    left = {name: number for name, number in after.items() if name != air} or {"nothing": 1}
    made = _listed(name if number == 1 else f"{COUNTS[number]} cells of {name}" for name, number in left.items())
    return f"with {_listed(others)} becomes {made}" if others else f"by itself becomes {made}"


def _named(told, event, sign, known):
    return _listed(told.codes.told_of([known[sign]] if sign in known else event.codes[sign]), "or")


def _listed(names, last="and"):
    """Return names as a list in words."""
    *first, end = names
    return f"{', '.join(first)} {last} {end}" if first else end


def _chance(rule, event, chance, known):
    if isinstance(chance, str):
        return rule.chances[chance]
    if not isinstance(chance, OwnNumber):
        return chance
    codes = [known[chance.sign]] if chance.sign in known else sorted(event.codes[chance.sign])
    values = [_own(rule, code, chance.name) for code in codes]
    return values[0] if len(set(values)) == 1 else (min(values), max(values))


def _own(rule, code, name):
    value = rule.definition.materials[code].number(name)
    return rule.chances[value] if isinstance(value, str) else value
