"""Rows drawn by several threads."""

import threading
import time

import pytest

from game.world.looks import row_threads


@pytest.fixture
def three_threads(monkeypatch):
    monkeypatch.setattr(row_threads, "THREADS", 3)
    monkeypatch.setattr(row_threads, "LEAST_PIXELS", 100)
    row_threads._threads.cache_clear()
    yield
    row_threads._threads().shutdown()
    row_threads._threads.cache_clear()


def drawn(top, bottom, width, draw=lambda: None):
    """Return (number of a part, its rows, its thread) of each call."""
    parts = []

    def part(number, first, last):
        draw()
        parts.append((number, range(first, last), threading.get_ident()))

    row_threads.draw_rows(part, top, bottom, width)
    return sorted(parts)


@pytest.mark.parametrize(("rows", "width", "parts"), [(7, 100, 3), (2, 100, 2), (3, 66, 1), (1, 1, 1), (100, 100, 3)])
def test_each_row_is_drawn_once_in_parts_worth_a_thread(rows, width, parts, three_threads):
    found = drawn(5, 5 + rows, width)
    assert [number for number, _, _ in found] == list(range(parts))
    assert [row for _, part, _ in found for row in part] == list(range(5, 5 + rows))


def test_the_parts_are_drawn_at_the_same_time(three_threads):
    together = threading.Barrier(3, timeout=20)  # none goes on before all are there
    assert len({thread for _, _, thread in drawn(0, 30, 100, together.wait)}) == 3


@pytest.mark.parametrize("failing", [0, 1, 2])
def test_an_error_in_any_part_is_raised_once_all_have_ended(failing, three_threads):
    ended = []

    def part(number, first, last):
        if number == failing:
            raise ValueError("no")
        time.sleep(0.1)
        ended.append(number)

    with pytest.raises(ValueError, match="no"):
        row_threads.draw_rows(part, 0, 30, 100)
    assert len(ended) == 2
