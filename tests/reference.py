"""The plain twin of the automaton: one block at a time, readable top to bottom, shared with nothing in game.

Cells are a list of rows of letters: those of a rule file, for the sand '.' empty, 'o' sand, '#' wall. A block's four
corners are

    a b      upper left, upper right
    c d      lower left, lower right
"""

import math
import re
import tomllib
from functools import cache, lru_cache
from pathlib import Path

SCHEDULES = {
    "margolus": [(0, 0), (1, 1)],
    "paper": [(0, 0), (1, 1), (0, 1), (1, 0)],
    "balanced": [(0, 0), (1, 1), (1, 0), (0, 1)],
}

ALWAYS = "always"  # the event needs no chance


def event(a, b, c, d):
    """Return (cells after, name of the probability) for the one event a block can have, or None."""
    left_falls = a == "o" and c == "."
    right_falls = b == "o" and d == "."
    if left_falls and right_falls:
        return (".", ".", "o", "o"), "fall_pair"
    if left_falls:
        return (".", b, "o", d), {
            (True, True): ALWAYS,
            (False, True): "fall_pair",
            (True, False): "fall_low_left",
            (False, False): "fall_full_left",
        }[b == ".", d == "."]
    if right_falls:
        return (a, ".", c, "o"), {
            (True, True): ALWAYS,
            (False, True): "fall_pair",
            (True, False): "fall_low_right",
            (False, False): "fall_full_right",
        }[a == ".", c == "."]
    if a == "o" and b == "." and d == ".":
        return (".", ".", c, "o"), "topple_right"
    if b == "o" and a == "." and c == ".":
        return (".", ".", "o", d), "topple_left"
    return None


# --- rules of pictures: what may become of a block ---


class Pictures:
    """A rule file: on a block every picture is laid in every way until one fits."""

    def __init__(self, path, **chances):
        self.file = tomllib.loads(Path(path).read_text())
        others = [Path(path).with_name(f"{name}.toml") for name in self.file.get("include", ())]
        files = [self.file, *(tomllib.loads(other.read_text()) for other in others)]
        self.materials = self.file["materials"]
        self.letters = {each["letter"]: name for name, each in self.materials.items()}
        self.outside = self.materials["wall"]["letter"]
        self.layers = next((file["layers"] for file in files if "layers" in file), ["motion"])
        self.chances = {}
        for file in files:
            for name, value in file.get("chances", {}).items():
                self.chances[name] = chances.get(name, value["value"] if isinstance(value, dict) else value)
        self.events = [
            (event, {sign: self._letters(words) for sign, words in file.get("any", {}).items()})
            for file in files
            for event in file.get("event", ())
        ]
        self.laid = [_laid(event) for event, _ in self.events]  # pictures in all their places, drawn once
        self.draws = cache(self.draws)  # of a block once, however often it comes

    def draws(self, block, coin):
        """Return for each layer in which an event claims the block (layer, [(probability, block after), ...])."""
        found = []
        for number, layer in enumerate(self.layers):
            for (event, groups), laid in zip(self.events, self.laid, strict=True):
                claim = None
                if event.get("layer", self.layers[0]) == layer:
                    claim = self._claim(event, groups, laid[coin], block)
                if claim:
                    found.append((number, claim))
                    break
        return found

    def outcomes(self, block):
        """Return {block after: probability}, without the block as it is."""
        found = {}
        for coin in (0, 1):
            left = 0.5
            for _, claim in self.draws(tuple(block), coin):
                for p, after in claim:
                    found[after] = found.get(after, 0.0) + left * p
                left *= 1.0 - sum(p for p, _ in claim)
        return {after: p for after, p in found.items() if after != tuple(block) and p > 0.0}

    def _claim(self, event, groups, laid, block):
        for before, afters in laid:
            meant = self._meant(before, block, groups)
            if meant is not None and all(self._holds(condition, meant) for condition in event.get("where", ())):
                chances = event.get("chance", 1.0)
                chances = chances if isinstance(chances, list) else [chances]
                blocks = [
                    tuple(
                        cell if sign == "?" else meant.get(sign, sign) for sign, cell in zip(after, block, strict=True)
                    )
                    for after in afters
                ]
                return [(self._p(chance, meant), after) for chance, after in zip(chances, blocks, strict=True)]
        return None

    def _meant(self, before, block, groups):
        """Return which letter each sign of a picture stands for in a block, or None where it does not fit."""
        meant = {}
        for sign, cell in zip(before, block, strict=True):
            if sign != "?" and not (cell in groups.get(sign, sign) and meant.setdefault(sign, cell) == cell):
                return None
        return meant

    def _letters(self, words):
        """Return the letters that a sign stands for: those of names and classes, from left to right."""
        found = set()
        for word in words.split(","):
            word, but = word.strip().removeprefix("but ").strip(), word.strip().startswith("but ")
            those = {
                letter
                for letter, name in self.letters.items()
                if word in ("everything", name, self.materials[name]["class"])
            }
            found = found - those if but else found | those
        return found

    def _holds(self, condition, meant):
        upper, words, lower = re.fullmatch(r"(.) (sinks in|rests on) (.)", condition).groups()
        upper, lower = (self.materials[self.letters[meant[sign]]] for sign in (upper, lower))
        classes = upper["class"], lower["class"]
        movable = "solid" not in classes and set(classes) & {"empty", "gas", "liquid"}
        sinks = bool(movable) and upper.get("density", 0) > lower.get("density", 0)
        return sinks == (words == "sinks in")

    def _p(self, chance, meant):
        if isinstance(chance, str) and "." in chance:
            sign, name = chance.split(".")
            chance = self.materials[self.letters[meant[sign]]].get(name, 1.0)
        return self.chances[chance] if isinstance(chance, str) else chance


