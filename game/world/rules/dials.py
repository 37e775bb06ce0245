"""Dials: all that can be turned in a rule, material by material, each with a picture of what it decides."""

import re
from functools import lru_cache
from typing import NamedTuple

from game.world.rules.events import OwnNumber
from game.world.rules.materials import sinks
from game.world.sand.material_codes import WALL_NAME
from game.world.sand.parameters import Knob


class Dial(NamedTuple):
    """A chance of a rule, or a material's own number, which with_chances takes by the knob's name."""

    knob: Knob
    code: int  # of the material that it is shown with
    label: str
    event: str  # the name of the first event that it decides about
    picture: tuple  # (cells before, cells after), each rows of cells, and a cell the codes that it may hold


@lru_cache(maxsize=16)
def dials_of(definition):
    """Return {code: the Dials of that material}, in the order of the materials, without those that have none."""
    plain = definition.plain
    found = {code: [] for code in range(len(plain.materials))}
    for knob in plain.chances:
        dial = _of_chance(plain, knob)
        if dial:
            found[dial.code].append(dial)
    for name, value in plain.own_numbers.items():
        dial = _of_number(plain, name, value)
        found[dial.code].append(dial)
    return {code: tuple(dials) for code, dials in found.items() if dials}


def _of_chance(told, knob):
    """Return the Dial of a chance, or None if nothing hangs on it."""
    label = _sentence(knob.meaning)
    owner = next((code for code, each in enumerate(told.materials) if knob.name in dict(each.numbers).values()), None)
    own = {name for name, value in told.materials[owner].numbers if value == knob.name} if owner is not None else ()
    for event in told.told_events():
        for outcome, chance in enumerate(event.chances):
            if chance == knob.name:
                code = _spoken_of(told, knob.meaning, event) if owner is None else owner
                return Dial(knob, code, label, event.name, picture_of(told, event, outcome))
            if isinstance(chance, OwnNumber) and chance.name in own:
                return Dial(knob, owner, label, event.name, picture_of(told, event, outcome, {chance.sign: owner}))
    return None


def _of_number(told, name, value):
    """Return the Dial of a material's own number."""
    material, _, number = name.partition(".")
    code = told.code(material)
    event, outcome, sign = next(
        (event, outcome, chance.sign)
        for event in told.told_events()
        for outcome, chance in enumerate(event.chances)
        if isinstance(chance, OwnNumber) and chance.name == number and code in event.codes[chance.sign]
    )
    knob = Knob(name, value, 0.0, 1.0, "", f"{event.name}: {material}")
    return Dial(knob, code, _sentence(number), event.name, picture_of(told, event, outcome, {sign: code}))


def picture_of(told, event, outcome=0, known=None):
    """Return an event's cells before and after an outcome; `known`: {sign: the one code that is meant by it}."""
    codes = {sign: tuple(sorted(each)) for sign, each in event.codes.items()}
    for sign, code in (known or {}).items():
        codes[sign] = (code,)
        for each in event.where:
            if sign in (each.upper, each.lower):
                other = each.lower if sign == each.upper else each.upper
                codes[other] = tuple(
                    its
                    for its in codes[other]
                    if _holds(told, each, *((code, its) if other == each.lower else (its, code)))
                )

    def cells(grid):
        return tuple(tuple(codes.get(sign, ()) for sign in row) for row in grid)

    return cells(event.picture.before), cells(event.picture.afters[outcome])


def _holds(told, condition, upper, lower):
    return sinks(told.materials[upper], told.materials[lower]) == condition.sinks


def _spoken_of(told, words, event):
    """Return the code of the first material that words tell of, or that is drawn in the picture of an event."""
    names = {code: each.name for code, each in enumerate(told.materials) if code and each.name != WALL_NAME}
    said = [(found.start(), code) for code, name in names.items() if (found := _mentioned(name, words))]
    if said:
        return min(said)[1]
    drawn = [code for sign in "".join(event.picture.before) for code in sorted(event.codes.get(sign, ()))]
    return next((code for code in drawn if code in names), min(names))


def _mentioned(name, words):
    return re.search(rf"\b{re.escape(name)}s?\b", words)


def _sentence(words):
    return words[:1].upper() + words[1:].replace("_", " ")
