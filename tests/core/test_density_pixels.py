"""The density: every cell is counted, in its own pixel."""

import numpy as np
import pytest

from game.core.density_pixels import DECOR_KINDS, KINDS, LIGHTS, MOST_ROWS, draw_density
from game.core.planes import layout, pack

KIND_LIGHTS = np.array(  # air, then each kind
    [[7, 11, 13], [900, 3, 500], [5, 1900, 400], [90, 60, 2000], [9, 8, 7], [500, 90, 20], [60, 7, 900], [3, 70, 800]],
    float,
)
CHANNELS = np.arange(LIGHTS, dtype=np.uint32) // 16 << np.array([[16], [8], [0]], np.uint32)


def edges(generator, side, pixels):
    """Return increasing edges between pixels, at random places of a side."""
    return np.sort(generator.choice(side + 1, pixels + 1, replace=False)).astype(np.int32)


def block_sums(cells, rows, columns):
    """Return the plain twin's count of the cells between edges."""
    sums = np.zeros((cells.shape[0] + 1, cells.shape[1] + 1), np.int64)
    sums[1:, 1:] = cells.cumsum(axis=0).cumsum(axis=1)
    return np.diff(np.diff(sums[rows][:, columns], axis=0), axis=1)


@pytest.mark.parametrize(
    ("shape", "size"),
    [((1, 1), (1, 1)), ((9, 61), (4, 30)), ((64, 257), (20, 31)), ((300, 128), (1, 1)), ((40, 16384), (9, 700))],
)
@pytest.mark.parametrize("share", [0.0, 0.4, 1.0])
@pytest.mark.parametrize("decorated", [False, True])
def test_a_pixel_mixes_what_numpy_counts_in_its_cells(shape, size, share, decorated):
    generator = np.random.default_rng(1)
    walls = generator.random(shape) < 0.2
    sand = (generator.random(shape) < share) & ~walls
    first, second = generator.random((2, *shape)) < 0.5
    decor = pack(first, second)[:8] if decorated else None
    rows, columns = edges(generator, shape[0], size[0]), edges(generator, shape[1], size[1])
    where, pixels = layout(*shape), np.full((size[0] + 3, size[1] + 4), 5, np.uint32)
    how = columns, rows, KIND_LIGHTS, CHANNELS
    draw_density(pack(sand, walls), decor, where.stride, where.words, *how, pixels, 1, 2)
    covered = np.zeros_like(sand)
    covered[1:] = (sand | walls)[:-1]
    kinds, air = [sand, sand & ~covered, walls], ~(sand | walls)
    if decorated:
        kinds += [walls & first, air & first & ~second, air & second & ~first, air & first & second]
    counts = [block_sums(cells, rows, columns) for cells in kinds]
    cells = np.diff(rows)[:, None] * np.diff(columns)
    wanted = np.full_like(pixels, 5)
    for channel in range(3):
        light = sum(count * KIND_LIGHTS[1 + kind, channel] for kind, count in enumerate(counts)) / cells
        part = CHANNELS[channel][(KIND_LIGHTS[0, channel] + light + 0.5).astype(int)]
        wanted[1:-2, 2:-2] = part if channel == 0 else wanted[1:-2, 2:-2] | part
    assert len(KIND_LIGHTS) == 1 + KINDS + DECOR_KINDS and (pixels == wanted).all()


def test_a_pixel_may_hold_more_rows_than_a_byte_counts():
    rows, columns = np.array([0, 3 * MOST_ROWS + 2], np.int32), np.array([0, 3], np.int32)
    sand = np.ones((rows[1], 3), bool)
    where, pixels = layout(*sand.shape), np.zeros((1, 1), np.uint32)
    lights = np.array([[0, 0, 0], [4000, 0, 800], [0, 4000, 0], *[[0, 0, 0]] * 5], float)
    draw_density(pack(sand, ~sand), None, where.stride, where.words, columns, rows, lights, CHANNELS, pixels, 0, 0)
    lit = round(4000 / len(sand))
    assert pixels[0, 0] == CHANNELS[0, 4000] | CHANNELS[1, lit] | CHANNELS[2, 800]