def _drawn(after, block, meant):
    """Return the block that an after picture makes of a block."""
    return tuple(cell if sign == "?" else meant.get(sign, sign) for sign, cell in zip(after, block, strict=True))


def _laid(event):
    """Return all (block before, blocks after) that an event's picture makes, in two orders: plain and mirrored."""
    rows = [re.sub(r"->|\|", " ", row).split() for row in event["picture"].split("\n") if row.strip()]
    height, width = len(rows), len(rows[0][0])
    tops, lefts = range(3 - height), range(3 - width)
    grids = []  # the picture in its places: a list of blocks, before and afters
    for top in tops:
        for left in lefts:
            blocks = []
            for part in range(len(rows[0])):
                block = [["?", "?"], ["?", "?"]]
                for y in range(height):
                    for x in range(width):
                        block[top + y][left + x] = rows[y][part][x]
                blocks.append(block)
            grids.append(blocks)
    ways = event.get("ways", "mirror" if (height, width) == (2, 2) else "turn")
    plain = []
    for turn in {"as drawn": TURNS[:1], "mirror": TURNS[:2], "turn": TURNS}[ways]:
        for blocks in grids:
            turned = [turn(block) for block in blocks]
            if turned not in plain:
                plain.append(turned)
    images = [[_flip(block) for block in blocks] for blocks in plain]
    mirrored = [image if image in plain else blocks for image, blocks in zip(images, plain, strict=True)]
    return [
        [(_flat(before), [_flat(after) for after in afters]) for before, *afters in each] for each in (plain, mirrored)
    ]


def _flat(block):
    return (*block[0], *block[1])


def _flip(block):
    return [row[::-1] for row in block]


def _clockwise(block):
    return [list(column) for column in zip(*block[::-1], strict=True)]


def _across(block):
    """Return a block with its rows as columns."""
    return [list(column) for column in zip(*block, strict=True)]


TURNS = (
    lambda block: block,
    _flip,
    lambda block: block[::-1],
    lambda block: _clockwise(_clockwise(block)),
    lambda block: _clockwise(_clockwise(_clockwise(block))),
    _clockwise,
    _across,
    lambda block: _clockwise(_clockwise(_across(block))),
)

