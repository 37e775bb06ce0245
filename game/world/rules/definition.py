"""The definition of a rule: all that a rule file says, with the files that it includes."""

import os
import re
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, lru_cache
from pathlib import Path
from weakref import WeakValueDictionary

from game.world.files.checked_table import shown
from game.world.files.paths import asset
from game.world.rules import events
from game.world.rules.block_states import compiled, slots_of
from game.world.rules.events import OwnNumber, Signs, read_event
from game.world.rules.laws import check
from game.world.rules.materials import CHANCE, read_groups, read_materials
from game.world.rules.rule_text import RuleError, RuleText
from game.world.sand.material_codes import MaterialCodes
from game.world.sand.parameters import Knob
from game.world.sand.schedules import SCHEDULES

MOST_CHANCES = 48
MOST_BOOKS = 16
MOST_LAYERS = 4
MOST_INCLUDES = 4
TABLES_KEPT = 128  # of rules that were played or read, so that what leads back to one need not compile it anew
LAYERS = ("motion",)  # of a file that names none

_KEYS = ("title", "notice", "schedule", "layers", "include", "materials", "any", "chances", "conserve", "event")
_INCLUDED = ("layers", "any", "chances", "event")  # keys of a file that is included
_known = WeakValueDictionary()  # (name, texts, paths): a definition in use; a file read again is not compiled again
RESERVED = (  # names that no chance can have, as a rule has them
    *("as_dict", "bias", "chances", "codes", "definition", "digest", "events_of", "happening", "is_sand", "leaning"),
    *("leans", "materials", "name", "number", "offsets", "outcomes", "p", "probabilities", "rule", "schedule"),
    *("table", "texts", "toppling", "values", "with_chances", "with_p", "with_schedule"),
)
_NAME = re.compile(r"[a-z][a-z0-9_]{0,23}")


@dataclass(frozen=True)
class Book:
    """A number of cells that only the events named may change."""

    words: str  # as in 'lava + stone'
    codes: frozenset  # of the materials that are added up
    but: tuple  # names of events
    line: str  # FILE:LINE, for messages


@dataclass(frozen=True)
class Definition:
    """What a rule file says. Two are equal if their files' texts are."""

    name: str
    texts: tuple  # of the file and of those that it includes
    title: str = field(compare=False)
    notice: str = field(compare=False)  # what to look out for, in one sentence
    schedule: str = field(compare=False)  # the usual one
    materials: tuple = field(compare=False)  # of Material, by code
    chances: tuple = field(compare=False)  # of Knob
    layers: tuple = field(compare=False)  # names, in the order in which they are tried
    events: tuple = field(compare=False)  # of Event, in the order in which they are tried
    books: tuple = field(compare=False)  # of Book
    paths: tuple = field(compare=False, default=())  # of the files that it was read from, if it was
    turned: tuple = ()  # the own numbers that are chances here, as in ("water.spread",)
    _plain: "Definition | None" = field(compare=False, default=None, repr=False)

    @property
    def source(self):
        """What the files say, whichever numbers are turned."""
        return self.name, self.texts

    @cached_property
    def own_numbers(self):
        """The materials' own numbers, as {"water.spread": 0.9}: all that events ask for and no chance stands for."""
        asked = dict.fromkeys(
            (code, chance.name)
            for event in self.told_events()
            for chance in event.chances
            if isinstance(chance, OwnNumber)
            for code in sorted(event.codes[chance.sign])
        )
        found = {}
        for code, name in sorted(asked, key=lambda each: each[0]):
            value = self.materials[code].number(name)
            if isinstance(value, float):
                found[f"{self.materials[code].name}.{name}"] = value
        return found

    def with_turned(self, names):
        """Return the definition in which these own numbers, and no others, are chances with the same names."""
        names = tuple(name for name in self.plain.own_numbers if name in names)
        return self if names == self.turned else _with_turned(self.plain, names) if names else self.plain

    @property
    def plain(self):
        """The definition in which no own number is a chance."""
        return self if self._plain is None else self._plain

    @cached_property
    def table(self):
        """What every block state does: a RuleTable, one for all definitions that are equal."""
        return _table(self)

    @cached_property
    def slots(self):
        """The Slots of the table."""
        return slots_of(self)

    @property
    def kept(self):
        """The codes of each book that no event may change."""
        return tuple(tuple(sorted(book.codes)) for book in self.books if not book.but)

    @cached_property
    def codes(self):
        """The MaterialCodes of worlds of these materials."""
        names = tuple(each.name for each in self.materials)
        forms = tuple(each.form_of or each.name for each in self.materials)
        return MaterialCodes(names, () if forms == names else forms)

    @property
    def usual_values(self):
        """The probability of each slot of the table, as the file gives it."""
        return (*(each.default for each in self.chances), *self.slots.numbers)

    def told_events(self):
        """Return the events layer by layer, without those included that match no block of these materials."""
        happen = {claim.event for layer in self.table.layers for claim in layer}
        told = [each for number, each in enumerate(self.events) if number in happen or not each.included]
        return [each for layer in self.layers for each in told if each.layer == layer]

    def code(self, name):
        """Return the code of the material of that name."""
        return next(code for code, each in enumerate(self.materials) if each.name == name)


