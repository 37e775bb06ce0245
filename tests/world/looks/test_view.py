"""The view: cells and pixels find each other, at every zoom."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.world.looks.view import LEVELS, View, level

SIDES = st.integers(1, 16384)
ZOOMS = st.one_of(st.sampled_from(LEVELS), st.floats(1 / 60, 200))


@st.composite
def views(draw):
    """Return a view in a frame of pixels, of some place in some lattice."""
    shape = draw(SIDES), draw(SIDES)
    frame = draw(st.integers(0, 50)), draw(st.integers(0, 50)), draw(st.integers(60, 900)), draw(st.integers(60, 700))
    place = draw(st.floats(0, shape[1])), draw(st.floats(0, shape[0]))
    x, y = draw(st.integers(0, 900)), draw(st.integers(0, 700))
    return View.near(shape, frame, draw(ZOOMS), place, x, y)


@pytest.mark.parametrize(("shape", "size"), [((100, 300), (150, 50)), ((90, 90), (140, 131)), ((7, 5), (640, 480))])
def test_a_view_fits_keeps_cells_square_and_shows_every_part(shape, size):
    view = View.fit(shape, 10, 20, *size)
    assert view.left >= 10 and view.top >= 20
    assert view.left + view.width <= 10 + size[0] and view.top + view.height <= 20 + size[1]
    assert view.width / shape[1] == pytest.approx(view.height / shape[0], abs=1 / min(shape))
    assert max(view.width / size[0], view.height / size[1]) >= 0.7
    assert view.column_edges[0] == view.row_edges[0] == 0
    assert (view.row_edges[-1], view.column_edges[-1]) == shape


@given(views())
def test_the_cell_under_a_pixel_is_the_cell_drawn_there(view):
    left, top, right, bottom = view.seen
    assert len(view.columns) == right - left > 0 and len(view.rows) == bottom - top > 0
    for x, y in ((left, top), ((left + right) // 2, (top + bottom) // 2), (right - 1, bottom - 1)):
        column, row = view.place(x, y)
        assert int(column) == view.columns[x - left] and int(row) == view.rows[y - top]
        back = view.pixel(column, row)
        assert back == pytest.approx((x + 0.5, y + 0.5), abs=1e-6)


@given(views())
def test_cells_that_share_a_pixel_belong_to_no_other(view):
    for edges, side in ((view.column_edges, view.shape[1]), (view.row_edges, view.shape[0])):
        assert edges[0] >= 0 and edges[-1] <= side
        assert (np.diff(edges) >= (1 if view.dense else 0)).all()
    left, top, right, bottom = view.seen
    first, last = view.place(left - 0.5, top - 0.5), view.place(right - 0.5, bottom - 0.5)
    if view.dense:  # a cell lies where its middle does, but for those that end the lattice within half a pixel
        at_most = 1 + 0.5 * max(view.shape[1] / view.width, view.shape[0] / view.height)
        for edges, low, high in zip((view.column_edges, view.row_edges), first, last, strict=True):
            assert abs(edges[0] - low) <= at_most and abs(edges[-1] - high) <= at_most


@given(views(), st.floats(0, 1), st.floats(0, 1), ZOOMS)
def test_zooming_keeps_the_place_under_the_pointer_unless_an_end_comes_into_sight(view, right, down, cell):
    x, y = (view.seen[k] + part * (view.seen[k + 2] - 1 - view.seen[k]) for k, part in enumerate((right, down)))
    place = view.place(x, y)
    closer = View.near(view.shape, view.frame, cell, place, x, y)
    found = closer.place(x, y)
    for axis, (low, length, start, room) in enumerate(
        (
            (closer.left, closer.width, view.frame[0], view.frame[2]),
            (closer.top, closer.height, view.frame[1], view.frame[3]),
        )
    ):
        at_an_end = length <= room or low == start or low + length == pytest.approx(start + room)
        assert at_an_end or found[axis] == pytest.approx(place[axis], abs=1e-6)


@given(views())
def test_a_lattice_fills_its_frame_or_lies_in_the_middle(view):
    left, top, right, bottom = view.seen
    x, y, width, height = view.frame
    for first, last, start, room in ((left, right, x, width), (top, bottom, y, height)):
        assert (last - first == room) or abs((first - start) - (start + room - last)) <= 2


def test_levels_go_up_and_down_and_end():
    for cell in (0.3, 1, 1.5, 7, LEVELS[0], LEVELS[-1]):
        assert level(cell, 1) >= cell >= level(cell, -1)
    assert level(1, 3) == 4 and level(4, -4) == 1 / 2 and level(LEVELS[-1], 1) == LEVELS[-1]