# --- chance: uniform numbers for each block, from (seed, iteration, place, layer) alone ---

MASK = 2**64 - 1
GOLDEN = 0x9E3779B97F4A7C15
LAYER_STEP = 0xD1B54A32D192ED03
FAIR_STEP = 0x8CB92BA72F3D8DD7


def mix(z):
    """Return splitmix64's finaliser of z (Steele, Lea & Flood 2014)."""
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


@lru_cache(maxsize=4096)
def _key(seed, iteration):
    return mix((mix((seed + GOLDEN) & MASK) + iteration * GOLDEN) & MASK)


@lru_cache(maxsize=65536)
def _word(key, place, draw, step):
    return mix((key + (place * 32 + draw) * GOLDEN + step) & MASK)


def _bit(seed, iteration, row, column, blocks_across, draw, step):
    """Return a random bit of block (row, column) of the partition; -1 is before the first row or column."""
    words = -(-blocks_across // 64)  # a row of blocks is dealt out to this many words in turn ...
    lane, word = divmod(column, words) if column >= 0 else (0, -1)  # ... so this is the block's bit and its word
    place = row * (words + 1) + word
    return (_word(_key(seed, iteration), place, draw, step) >> lane) & 1


def is_below(limit, seed, iteration, row, column, blocks_across, layer=0):
    """Return whether the 32-bit uniform number of a block in a layer is below a limit in 0 … 2^32.

    The number comes bit by bit, most significant first, so the first bit that differs from the limit's decides.
    """
    if limit == 2**32:
        return True
    for draw in range(32):
        wanted = (limit >> (31 - draw)) & 1
        if _bit(seed, iteration, row, column, blocks_across, draw, layer * LAYER_STEP) != wanted:
            return wanted == 1
    return False


def fair_bit(seed, iteration, row, column, blocks_across):
    """Return the bit that decides between a picture and its mirror image, the same in all layers."""
    return _bit(seed, iteration, row, column, blocks_across, 0, FAIR_STEP)


# --- iterations ---


def _outcome_of_sand(block, probabilities, place):
    found = event(*block)
    if found is None:
        return None
    after, name = found
    if name == ALWAYS or is_below(round(probabilities[name] * 2**32), *place):
        return after
    return None


def _outcome_of_pictures(block, pictures, place):
    coin = fair_bit(*place)
    for layer, claim in pictures.draws(tuple(block), coin):
        chances = []
        for p, after in claim:
            chances.append(p)
            if is_below(min(2**32, round(math.fsum(chances) * 2**32)), *place, layer):
                return after
    return None


def step(cells, rule, schedule, seed, iteration):
    """Return the cells after one iteration of a rule: Pictures, or for the sand its probabilities by name.

    Blocks start at the partition's offset or before the first cell. Outside the lattice is wall, on all four sides.
    """
    of_pictures = isinstance(rule, Pictures)
    outside = rule.outside if of_pictures else "#"
    outcome = _outcome_of_pictures if of_pictures else _outcome_of_sand
    height, width = len(cells), len(cells[0])
    left, top = SCHEDULES[schedule][iteration % len(SCHEDULES[schedule])]
    after = [list(row) for row in cells]
    for y in range(-top, height, 2):
        for x in range(-left, width, 2):
            places = [(y, x), (y, x + 1), (y + 1, x), (y + 1, x + 1)]
            inside = [0 <= row < height and 0 <= column < width for row, column in places]
            block = [
                cells[place[0]][place[1]] if is_in else outside for place, is_in in zip(places, inside, strict=True)
            ]
            found = outcome(block, rule, (seed, iteration, y // 2, x // 2, -(-width // 2)))
            for (row, column), is_in, state in zip(places, inside, found or block, strict=True):
                if is_in:
                    after[row][column] = state
    return after


def run(cells, rule, schedule, seed, iterations, start=0):
    """Return the cells after `iterations` iterations, the first of them numbered `start`."""
    for iteration in range(start, start + iterations):
        cells = step(cells, rule, schedule, seed, iteration)
    return cells
