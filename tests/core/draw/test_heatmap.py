"""Heat: counts become levels, and levels lie over a picture once, where they belong."""

import numpy as np
import pytest

from game.core.draw.heatmap import ALWAYS, LEVELS, NEVER, SOLID, covers_of, heat_levels, lay_heat, mean_levels


def levels_of(counts, runs, walls=None):
    counts = np.atleast_2d(np.array(counts, np.int64))
    levels = np.zeros(counts.shape, np.uint8)
    heat_levels(counts, runs, np.zeros(counts.shape, bool) if walls is None else walls, levels)
    return levels


def test_only_what_no_run_saw_is_never_and_only_what_all_saw_is_always():
    for runs in (1, 2, 512, 10_000, 10**9):
        counts = np.unique(np.linspace(0, runs, 1001).astype(np.int64))
        levels = levels_of(counts, runs)[0].astype(int)
        assert levels[0] == NEVER and levels[-1] == ALWAYS
        assert (np.diff(levels) >= 0).all()
        if len(counts) > 2:
            assert levels[1] > NEVER and levels[-2] < ALWAYS
            assert np.abs(levels - counts / runs * ALWAYS).max() <= 1


def test_walls_have_a_level_of_their_own():
    walls = np.array([[True, False]])
    assert levels_of([[0, 5]], 5, walls).tolist() == [[SOLID, ALWAYS]]


def test_levels_are_shares_rounded_to_nearest():
    generator = np.random.default_rng(69)
    for runs in (3, 255, 10_000, 10**9):
        counts = generator.integers(1, runs, 10_000)
        wanted = np.clip((counts * ALWAYS + runs // 2) // runs, NEVER + 1, ALWAYS - 1)
        assert (levels_of(counts, runs)[0] == wanted).all()


@pytest.mark.parametrize("scaled", [True, False])
def test_a_pixel_keeps_its_share_and_gets_the_rest(scaled):
    generator = np.random.default_rng(70)
    levels = generator.integers(0, LEVELS, (5, 25)).astype(np.uint8)
    kept = np.arange(1, LEVELS + 1, dtype=np.uint32)
    laid = (LEVELS - kept) // 2 * np.uint32(0x010101)
    columns = np.sort(generator.integers(0, 7, 20)) if scaled else np.arange(3, 23)
    columns, rows = columns.astype(np.int32), np.repeat(np.arange(5, dtype=np.int32), 3)
    pixels = generator.integers(0, 2**24, (20, 30)).astype(np.uint32)
    before = pixels.copy()
    lay_heat(levels, covers_of(kept, laid), columns, rows, pixels, 2, 4)
    for i, row in enumerate(rows):
        for j, column in enumerate(columns):
            level = levels[row, column]
            for byte in (0, 8, 16):
                old = int(before[2 + i, 4 + j]) >> byte & 255
                new = int(pixels[2 + i, 4 + j]) >> byte & 255
                assert new == (old * int(kept[level]) >> 8) + (int(laid[level]) >> byte & 255)
    before[2:17, 4:24] = pixels[2:17, 4:24]
    assert (pixels == before).all()


def test_a_pixel_of_many_cells_shows_their_mean_without_the_walls():
    generator = np.random.default_rng(71)
    levels = generator.integers(0, LEVELS, (40, 50)).astype(np.uint8)
    levels[8:12, 10:20] = SOLID
    levels[20:30] = NEVER
    levels[25, 25] = 1
    columns, rows = np.arange(0, 51, 5, dtype=np.int32), np.array([0, 3, 8, 12, 20, 30, 40], np.int32)
    means = np.zeros((6, 10), np.uint8)
    mean_levels(levels, columns, rows, means)
    for i in range(6):
        for j in range(10):
            cells = levels[rows[i] : rows[i + 1], columns[j] : columns[j + 1]].astype(int)
            sand = cells[cells != SOLID]
            if len(sand) == 0:
                assert means[i, j] == SOLID
            else:
                assert abs(means[i, j] - sand.mean()) <= 1 and (means[i, j] == NEVER) == (sand.max() == NEVER)
