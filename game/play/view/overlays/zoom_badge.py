"""The zoom badge: how large a cell is, in the status line for a moment after that has changed."""

STAY_S = 1.2


class ZoomBadge:
    """Shows itself, and goes away by itself."""

    def __init__(self, display):
        self._display = display
        self.shown = False
        self._until_s = None

    def show(self):
        """Come up, or stay for longer."""
        self.shown, self._until_s = True, None

    def update(self, now_s):
        """Note how late it is."""
        if self.shown and self._until_s is None:
            self._until_s = now_s + STAY_S
        elif self.shown and now_s > self._until_s:
            self.shown = False

    @property
    def words(self):
        """What it says, or "" while it is not shown."""
        return spelled(self._display.sand_view.view.cell) if self.shown else ""


def spelled(cell):
    """Return how large a cell of `cell` pixels is."""
    if cell >= 1:
        return f"{_figure(cell)} px per cell"
    cells = _figure(1 / cell)
    return f"1 px = {cells} × {cells} cells"


def _figure(number):
    return f"{round(number, 1 if number < 10 else 0):g}"
