"""The selection: a rectangle of cells, the stamp that was copied last, and the gestures of both."""

from typing import NamedTuple

from game.play.view.overlays.outlines import box_outline
from game.world.rules.rule import Rule
from game.world.sand.stamp import Stamp, cut_out
from game.world.sessions.action import Draw, Move, Paste, box, cell

MOST_SHOWN = 2**22  # cells: a larger piece would hold a frame up before it is seen, and has an outline alone


class Copied(NamedTuple):
    """A stamp, and the rule and the walls' look of the world that it was cut out of."""

    stamp: Stamp
    rule: Rule
    made_of: str


class Selection:
    """Which cells of the world that is played are selected, and what was copied."""

    def __init__(self, sessions):
        self._sessions = sessions
        self._chosen = None  # (shape of the lattice, box)
        self.copied = None  # a Copied
        self.air = False  # a stamp's empty cells empty those below them

    @property
    def box(self):
        """First column and row, then those after the last; None where nothing is selected."""
        shape, chosen = self._chosen or (None, None)
        return chosen if shape == self._sessions.now.world.shape else None

    @box.setter
    def box(self, chosen):
        """Select what of a box is in the lattice; None for nothing."""
        height, width = shape = self._sessions.now.world.shape
        left, top, right, bottom = chosen or (0, 0, 0, 0)
        inside = max(left, 0), max(top, 0), min(right, width), min(bottom, height)
        self._chosen = (shape, inside) if inside[0] < inside[2] and inside[1] < inside[3] else None

    @property
    def ends(self):
        """The places in the first and in the last of the cells that are selected."""
        left, top, right, bottom = self.box
        return (left, top), (right - 1, bottom - 1)

    def copy(self):
        """Copy what is selected."""
        session = self._sessions.now
        self.copied = Copied(cut_out(session.world, self.box), session.rule, session.scene.made_of)

    def hold(self, scene):
        """Copy all of a Scene."""
        stamp = Stamp(scene.rule.materials, scene.cells, scene.colours, scene.fixtures)
        self.copied = Copied(stamp, scene.rule, scene.made_of)

    def covers(self, place):
        """Return whether a place is in what is selected."""
        column, row = cell(place)
        left, top, right, bottom = self.box or (0, 0, 0, 0)
        return left <= column < right and top <= row < bottom

    def erasing(self):
        """Return the act that erases what is selected."""
        return Draw("rectangle", "erase", *self.ends)

    def turning(self, quarters, mirrored):
        """Return the act that turns and mirrors what is selected about its middle, and select what that gives."""
        left, top, right, bottom = self.box
        ends, wide, high = self.ends, right - left, bottom - top
        if quarters % 2:
            left, top = left + int((wide - high) / 2), top + int((high - wide) / 2)  # there and back is the same way
            wide, high = high, wide
        self.box = left, top, left + wide, top + high
        return Move(*ends, (left, top), quarters, mirrored)

    def change_stamp(self, quarters, mirrored):
        """Turn and mirror the stamp in hand."""
        stamp = self.copied.stamp
        self.copied = self.copied._replace(stamp=(stamp.mirrored() if mirrored else stamp).turned(quarters))

    def landing(self, place):
        """Return the box in which the stamp in hand lands with its middle at a place."""
        (column, row), (high, wide) = cell(place), self.copied.stamp.shape
        left, top = column - wide // 2, row - high // 2
        return left, top, left + wide, top + high


class SelectTool:
    """Selects a rectangle, or carries what is selected where the button goes down in it."""

    def __init__(self, brush, place, world):
        self._selection, self._start, self._end = brush.selection, place, place
        self._box = self._selection.box if self._selection.covers(place) else None  # that is carried
        is_small = self._box is not None and _size(self._box) <= MOST_SHOWN
        self._stamp = cut_out(world, self._box) if is_small else None  # what was in it when it was taken up

    def go(self, place, _straight):
        """Stretch the rectangle to a place, or carry what is selected there."""
        self._end = place
        if not self._box:
            self._selection.box = box(self._start, place)
        return []

    def end(self, place, straight):
        """Select what was drawn, nothing by a mere click; or let go of what was carried."""
        self.go(place, straight)
        if not self._box:
            if cell(self._start) == cell(place):
                self._selection.box = None
            return []
        if self._selection.box != self._box:  # another lattice has come
            return []
        ends, (left, top, right, bottom) = self._selection.ends, self._there()
        self._selection.box = left, top, right, bottom
        return [Move(*ends, (left, top))]

    def outlines(self):
        """Return the outline of what is selected, where it is carried."""
        there = self._there() if self._box else self._selection.box
        return [box_outline(*there)] if there else []

    @property
    def carried(self):
        """What is carried, as (Stamp, the box in which it would lie), if it is to be shown."""
        return (self._stamp, self._there()) if self._stamp else None

    def _there(self):
        """Return where what is selected has been carried, as a box."""
        (column, row), (from_column, from_row) = cell(self._end), cell(self._start)
        left, top, right, bottom = self._box
        across, down = column - from_column, row - from_row
        return left + across, top + down, right + across, bottom + down


class StampTool:
    """Puts the stamp in hand down where the button goes down."""

    outlines = None

    def __init__(self, brush, _place, _world):
        self._selection, self._put = brush.selection, False

    def go(self, place, _straight):
        """Put it down, if it is not yet."""
        selection, done, self._put = self._selection, self._put, True
        if done or not selection.copied:
            return []
        return [Paste(selection.copied.stamp, selection.landing(place)[:2], selection.air)]

    end = go


def _size(cells):
    left, top, right, bottom = cells
    return (right - left) * (bottom - top)