@cache
def rule_names():
    """Return the names of the shipped rules: the files that have materials, the sand first."""
    files = asset("rules").glob("*.toml")
    names = sorted(path.stem for path in files if "[materials]" in path.read_text("utf-8", "replace"))
    return tuple(sorted(names, key=lambda name: name != "sand"))


@cache
def rule_title(name):
    """Return the title of a shipped rule, of a damaged one its name; its file is read once, and not compiled."""
    try:
        return RuleText(asset("rules", f"{name}.toml")).root.line("title", name)
    except RuleError:
        return name


def load_definition(name_or_path):
    """Return the Definition of a shipped rule, by name, or of a file (a path, or a name that ends in .toml).

    Raises RuleError, with one line to show, for whatever is wrong in it.
    """
    path = _path(name_or_path)
    return _shipped(path) if path.parent == asset("rules") else _read(path)


def is_shipped(definition):
    """Return whether a definition is that of the shipped rule of its name."""
    return definition.name in rule_names() and definition.source == load_definition(definition.name).source


def read_definition(path):
    """Return the Definition of the file at a path as it is now, were it a shipped one; raise RuleError."""
    return _read(Path(path))


def definition_of_texts(name, texts):
    """Return the Definition that the texts of a rule file and of those that it includes make.

    Raises RuleError for whatever is wrong in them.
    """
    own, *others = (RuleText(Path(f"{name}.toml"), text) for text in texts)
    own.root.allow(_KEYS)
    if len(own.root.names("include", MOST_INCLUDES)) != len(others):
        raise own.root.error("include", f"{len(others)} texts", "one for each name")
    for each in others:
        each.root.allow(_INCLUDED)
    return _known_or_made(name, [own, *others], ())


def _path(name_or_path):
    text = os.fspath(name_or_path)
    if isinstance(name_or_path, os.PathLike) or text.endswith(".toml") or any(sign in text for sign in "/\\"):
        path, known = Path(text), "a rule file"
    else:
        path, known = asset("rules") / f"{text}.toml", "a rule"
    if "\0" in text or not os.path.lexists(path):
        raise RuleError(text or "''", 0, "rule", "no such file", f"{known}, or one of {', '.join(rule_names())}")
    return path


@lru_cache
def _shipped(path):
    return _read(path)


def _read(path):
    own = RuleText(path)
    own.root.allow(_KEYS)
    included = [_included(own, name) for name in own.root.names("include", MOST_INCLUDES)]
    return _known_or_made(path.stem, [own, *included], tuple(each.path for each in (own, *included)))


def _known_or_made(name, texts, paths):
    key = name, tuple(each.text for each in texts), paths
    definition = _known.get(key)
    if definition is None:
        definition = _defined(*key, texts)
        check(definition)
        _known[key] = definition
    return definition


@lru_cache(maxsize=TABLES_KEPT)
def _table(definition):
    return compiled(definition)


@lru_cache(maxsize=32)
def _with_turned(plain, names):
    materials = []
    for each in plain.materials:
        own = {name.partition(".")[2]: name for name in names if name.partition(".")[0] == each.name}
        materials.append(replace(each, numbers=tuple({**dict(each.numbers), **own}.items())))
    knobs = [Knob(name, plain.own_numbers[name], 0.0, 1.0, "", " of ".join(name.split(".")[::-1])) for name in names]
    return replace(plain, materials=tuple(materials), chances=(*plain.chances, *knobs), turned=names, _plain=plain)


