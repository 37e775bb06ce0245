"""The density: every cell is counted, in its own pixel."""

import numpy as np
import pytest

from game.core.draw.downscaled import LIGHTS, CountPass, shift_edges
from game.core.draw.looks import DYES, SAND
from game.core.planes import DEPTH, layout, pack
from tests.sweeps import sweep

AIR, PLAIN = [7, 11, 13], [[900, 3, 500], [5, 1900, 400], [90, 60, 2000]]  # the light of air, and of each kind
DECOR = [[9, 8, 7], [500, 90, 20], [60, 7, 900], [3, 70, 800]]
DYED = [[30, 8, 7], [50, 9, 20], [90, 7, 100], [300, 70, 80], [-8, 70, 90], [200, -9, 3], [9, 99, -2]]
NO_DECOR = np.zeros((0, 0), np.uint64)
CHANNELS = np.arange(LIGHTS, dtype=np.uint32) // 16 << np.array([[16], [8], [0]], np.uint32)


def edges(generator, side, pixels):
    """Return increasing edges between pixels, at random places of a side."""
    return np.sort(generator.choice(side + 1, pixels + 1, replace=False)).astype(np.int32)


def block_sums(cells, rows, columns):
    """Return the plain twin's count of the cells between edges."""
    sums = np.zeros((cells.shape[0] + 1, cells.shape[1] + 1), np.int64)
    sums[1:, 1:] = cells.cumsum(axis=0).cumsum(axis=1)
    return np.diff(np.diff(sums[rows][:, columns], axis=0), axis=1)


@sweep(
    ("shape", "size"),
    [
        ((1, 1), (1, 1)),
        ((9, 61), (4, 30)),
        ((64, 257), (20, 31)),
        ((300, 128), (1, 1)),
        ((40, 16384), (9, 700)),
        ((60, 3000), (3, 170)),
        ((60, 16381), (2, 1990)),
    ],
    keep=[((64, 257), (20, 31)), ((300, 128), (1, 1)), ((60, 3000), (3, 170))],
)
@sweep("share", [0.0, 0.4, 1.0], keep=[0.4])
@pytest.mark.parametrize(("decorated", "dyed"), [(False, False), (True, True)])
@pytest.mark.parametrize("shifted", [False, True])
def test_a_pixel_mixes_what_numpy_counts_in_its_cells(shape, size, share, decorated, dyed, shifted):
    generator = np.random.default_rng(1)
    walls = generator.random(shape) < 0.2
    sand = (generator.random(shape) < share) & ~walls
    first, second = generator.random((2, *shape)) < 0.5
    colours = generator.integers(0, DYES, shape, np.uint8) if dyed else None
    where, pixels = layout(*shape), np.full((size[0] + 3, size[1] + 4), 5, np.uint32)
    decor = pack(first + 2 * second.view(np.uint8), where) if decorated else NO_DECOR
    rows, columns = edges(generator, shape[0], size[0]), edges(generator, shape[1], size[1])
    if shifted:
        columns = shift_edges((np.arange(size[1] + 1) * shape[1] // size[1]).astype(np.int32), where.words)
    lights = np.array([AIR, *PLAIN, *DECOR * decorated, *DYED * dyed], float)
    counts, cells = CountPass(SAND, where.words, decorated, DEPTH * dyed), sand + 2 * walls.view(np.uint8)
    counts.draw(pack(cells, where, colours), where, decor, columns, rows, lights, CHANNELS, pixels, 1, 2)
    covered = np.zeros_like(sand)
    covered[1:] = (sand | walls)[:-1]
    kinds, air = [sand, sand & ~covered, walls], ~(sand | walls)
    if decorated:
        kinds += [walls & first, air & first & ~second, air & second & ~first, air & first & second]
    if dyed:
        kinds += [sand & (colours == 1 + number) for number in range(DYES - 1)]
    counts = [block_sums(cells, rows, columns).astype(np.float32) for cells in kinds]
    cell = np.float32(1) / (np.diff(rows)[:, None] * np.diff(columns)).astype(np.float32)
    wanted = np.full_like(pixels, 5)
    for channel in range(3):
        light = np.full(size, lights[0, channel] + 0.5, np.float32)
        for kind, count in enumerate(counts):
            light = light + count * cell * np.float32(lights[1 + kind, channel])
        part = CHANNELS[channel][np.clip(light, 0, LIGHTS - 1).astype(int)]
        wanted[1:-2, 2:-2] = part if channel == 0 else wanted[1:-2, 2:-2] | part
    assert len(lights) == 1 + len(kinds) and (pixels == wanted).all()


@pytest.mark.parametrize("side", [16384, 16381, 3000, 257])
@pytest.mark.parametrize("cells", [1.2, 7.9, 8.3, 16.06, 40])
def test_shifted_edges_stay_near_where_they_were(side, cells):
    columns = np.unique(np.append(np.arange(0, side, cells).astype(np.int32), side))
    columns = columns[:-2] if side - columns[-2] < 2 else columns
    moved = shift_edges(columns, layout(1, side).words)
    assert (np.diff(moved) > 0).all() and moved[-1] <= side
    assert abs(moved - columns)[:-1].max() <= max(np.diff(columns).min() / 8, 0)


def test_a_pixel_may_hold_more_rows_than_a_byte_counts():
    rows, columns = np.array([0, 3 * 255 + 2], np.int32), np.array([0, 3], np.int32)
    sand = np.ones((rows[1], 3), bool)
    where, pixels = layout(*sand.shape), np.zeros((1, 1), np.uint32)
    lights = np.array([[0, 0, 0], [4000, 0, 800], [0, 4000, 0], [0, 0, 0]], float)
    counts, cells = CountPass(SAND, where.words, False, 0), sand + 2 * (~sand).view(np.uint8)
    counts.draw(pack(cells, where), where, NO_DECOR, columns, rows, lights, CHANNELS, pixels, 0, 0)
    lit = round(4000 / len(sand))
    assert pixels[0, 0] == CHANNELS[0, 4000] | CHANNELS[1, lit] | CHANNELS[2, 800]
