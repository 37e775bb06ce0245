"""A rule file read by itself: what its pictures make of one block, and how likely. Shares nothing with the loader.

A block is four letters, its corners a b c d. Every picture is laid on it in all its places until one fits, as
assets/rules/README.md tells.
"""

import tomllib
from functools import cache
from itertools import chain
from typing import NamedTuple

LOOKS = {  # for each way to turn a picture: the corners that its corners a b c d then show
    "as drawn": ("abcd",),
    "mirror": ("abcd", "badc"),
    "turn": ("abcd", "badc", "cdab", "dcba", "bdac", "cadb", "acbd", "dbca"),
}
MIRROR = LOOKS["mirror"][1]
PLACES = {(1, 1): "abcd", (2, 1): ("ab", "cd"), (1, 2): ("ac", "bd"), (2, 2): ("abcd",)}  # by (width, height)
FLUIDS = {"empty", "liquid", "gas"}
ANYTHING = "?"


class Fate(NamedTuple):
    """What may become of a block."""

    outcomes: dict  # {block after: probability}, the block as it is now among them; 1 in all
    events: frozenset  # the names of the events that may have the block to themselves


class PictureRule:
    """A rule file. chances: values of some of its chances, instead of the file's own."""

    def __init__(self, path, chances=None):
        own = _read(path)
        files = [own, *(_read(path.with_name(f"{name}.toml")) for name in own.get("include", ()))]
        self.materials = {each["letter"]: {"name": name, **each} for name, each in own["materials"].items()}
        self.wall = own["materials"]["wall"]["letter"]
        self.layers = next((file["layers"] for file in files if "layers" in file), ["motion"])
        told = dict(chain.from_iterable(file.get("chances", {}).items() for file in files))
        self.chances = {name: each["value"] if isinstance(each, dict) else each for name, each in told.items()}
        self.chances |= chances or {}
        self.events = [_Event(self, each, file.get("any", {})) for file in files for each in file.get("event", ())]
        self.fate = cache(self._fate)

    def _fate(self, block):
        """Return the Fate of a block."""
        found, events = {}, set()
        for fair_bit in (False, True):
            left = 0.5
            for layer in self.layers:
                name, claim = self._claim(layer, block, fair_bit)
                for p, after in claim:
                    found[after] = found.get(after, 0.0) + left * p
                if left and claim:
                    events.add(name)
                left *= 1.0 - sum(p for p, _ in claim)
            found[block] = found.get(block, 0.0) + left
        return Fate({after: p for after, p in found.items() if p > 0.0}, frozenset(events))

    def _claim(self, layer, block, fair_bit):
        """Return (name, outcomes) of the event that has the layer to itself, if any: [(probability, block after)]."""
        claims = ((event.name, event.claim(block, fair_bit)) for event in self.events if event.layer == layer)
        return next((claim for claim in claims if claim[1]), ("", []))


class _Event:
    """An event, and its picture in all places: (before, [after, ...]), each four signs."""

    def __init__(self, rule, told, groups):
        self.rule, self.name = rule, told["name"]
        self.layer = told.get("layer", rule.layers[0])
        self.where = [(words[0], words[2:-2], words[-1]) for words in told.get("where", ())]
        self.chances = told["chance"] if isinstance(told.get("chance"), list) else [told.get("chance", 1.0)]
        self.groups = {capital: self._letters_of(words) for capital, words in groups.items()}
        before, *afters = _grids(told["picture"])
        shape = len(before[0]), len(before)
        ways = told.get("ways", "mirror" if shape == (2, 2) else "turn")
        self.drawn = []
        for look in LOOKS[ways]:
            for place in PLACES[shape]:
                laid = [_turned(_laid(grid, place), look) for grid in (before, *afters)]
                if laid not in self.drawn:
                    self.drawn.append(laid)
        images = [[_turned(block, MIRROR) for block in laid] for laid in self.drawn]
        self.mirrored = [image if image in self.drawn else laid for laid, image in zip(self.drawn, images, strict=True)]

    def _letters_of(self, words):
        """Return the letters that a text such as 'everything, but plant' names."""
        letters = set()
        for word in words.split(", "):
            named = word.removeprefix("but ")
            here = {
                letter
                for letter, each in self.rule.materials.items()
                if named in ("everything", each["class"], each["name"])
            }
            letters = letters - here if word.startswith("but ") else letters | here
        return letters

    def claim(self, block, fair_bit):
        """Return [(probability, block after), ...] if the event claims a block, else nothing."""
        for before, *afters in self.mirrored if fair_bit else self.drawn:
            means = self._means(before, block)
            if means is not None and all(self._relation(means[x], means[y]) == how for x, how, y in self.where):
                return [
                    (self._p(p, means), _filled(after, means, block))
                    for p, after in zip(self.chances, afters, strict=True)
                ]
        return []

    def _means(self, before, block):
        """Return {sign: letter} if four signs fit a block, else None."""
        means = {}
        for sign, letter in zip(before, block, strict=True):
            if sign != ANYTHING and (
                letter not in self.groups.get(sign, sign) or means.setdefault(sign, letter) != letter
            ):
                return None
        return means

    def _relation(self, upper, lower):
        upper, lower = self.rule.materials[upper], self.rule.materials[lower]
        classes = {upper["class"], lower["class"]}
        free = "solid" not in classes and classes & FLUIDS
        return "sinks in" if free and upper.get("density", 0) > lower.get("density", 0) else "rests on"

    def _p(self, chance, means):
        if isinstance(chance, str) and "." in chance:
            sign, number = chance.split(".")
            chance = self.rule.materials[means[sign]].get(number, 1.0)
        return self.rule.chances[chance] if isinstance(chance, str) else chance


def _read(path):
    return tomllib.loads(path.read_text("utf-8"))


def _grids(picture):
    """Return the grids of a picture, before and afters, each a list of rows."""
    rows = [row.replace("->", " ").replace("|", " ").split() for row in picture.strip().split("\n")]
    return [list(grid) for grid in zip(*rows, strict=True)]


def _laid(grid, place):
    """Return the four signs of a grid laid on some corners of a block."""
    signs = dict(zip(place, "".join(grid), strict=True))
    return "".join(signs.get(corner, ANYTHING) for corner in "abcd")


def _turned(block, look):
    return "".join(block["abcd".index(corner)] for corner in look)


def _filled(after, means, block):
    """Return the block that four signs after an event stand for."""
    return "".join(
        letter if sign == ANYTHING else means.get(sign, sign) for sign, letter in zip(after, block, strict=True)
    )