def _defined(name, words, paths, texts):
    own = texts[0]
    chances = _chances(texts)
    materials = read_materials(own.section("materials"), [each.name for each in chances])
    layers = next((found for found in map(_layers, texts) if found), LAYERS)
    read = _events(texts, materials, chances, layers)
    _check_numbers_asked(own, materials, read)
    return Definition(
        name=name,
        texts=words,
        title=own.root.line("title", name),
        notice=own.root.line("notice", ""),
        schedule=own.root.choice("schedule", tuple(SCHEDULES), "paper"),
        materials=materials,
        chances=chances,
        layers=layers,
        events=read,
        books=tuple(_book(each, materials, read) for each in own.sections("conserve", MOST_BOOKS)),
        paths=paths,
    )


def _included(own, name):
    """Return the RuleText of an included file: one beside the file, else a shipped one."""
    if not re.fullmatch(r"[a-z0-9-]{1,40}", name):
        raise own.root.error("include", shown(name), "names of rule files without .toml, as in motion")
    places = [folder / f"{name}.toml" for folder in (own.path.parent, asset("rules"))]
    path = next((place for place in places if place.is_file()), None)
    if path is None:
        raise own.root.error("include", shown(name), f"a file {name}.toml beside it, or a shipped one")
    text = RuleText(path)
    text.root.allow(_INCLUDED)
    return text


def _chances(texts):
    """Return the chances of all files as Knobs."""
    knobs = {}
    for text in texts:
        section = text.section("chances")
        for name, value in section.values.items():
            if not _NAME.fullmatch(name) or name in RESERVED or name in knobs:
                found = "it a second time" if name in knobs else "that name"
                raise section.error(name, found, f"small letters, digits and _, not one of {', '.join(RESERVED)}")
            knobs[name] = _knob(section, name, value if isinstance(value, dict) else {"value": value})
    if len(knobs) > MOST_CHANCES:
        raise texts[0].root.error("chances", f"{len(knobs)} of them", f"at most {MOST_CHANCES}")
    return tuple(knobs.values())


def _knob(section, name, given):
    value, label = given.get("value"), given.get("label", name)
    wanted = f'a probability {CHANCE.wanted}, or {{ value = 0.5, label = "what it does" }}'
    if not set(given) <= {"value", "label"} or not isinstance(label, str) or len(label) > 100:
        raise section.error(name, shown(given), wanted)
    try:
        return Knob(name, CHANCE.check(value), 0.0, 1.0, "", label)
    except (ValueError, OverflowError):
        raise section.error(name, shown(value), wanted) from None


def _layers(text):
    layers = text.root.names("layers", MOST_LAYERS)
    if len(set(layers)) != len(layers) or not all(_NAME.fullmatch(each) for each in layers):
        raise text.root.error("layers", shown(list(layers)), "names of small letters, each once")
    return layers


def _events(texts, materials, chances, layers):
    found = {}
    for text in texts:
        groups = read_groups(text.section("any"), materials)
        signs = Signs(materials, groups, tuple(each.name for each in chances), layers)
        for section in text.sections("event", events.MOST):
            event = read_event(section, signs, text is not texts[0])
            if event.name in found:
                raise section.error("name", "it a second time", "a name of its own")
            found[event.name] = event
    if not 1 <= len(found) <= events.MOST:
        raise texts[0].root.error("event", f"{len(found)} events", f"1 to {events.MOST}")
    return tuple(found.values())


def _check_numbers_asked(own, materials, read):
    """Raise RuleError for a material's own number that no event asks for."""
    asked = {each.name for event in read for each in event.chances if isinstance(each, OwnNumber)}
    for material in materials:
        for name, _ in material.numbers:
            if name not in asked:
                wanted = f"a number that an event asks for: {', '.join(sorted(asked)) or 'there is none'}"
                raise own.section("materials").error(material.name, f"{name!r}", wanted)


def _book(section, materials, read):
    section.allow(("sum", "but"))
    words, names = section.line("sum", ""), [each.name for each in materials]
    terms = [term.strip() for term in words.split("+")]
    for term in terms:
        if term not in names or terms.count(term) > 1:
            raise section.error("sum", shown(words), f"materials, each once, as in 'lava + stone': {', '.join(names)}")
    but, known = section.names("but", events.MOST), {each.name for each in read}
    for name in but:
        if name not in known:
            raise section.error("but", shown(name), "names of events")
    line = f"{section.file}:{section.lines.get('', 0)}"
    return Book(words, frozenset(map(names.index, terms)), but, line)
