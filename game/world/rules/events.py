"""Events: what can happen in a block, as a rule file tells it."""

import re
from dataclasses import dataclass

from game.world.files.checked_table import shown
from game.world.rules.materials import CHANCE
from game.world.rules.pictures import WAYS, BlockPicture, BlockPictureError, mirrored_order, placements, read_picture

MOST = 96  # events of a rule, with those included
MOST_CONDITIONS = 8

_KEYS = ("name", "layer", "chance", "where", "ways", "picture")
_CONDITION = re.compile(r"(\S) (sinks in|rests on) (\S)")
_OWN_NUMBER = re.compile(r"([^\s.])\.([a-z][a-z0-9_]*)")


@dataclass(frozen=True)
class Condition:
    """That one material of the picture sinks in another, or rests on it: does not sink."""

    upper: str
    sinks: bool
    lower: str

    @property
    def words(self):
        """The condition as the file spells it."""
        return f"{self.upper} {'sinks in' if self.sinks else 'rests on'} {self.lower}"


@dataclass(frozen=True)
class OwnNumber:
    """A chance that is a number of the material with a sign of the picture, as in M.topple."""

    sign: str
    name: str


@dataclass(frozen=True)
class Event:
    """One of the events of a rule; chances: for each outcome a probability, the name of a chance or an OwnNumber."""

    name: str
    layer: str
    picture: BlockPicture
    ways: str
    where: tuple  # of Condition
    chances: tuple
    codes: dict  # {sign of the picture: frozenset of the codes that it can be}
    line: str  # FILE:LINE, for messages
    included: bool  # from another file, which may tell of classes that the rule has none of

    def orders(self):
        """Return the placements in the order in which they are tried, and in that where the fair bit is set."""
        tried = placements(self.picture, self.ways)
        return tried, mirrored_order(tried)

    def spoken_chance(self, values):
        """Return the chances as words; values: {name of a chance: probability}."""
        return " | ".join(_spoken(each, values) for each in self.chances)


def _spoken(chance, values):
    if isinstance(chance, OwnNumber):
        return f"{chance.sign}.{chance.name}"
    if isinstance(chance, str):
        return f"{chance} {values[chance]:g}"
    return "always" if chance == 1.0 else f"{chance:g}"


@dataclass(frozen=True)
class Signs:
    """What the signs of the pictures in one file mean."""

    materials: tuple
    groups: dict  # {capital: codes}
    chances: tuple  # names
    layers: tuple  # names; an event that names none is in the first

    def codes(self, sign):
        """Return the codes that a sign can be, or None where it means nothing."""
        if sign in self.groups:
            return self.groups[sign]
        return next((frozenset((n,)) for n, each in enumerate(self.materials) if each.letter == sign), None)

    def known(self):
        """Return all signs that mean something, for a message."""
        return ", ".join([*(each.letter for each in self.materials), *sorted(self.groups)])


def read_event(section, signs, included):
    """Return the Event of a RuleSection [[event]]."""
    section.allow(_KEYS)
    name = section.line("name", "")
    if not 1 <= len(name) <= 60:
        raise section.error("name", shown(name) if name else "nothing", "a name of 1 to 60 characters")
    picture = _picture(section)
    codes = _codes(section, signs, picture)
    return Event(
        name=name,
        layer=section.choice("layer", signs.layers, signs.layers[0]),
        picture=picture,
        ways=section.choice("ways", WAYS, "mirror" if picture.shape == (2, 2) else "turn"),
        where=tuple(_condition(section, text, codes) for text in section.names("where", MOST_CONDITIONS)),
        chances=_chances(section, signs, picture, codes),
        codes=codes,
        line=f"{section.file}:{section.lines.get('', 0)}",
        included=included,
    )


def _picture(section):
    text = section.values.get("picture")
    if not isinstance(text, str):
        raise section.error("picture", shown(text) if "picture" in section else "nothing", "a text of cells")
    try:
        return read_picture(text)
    except BlockPictureError as error:
        raise section.error("picture", *error.args) from None


def _codes(section, signs, picture):
    """Return {sign: codes} of all signs in a picture but '?'."""
    found = {}
    for sign in sorted(set("".join("".join(grid) for grid in (picture.before, *picture.afters))) - {"?"}):
        codes = signs.codes(sign)
        if codes is None:
            wanted = f"the letter of a material or of [any]: {signs.known()}"
            raise section.error("picture", repr(sign), wanted)
        found[sign] = codes
    return found


def _condition(section, text, codes):
    match = _CONDITION.fullmatch(text)
    before = "".join(_picture(section).before)
    if match is None or match[1] not in before or match[3] not in before or "?" in (match[1], match[3]):
        raise section.error("where", shown(text), "'X sinks in Y' or 'X rests on Y', with letters of the picture")
    return Condition(match[1], match[2] == "sinks in", match[3])


def _chances(section, signs, picture, codes):
    """Return the chance of each outcome."""
    value = section.values.get("chance", 1.0)
    values = value if isinstance(value, list) else [value]
    if len(values) != len(picture.afters):
        raise section.error("chance", f"{len(values)} of them", f"one for each after picture ({len(picture.afters)})")
    return tuple(_chance(section, signs, picture, each) for each in values)


def _chance(section, signs, picture, value):
    names = ", ".join(signs.chances) or "of which there is none"
    wanted = f"a number {CHANCE.wanted}, a name in [chances] ({names}) or a material's own, as in M.topple"
    if isinstance(value, str):
        own = _OWN_NUMBER.fullmatch(value)
        if own and own[1] in "".join(picture.before) and own[1] != "?":
            return OwnNumber(own[1], own[2])
        if value in signs.chances:
            return value
        raise section.error("chance", shown(value), wanted)
    try:
        return CHANCE.check(value)
    except (ValueError, OverflowError):
        raise section.error("chance", shown(value), wanted) from None
