"""The differences: marks over each compared world where it differs from the one that leads."""

import time

from game.world.looks.heatmap_overlay import HeatmapOverlay, mark_covers
from game.world.sand.crop import CropBox
from game.world.sand.differences import differing

SHARE = 4  # looking for differences may take one part in 4 of the time; on huge lattices it is done less often


class Differences:
    """Which cells differ, looked for in each frame in which any world has moved."""

    def __init__(self, sessions, display):
        self._sessions, self._display = sessions, display
        self.shown = False
        self.counts = {}  # {name: cells in which that world differs}
        self._of = None  # what the marks were last made of
        self._next_s = 0.0

    def toggle(self):
        """Mark the differences, or no longer."""
        self.shown, self._of, self.counts = not self.shown, None, {}
        self._next_s = 0.0
        if not self.shown:
            self._display.sand_view.lay_over({}, {})
            self._display.refresh()

    def prepare(self, now_s):
        """Mark what differs now, before it is drawn."""
        sessions = self._sessions.now.sessions
        if not self.shown or len(sessions) < 2 or now_s < self._next_s:
            return
        of = self._display.sand_view, self._display.theme.colours, *(_state(each) for each in sessions.values())
        if of == self._of:
            return
        begin, self._of = time.perf_counter(), of
        self._mark({name: each.world for name, each in sessions.items()})
        self._next_s = now_s + SHARE * (time.perf_counter() - begin)

    def _mark(self, worlds):
        lead = self._sessions.now.world
        names = sorted(worlds, key=lambda name: worlds[name] is not lead)
        found = {}
        if all(each.shape == lead.shape for each in worlds.values()):
            found = dict(zip(names, differing([worlds[name] for name in names]), strict=True))
        self.counts = {name: int(each.sum()) for name, each in found.items()}
        box, covers = CropBox(0, 0, *lead.shape), mark_covers(self._display.theme.rgb("ring"))
        overlays = {name: HeatmapOverlay(box, each.view("u1") * 254, covers) for name, each in found.items()}
        words = {name: f"{count:,} cells differ" for name, count in self.counts.items()}
        self._display.sand_view.lay_over(overlays, words)
        self._display.refresh()


def _state(session):
    world = session.world
    return world, world.iteration, session.timeline.history.line
