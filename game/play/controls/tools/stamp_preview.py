"""The preview of a piece: what is carried, or the stamp in hand, as it would lie under the pointer."""

import numpy as np

from game.play.view.overlays.outlines import box_outline, mark
from game.play.view.overlays.piece_mark import piece_mark
from game.play.view.scene_picture import pixels_of
from game.world.sand.stamp import landed


class StampPreview:
    """Shows a stamp, without what the rule of the world that is played has no material for."""

    def __init__(self, sessions, display):
        self._sessions, self._display = sessions, display
        self._looks = self._pixels = None  # of what, and its (H, W, 4) uint8 pixels
        self._shown = self._marks = None  # where, and as what, it was shown last

    def marks(self, stamp, box, view):
        """Return the Marks of a stamp that would lie in a box of the lattice."""
        session, area = self._sessions.now, self._display.sand_view.area
        looks = stamp, session.world.codes, session.scene.made_of, self._display.colours
        if self._looks is None or any(mine is not its for mine, its in zip(self._looks, looks, strict=True)):
            self._looks, self._pixels, self._shown = looks, self._painted(stamp, session), None
        shown = box, view, tuple(area)
        if shown != self._shown:
            piece = piece_mark(self._pixels, box, view, area)
            self._shown, self._marks = shown, (*((piece,) if piece else ()), mark(box_outline(*box), view))
        return self._marks

    def _painted(self, stamp, session):
        world = landed(stamp, session.world.codes)
        pixels = pixels_of(world, session.rule, session.scene.made_of, self._display.colours)
        return np.dstack([pixels, 255 * (world.materials > 0).astype(np.uint8)])
