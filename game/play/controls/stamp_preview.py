"""The stamp's preview: the stamp in hand as it would lie under the pointer."""

import numpy as np

from game.play.view.outlines import box_outline, mark
from game.play.view.piece_mark import piece_mark
from game.play.view.swatches import swatch_of
from game.world.sand.material_codes import EMPTY, SAND


class StampPreview:
    """Shows the stamp in hand, without what the rule of the world that is played has no material for."""

    def __init__(self, sessions, display, selection):
        self._sessions, self._display, self._selection = sessions, display, selection
        self._looks = self._pixels = None  # of what, and its (H, W, 4) uint8 pixels
        self._shown = self._marks = None  # where, and as what, it was shown last

    def marks(self, place, view):
        """Return the Marks of the stamp in hand over a place in the lattice."""
        if not self._selection.copied:
            return ()
        box, area = self._selection.landing(place), self._display.sand_view.area
        looks = self._selection.copied.stamp, self._sessions.now.rule.definition, self._display.theme
        if self._looks is None or any(mine is not its for mine, its in zip(self._looks, looks, strict=True)):
            self._looks, self._pixels, self._shown = looks, self._painted(*looks), None
        shown = box, view, tuple(area)
        if shown != self._shown:
            piece = piece_mark(self._pixels, box, view, area)
            self._shown, self._marks = shown, (*((piece,) if piece else ()), mark(box_outline(*box), view))
        return self._marks

    def _painted(self, stamp, definition, theme):
        materials = {each.name: each for each in definition.materials}
        colours = np.zeros((len(stamp.names), 4), np.uint8)
        for code, name in enumerate(stamp.names):
            if code != EMPTY and name in materials:
                colours[code] = (*theme.rgb(swatch_of(theme.colours, materials[name])), 255)
        pixels = colours[stamp.cells]
        if stamp.colours is not None and definition.codes.is_sand:
            for number in np.unique(stamp.colours[stamp.cells == SAND]).tolist():
                pixels[(stamp.colours == number) & (stamp.cells == SAND), :3] = theme.colours.swatch(number)
        return pixels
