"""Cells as an array of materials, read from characters or from a picture."""

from functools import partial

import numpy as np

from game.world.files.checked_table import shown
from game.world.sand import parameters
from game.world.sand.sand_colours import AMBER, DYED
from game.world.scenes import picture_pixels

EMPTY, SAND, WALL = 0, 1, 2  # a material, as the uint8 in an array of cells; coloured sand has the numbers after them
MATERIALS = {"empty": EMPTY, "sand": SAND, "wall": WALL}
MARKS = ".o#1234567"  # a material's character in `cells`, in the order of the numbers above
COLOURS = (  # a material's colour in a picture; the nearest one counts
    (38, 33, 28),
    DYED[AMBER],
    (120, 140, 150),
    *(rgb for name, rgb in DYED.items() if name != AMBER),
)
SANDS = (SAND, *range(WALL + 1, len(COLOURS)))  # the material that is sand of each colour
MARGIN = 16  # of 255: a pixel further than this from all of these colours in any channel is guessed


def written_cells(table):
    """Return the cells that the text at `cells` spells: '.' empty, 'o' sand, '#' wall, '1' … '7' sand of a colour."""
    text = table.values["cells"]
    if not isinstance(text, str):
        raise table.error("cells", shown(text), 'rows of characters . o # between """')
    rows = text.removesuffix("\n").split("\n")
    for name, count in (("rows", len(rows)), ("columns", len(rows[0]))):
        if not parameters.SIDE.low <= count <= parameters.SIDE.high:
            raise table.error("cells", f"{count} {name}", parameters.SIDE.wanted)
    for number, row in enumerate(rows, 1):
        strange = row.translate(str.maketrans("", "", MARKS))
        if strange:
            place = f"row {number}, column {row.index(strange[0]) + 1}"
            wanted = "only . (empty), o (sand), # (wall), 1 to 7 (sand of a colour)"
            raise table.error("cells", f"{strange[0]!r} in {place}", wanted)
        if len(row) != len(rows[0]):
            raise table.error("cells", f"{len(row)} characters in row {number}", f"{len(rows[0])} as in row 1")
    codes = np.zeros(128, np.uint8)
    codes[[ord(mark) for mark in MARKS]] = range(len(MARKS))
    drawn = np.frombuffer("".join(rows).encode("ascii"), np.uint8)
    return codes[drawn].reshape(len(rows), len(rows[0]))


def painted_cells(table, folder):
    """Return the cells in the picture named at `picture`, a file in `folder`, and how many were guessed.

    See-through pixels are empty.
    """
    name = table.line("picture", "")
    if name in ("", ".", "..") or any(sign in name for sign in "/\\:"):
        raise table.error("picture", shown(name), "the name of a file beside the scene")
    if not (folder / name).is_file():
        raise table.error("picture", f"no file {name!r}", f"a picture in {folder}")
    with picture_pixels.opened(folder / name, partial(table.error, "picture")) as picture:
        return cells_of(picture_pixels.rgba(picture))


def cells_of(pixels):
    """Return the (H, W) uint8 materials of RGBA pixels, and how many of them were guessed."""
    bands = np.array_split(pixels, len(pixels) // 64 + 1)
    guessed = sum(int(guesses(rows).sum()) for rows in bands)
    return np.concatenate([nearest_materials(rows) for rows in bands]), guessed


def guesses(pixels):
    """Return which RGBA pixels are of no material's colour, so that the nearest one is a guess, (H, W) bool."""
    colours = pixels[..., :3].astype(np.int16)
    far = [(np.abs(colours - colour) > MARGIN).any(axis=-1) for colour in COLOURS]
    return np.all(far, axis=0) & (pixels[..., 3] >= 128)


def told_guesses(path, guessed, number):
    """Return what to say of a picture of which so many of its cells were guessed, or None."""
    if not guessed:
        return None
    return f"{path}: found {guessed:,} of {number:,} cells in no colour of sand, wall or air: the nearest was guessed"


def nearest_materials(pixels):
    """Return the material of each RGBA pixel: the one whose colour is nearest; what is see-through is empty."""
    colours = pixels[..., :3].astype(np.int32)
    distances = [((colours - colour) ** 2).sum(axis=-1) for colour in COLOURS]
    materials = np.argmin(distances, axis=0).astype(np.uint8)
    materials[pixels[..., 3] < 128] = EMPTY
    return materials


def parted(cells):
    """Return sand and walls, (H, W) bool, and the colours of the sand, (H, W) uint8 or None, none of them writable."""
    walls = cells == WALL
    sand, colours = (cells != EMPTY) & ~walls, None
    if (cells > WALL).any():
        numbers = np.zeros(len(COLOURS), np.uint8)
        numbers[list(SANDS)] = range(len(SANDS))
        colours = numbers[cells]
        colours.flags.writeable = False
    sand.flags.writeable = walls.flags.writeable = False
    return sand, walls, colours


def joined(sand, walls, colours=None):
    """Return the (H, W) uint8 materials of cells: what `parted` takes apart."""
    sands = SAND if colours is None else np.array(SANDS, np.uint8)[colours]
    return np.where(walls, WALL, np.where(sand, sands, EMPTY)).astype(np.uint8)


def resampled(cells, height, width):
    """Return `cells` on a lattice of another size: each cell takes the material at its centre."""
    if cells.shape == (height, width):
        return cells
    rows = ((np.arange(height) + 0.5) * (cells.shape[0] / height)).astype(np.intp)
    columns = ((np.arange(width) + 0.5) * (cells.shape[1] / width)).astype(np.intp)
    return cells[rows][:, columns]
