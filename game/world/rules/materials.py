"""Materials: what a cell can hold, by code, and which of them sinks in which."""

import re
from dataclasses import dataclass

from game.world.files.checked_table import shown
from game.world.sand.material_codes import WALL_NAME
from game.world.sand.parameters import Knob

MOST = 16  # a cell has four bits at most
CLASSES = ("empty", "powder", "liquid", "gas", "solid")
FLUIDS = ("empty", "liquid", "gas")
EVERYTHING = "everything"
DENSITY = Knob("density", 0, -1000, 1000, "", "what is denser sinks")
CHANCE = Knob("chance", 1.0, 0.0, 1.0, "", "how likely it is")

NAME = re.compile(r"[a-z][a-z0-9 -]{0,23}")
_LETTER = re.compile(r"[^\sA-Z?|>\-]")
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}")
_KEYS = ("letter", "class", "density", "colour", "form_of", "glows", "translucent")


@dataclass(frozen=True)
class Material:
    """What a cell can hold."""

    name: str
    letter: str  # in pictures
    kind: str  # one of CLASSES
    density: float
    colour: tuple  # (red, green, blue), 0 … 255
    numbers: tuple  # of (name, probability or the name of a chance): the material's own
    form_of: str | None = None  # the material that it is to the player, if it has no swatch of its own
    glows: bool = False  # it lights up what is near
    translucent: bool = False  # what is behind it shows faintly, as with every gas

    def number(self, name):
        """Return the material's own number of that name, a probability or the name of a chance; 1 if it has none."""
        return dict(self.numbers).get(name, 1.0)


def sinks(upper, lower):
    """Whether a material changes places with one below it: denser, neither is solid, and one of them is a fluid."""
    kinds = upper.kind, lower.kind
    return "solid" not in kinds and any(kind in FLUIDS for kind in kinds) and upper.density > lower.density


def read_materials(section, chances):
    """Return the Materials of the RuleSection [materials] by code; `chances`: the names that their numbers may name."""
    if not 3 <= len(section.values) <= MOST:
        found = f"{len(section.values)} materials"
        wanted = f"3 to {MOST}, as a cell has four bits: first the empty one, {WALL_NAME!r} and another"
        raise section.error("", found, wanted)
    materials = [_read(section, name, chances) for name in section.values]
    _check_letters(section, materials)
    names = [each.name for each in materials]
    if [each.name for each in materials if each.kind == "empty"] != names[:1]:
        raise section.error(names[0], f"class {materials[0].kind!r}", "the one empty material first, and no other")
    if WALL_NAME not in names or materials[names.index(WALL_NAME)].kind != "solid":
        raise section.error(
            WALL_NAME, "none" if WALL_NAME not in names else "another class", f"a solid {WALL_NAME!r}: it is outside"
        )
    for each in materials:
        if each.form_of is not None and each.form_of not in set(names) - {each.name}:
            raise section.error(each.name, f"form_of {each.form_of!r}", f"another of {', '.join(names)}")
    return tuple(materials)


def _read(section, name, chances):
    if not NAME.fullmatch(name) or name in CLASSES or name == EVERYTHING:
        raise section.error(name, "that name", "a small letter, then small letters, digits, spaces or - (no class)")
    values = section.table(name).values

    def value(key, is_good, wanted, default=None):
        found = values.get(key, default)
        if not is_good(found):
            raise section.error(name, f"{key} = {shown(found)}" if key in values else f"no {key}", wanted)
        return found

    def is_text(pattern):
        return lambda found: isinstance(found, str) and pattern.fullmatch(found) is not None

    kind = value("class", CLASSES.__contains__, f"class to be one of {', '.join(CLASSES)}")
    letter = value("letter", is_text(_LETTER), "letter to be one sign, no capital and none of ? | - >")
    colour = value("colour", is_text(_COLOUR), 'colour to be as in "#3b7ddd"')
    fixed = kind in ("empty", "solid")  # these need not tell their density
    density = value("density", _fits(DENSITY), f"density to be {DENSITY.wanted}", 0 if fixed else None)
    form_of = value("form_of", lambda found: found is None or isinstance(found, str), "form_of to be a material")
    glows, translucent = (
        value(name, lambda found: isinstance(found, bool), f"{name} to be true or false", False)
        for name in ("glows", "translucent")
    )
    numbers = []
    for key in values:
        if key not in _KEYS:
            wanted = f"a probability {CHANCE.wanted} or the name of a chance ({', '.join(chances) or 'there is none'})"
            own = value(key, lambda found: found in chances if isinstance(found, str) else _fits(CHANCE)(found), wanted)
            numbers.append((key, own if isinstance(own, str) else float(own)))
    rgb = tuple(int(colour[start : start + 2], 16) for start in (1, 3, 5))
    return Material(name, letter, kind, float(density), rgb, tuple(numbers), form_of, glows, translucent)


def _fits(knob):
    def fits(value):
        try:
            knob.check(value)
        except (ValueError, OverflowError):
            return False
        return True

    return fits


def _check_letters(section, materials):
    first = {}
    for each in materials:
        other = first.setdefault(each.letter, each)
        if other is not each:
            found = f"the letter {each.letter!r}, which is that of {other.name}"
            raise section.error(each.name, found, "a letter of its own")


def read_groups(section, materials):
    """Return {capital: frozenset of codes} of the RuleSection [any]."""
    groups = {}
    for capital, words in section.values.items():
        if not re.fullmatch("[A-Z]", capital):
            raise section.error(capital, "that name", "a capital, A to Z")
        if not isinstance(words, str) or len(words) > 400:
            raise section.error(capital, shown(words), 'names in one text, as in "plant, seed"')
        groups[capital] = frozenset(_codes(section, capital, words, materials))
    return groups


def _codes(section, capital, words, materials):
    chosen = set()
    for word in (part.strip() for part in words.split(",")):
        without = word.startswith("but ")
        named = word.removeprefix("but ").strip()
        codes = {code for code, each in enumerate(materials) if named in (EVERYTHING, each.kind, each.name)}
        if not codes and named not in CLASSES:
            names = ", ".join((EVERYTHING, *CLASSES, *(each.name for each in materials)))
            raise section.error(capital, shown(named), f"one of {names}")
        chosen = chosen - codes if without else chosen | codes
    return chosen
