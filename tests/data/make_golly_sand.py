"""Make golly_sand.json by running Golly's own Sand rule: `apt-get install golly`, then `python make_golly_sand.py`.

Golly has no 2x2 blocks; its rule emulates them. Each kind of cell has two states, an odd one for the upper left corner
of a block and an even one for the other three corners. The odd states stand where the blocks of the next generation
begin, so the first generation uses the partition we draw; `cells_of` checks the next one at every kept iteration.
"""

import json
import random
import re
import subprocess
import tempfile
from pathlib import Path

RULE = "Sand-Margolus-emulated"
RULES = "/usr/share/golly/Rules/"  # where the package golly keeps it
OFFSETS = [(0, 0), (1, 1)]  # the schedule `margolus`
KEPT = [1, 2, 3, 4, 8, 16, 32, 48]  # iterations
KINDS = ".o#"  # Golly's air, sand and wood; its fourth kind, a source of sand, is not used
LETTERS = "ABCDEF"  # Golly's states 1 to 6 as its patterns spell them: two for each kind, the odd one first
FILE = Path(__file__).with_name("golly_sand.json")


# --- the worlds: rows of '.' empty, 'o' sand, '#' wall, framed by walls as Golly's plane has no border ---


def every_block():
    """Return each of the 81 blocks once, in 9 rows of 9, framed two walls thick to begin on the first partition."""
    pairs = [left + right for left in KINDS for right in KINDS]
    frame = ["#" * 22] * 2
    blocks = [row for upper in pairs for row in ("##" + upper * 9 + "##", "##" + "".join(pairs) + "##")]
    return frame + blocks + frame


def scatter(width, height, is_wall, sand, rubble, seed):
    """Return the walls in a frame, with these fractions of the other cells filled by sand and by loose walls."""
    chance = random.Random(seed)

    def cell(x, y):
        drawn = chance.random()
        if x in (0, width - 1) or y in (0, height - 1) or is_wall(x, y) or drawn < rubble:
            return "#"
        return "o" if drawn < rubble + sand else "."

    return ["".join(cell(x, y) for x in range(width)) for y in range(height)]


def stair(x, y):
    """Tell whether this is part of a thin stair down to the right."""
    return y == 6 + x // 2


def ledge(x, y):
    """Tell whether this is part of a level floor with gaps."""
    return y % 8 == 7 and (x + 3 * y) % 20 > 4


def glass(x, y):
    """Tell whether this is outside an hourglass three cells wide at the neck, 37 x 29 cells in all."""
    return abs(x - 18) > 1 + abs(y - 14)


def pillar(x, y):
    """Tell whether this is part of a pillar; each is a little taller than the one to its left."""
    return x % 5 == 4 and y > 34 - x


def worlds():
    """Return the worlds by name."""
    return {
        "every block": every_block(),
        "stair": scatter(40, 36, stair, sand=0.35, rubble=0.15, seed=3),
        "ledges": scatter(64, 48, ledge, sand=0.5, rubble=0.02, seed=2),
        "hourglass": scatter(37, 29, glass, sand=0.7, rubble=0.0, seed=3),
        "pillars": scatter(33, 40, pillar, sand=0.15, rubble=0.0, seed=4),
    }


# --- Golly's side ---


def is_corner(x, y, iteration):
    """Tell whether a block of this iteration has its upper left corner here."""
    left, top = OFFSETS[iteration % 2]
    return x % 2 == left and y % 2 == top


def pattern_of(cells):
    """Return the cells as Golly's pattern of generation 0."""

    def letter(x, y):
        return LETTERS[2 * KINDS.index(cells[y][x]) + (not is_corner(x, y, 0))]

    width, height = len(cells[0]), len(cells)
    rows = ["".join(letter(x, y) for x in range(width)) for y in range(height)]
    return f"x = {width}, y = {height}, rule = {RULE}\n" + "$\n".join(rows) + "!\n"


def cells_of(pattern, iteration):
    """Return the cells of Golly's pattern, and check that its next partition is that of the iteration."""
    body = "".join(line for line in pattern.splitlines() if not line.startswith(("#", "x")))
    rows = re.sub(r"(\d+)(.)", lambda run: int(run[1]) * run[2], body.rstrip("!")).split("$")
    for y, row in enumerate(rows):
        for x, letter in enumerate(row):
            assert (letter in "ACE") == is_corner(x, y, iteration), f"{letter} at ({x}, {y}), iteration {iteration}"
    return ["".join(KINDS[LETTERS.index(letter) // 2] for letter in row) for row in rows]


def run_golly(cells, generations):
    """Return the cells after so many generations of Golly's rule."""
    with tempfile.TemporaryDirectory() as folder:
        before, after = Path(folder, "before.rle"), Path(folder, "after.rle")
        before.write_text(pattern_of(cells))
        options = ["-a", "RuleLoader", "-s", RULES, "-m", str(generations), "-o", after]
        subprocess.run(["bgolly", *options, before], check=True, capture_output=True)
        found = cells_of(after.read_text(), generations)
    assert [len(row) for row in found] == [len(row) for row in cells], "Golly's pattern has changed its size"
    return found


def golly_version():
    """Return the version that bgolly states of itself on any call."""
    said = subprocess.run(["bgolly", "--help"], capture_output=True, text=True).stdout
    return re.search(r"bgolly (\S+)", said)[1]


def comparison():
    """Return the content of the file; a world's cells are kept by iteration."""
    return {
        "rule": RULE,
        "golly": golly_version(),
        "states": {"empty": [1, 2], "sand": [3, 4], "wall": [5, 6]},
        "schedule": "margolus",
        "first_offset": OFFSETS[0],
        "worlds": {
            name: {"0": cells} | {str(iteration): run_golly(cells, iteration) for iteration in KEPT}
            for name, cells in worlds().items()
        },
    }


if __name__ == "__main__":
    FILE.write_text(json.dumps(comparison(), indent=1) + "\n")
