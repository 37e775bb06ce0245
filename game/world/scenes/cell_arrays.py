"""Cells as an array of numbers, read from characters or from a picture: materials, and sand of each colour."""

from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from game.world.files.checked_table import shown
from game.world.sand import parameters
from game.world.sand.material_codes import EMPTY, SAND, SAND_CODES, WALL, MaterialCodes
from game.world.sand.sand_colours import AMBER, DYED
from game.world.scenes import picture_pixels

MARGIN = 16  # of 255: a pixel further than this from all colours of cells in any channel is guessed


@dataclass(frozen=True)
class CellPalette:
    """What the numbers in an array of cells stand for: the codes of a rule's materials, then the colours of sand."""

    codes: MaterialCodes
    names: tuple  # of the materials, by number, as scene files spell them
    marks: str  # the character of each number in `cells`
    colours: tuple  # the (red, green, blue) of each number in a picture; the nearest one counts

    @property
    def wall(self):
        """The number of walls."""
        return self.codes.wall

    @property
    def sands(self):
        """The number of sand of each colour; empty where sand has none."""
        return (SAND, *range(WALL + 1, len(self.colours))) if self.codes.is_sand else ()

    def number(self, name):
        """Return the number of the material of that name."""
        return self.names.index(name)


SAND_PALETTE = CellPalette(
    SAND_CODES,
    ("empty", "sand", "wall"),
    ".o#1234567",
    ((38, 33, 28), DYED[AMBER], (120, 140, 150), *(rgb for name, rgb in DYED.items() if name != AMBER)),
)


@lru_cache(maxsize=32)
def palette_of(definition):
    """Return the CellPalette of scenes of a rule's Definition: that of sand, or its materials, letters and colours."""
    if definition.codes.is_sand:
        return SAND_PALETTE
    materials = definition.materials
    names = ("empty", *(each.name for each in materials[1:]))
    return CellPalette(
        definition.codes, names, "".join(each.letter for each in materials), tuple(each.colour for each in materials)
    )


def written_cells(table, palette):
    """Return the cells that the text at `cells` spells with the marks of a CellPalette.

    In a scene of sand: '.' empty, 'o' sand, '#' wall, '1' … '7' sand of a colour.
    """
    text = table.values["cells"]
    if not isinstance(text, str):
        raise table.error("cells", shown(text), f'rows of characters {" ".join(palette.marks[:3])} between """')
    rows = text.removesuffix("\n").split("\n")
    for name, count in (("rows", len(rows)), ("columns", len(rows[0]))):
        if not parameters.SIDE.low <= count <= parameters.SIDE.high:
            raise table.error("cells", f"{count} {name}", parameters.SIDE.wanted)
    for number, row in enumerate(rows, 1):
        strange = row.translate(str.maketrans("", "", palette.marks))
        if strange:
            place = f"row {number}, column {row.index(strange[0]) + 1}"
            raise table.error("cells", f"{strange[0]!r} in {place}", f"only {_legend(palette)}")
        if len(row) != len(rows[0]):
            raise table.error("cells", f"{len(row)} characters in row {number}", f"{len(rows[0])} as in row 1")
    points = [ord(mark) for mark in palette.marks]
    numbers = np.zeros(max(points) + 1, np.uint8)
    numbers[points] = range(len(points))
    drawn = np.frombuffer("".join(rows).encode("utf-32-le"), "<u4")
    return numbers[drawn].reshape(len(rows), len(rows[0]))


def _legend(palette):
    named = [f"{mark} ({name})" for mark, name in zip(palette.marks, palette.names, strict=False)]
    return ", ".join([*named, *(["1 to 7 (sand of a colour)"] if palette.sands else [])])


def painted_cells(table, folder, palette):
    """Return the cells in the picture named at `picture`, a file in `folder`, and how many were guessed.

    See-through pixels are empty.
    """
    name = table.line("picture", "")
    if name in ("", ".", "..") or any(sign in name for sign in "/\\:"):
        raise table.error("picture", shown(name), "the name of a file beside the scene")
    if not (folder / name).is_file():
        raise table.error("picture", f"no file {name!r}", f"a picture in {folder}")
    with picture_pixels.opened(folder / name, partial(table.error, "picture")) as picture:
        return cells_of(picture_pixels.rgba(picture), palette)


def cells_of(pixels, palette):
    """Return the (H, W) uint8 numbers of RGBA pixels in a CellPalette, and how many of them were guessed."""
    bands = np.array_split(pixels, len(pixels) // 64 + 1)
    guessed = sum(int(guesses(rows, palette).sum()) for rows in bands)
    return np.concatenate([nearest_cells(rows, palette) for rows in bands]), guessed


def guesses(pixels, palette):
    """Return which RGBA pixels are of no colour of a CellPalette, so that the nearest is a guess, (H, W) bool."""
    colours = pixels[..., :3].astype(np.int16)
    far = [(np.abs(colours - colour) > MARGIN).any(axis=-1) for colour in palette.colours]
    return np.all(far, axis=0) & (pixels[..., 3] >= 128)


def told_guesses(path, guessed, number):
    """Return what to say of a picture of which so many of its cells were guessed, or None."""
    if not guessed:
        return None
    return f"{path}: found {guessed:,} of {number:,} cells in no material's colour: the nearest was guessed"


def nearest_cells(pixels, palette):
    """Return the number of each RGBA pixel: the one whose colour is nearest; what is see-through is empty."""
    colours = pixels[..., :3].astype(np.int32)
    distances = [((colours - colour) ** 2).sum(axis=-1) for colour in palette.colours]
    cells = np.argmin(distances, axis=0).astype(np.uint8)
    cells[pixels[..., 3] < 128] = EMPTY
    return cells


def parted(cells, palette):
    """Return the codes of cells, (H, W) uint8, and the colours of their sand or None; neither can be written to."""
    codes, colours = cells, None
    if palette.sands and (cells > WALL).any():
        numbers = np.zeros(len(palette.colours), np.uint8)
        numbers[list(palette.sands)] = range(len(palette.sands))
        codes, colours = np.where(cells > WALL, np.uint8(SAND), cells), numbers[cells]
        colours.flags.writeable = False
    codes = codes.view()
    codes.flags.writeable = False
    return codes, colours


def joined(codes, colours, palette):
    """Return the (H, W) uint8 numbers of cells: what `parted` takes apart."""
    if colours is None or not palette.sands:
        return codes
    return np.where(codes == SAND, np.array(palette.sands, np.uint8)[colours], codes)


def resampled(cells, height, width):
    """Return `cells` on a lattice of another size: each cell takes the material at its centre."""
    if cells.shape == (height, width):
        return cells
    rows = ((np.arange(height) + 0.5) * (cells.shape[0] / height)).astype(np.intp)
    columns = ((np.arange(width) + 0.5) * (cells.shape[1] / width)).astype(np.intp)
    return cells[rows][:, columns]
