"""The blocks over the sand: the partition of the coming iteration, what each block can do, what it has just done.

All of it is drawn once into what was drawn anew of the sand, so that soft edges stay soft.
"""

import math
from functools import lru_cache

import numpy as np
import pygame

from game.play.ui import theme as look
from game.world.sand.block_events import block_at, coming_events, happened, moves_between, offset, told_events
from game.world.sand.crop import CropBox

LEAST_CELL = 8  # pixels: in smaller cells no arrow can be seen
LEAST_WORDS = 28  # pixels to a cell, for the chance to be written into a block
SLOW = 8  # iterations per second: slow enough to follow
SMOOTHING = 4  # sprites are drawn this many times larger and shrunk


class BlockOverlay:
    """Shown while it is on, cells are large, and time stands still or goes slowly."""

    def __init__(self, sessions, display, notices):
        self._sessions, self._display, self._notices = sessions, display, notices
        self.on = False
        self._known = None  # what the events below are for: world, iteration, stamp, rule, view
        # Events: what the coming iteration can bring; what came about in the last one, and what chance refused there
        self.coming = self.trails = self.stays = None

    def toggle(self):
        """Show the blocks, or hide them; if they cannot be seen now, say why."""
        self.on = not self.on
        if self.on and self._display.sand_view.view.cell < LEAST_CELL:
            words = "Zoom in to see the blocks: Ctrl+wheel, or Ctrl and +"
            self._notices.say(words, holds=lambda: self.on and not self.shown)
        elif self.on and not self._is_calm:
            words = "Blocks show while time is paused: Space, then . for each iteration"
            self._notices.say(words, holds=lambda: self.on and not self.shown)

    @property
    def shown(self):
        """Whether they are to be drawn."""
        sand_view = self._display.sand_view
        return self.on and self._is_calm and sand_view.view.cell >= LEAST_CELL and not sand_view.turn

    @property
    def _is_calm(self):
        session = self._sessions.now
        return session.paused or session.clock.speed <= SLOW

    def prepare(self):
        """Look at the blocks in sight, and have the sand drawn anew if they are not those that were drawn."""
        known = self._present() if self.shown else None
        if known == self._known:
            return
        before, self._known = self._known, known
        if known:
            self._look(before, known)
        else:
            self.coming = self.trails = self.stays = None
        self._display.sand_view.blocks = self if known else None
        self._display.sand_view.refresh()

    def told(self, column, row):
        """Return what can happen in the block at a cell, and what has just happened there: two lists of lines."""
        if not self._known or self.coming is None:
            return [], []
        world, _, _, rule, _ = self._known
        coming = _events_at(self.coming, rule, block_at(world, rule, row, column))
        lines = [f"{event.name} ({event.layer}): {_percent(p)}" for event, p in coming]
        if self.trails is None:
            return lines, []
        block = block_at(world, rule, row, column, before=1)
        return lines, [f"{event.name} ({event.layer})" for event, _ in _events_at(self.trails, rule, block, done=True)]

    def draw(self, surface, theme, view):
        """Draw them over the cells in sight, as far as the surface's clip goes."""
        cell, clip = view.cell, surface.get_clip()
        surface.set_clip(clip.clip(self._display.sand_view.area))
        _draw_lines(surface, view, offset(self._known[0], self._known[3]), theme)
        bits = self._known[0].layout.bits
        inks = tuple(theme.rgb(role) for role in (look.SUNKEN, look.DIM, look.BRIGHT_HANDLE))
        for events, sprite_of in ((self.trails, _trail), (self.stays, _stay), (self.coming, _arrow)):
            if events is not None:
                _draw_moves(surface, view, events, bits, lambda moves, of=sprite_of: of(round(cell), moves, inks))
        if cell >= LEAST_WORDS * theme.scale:
            _draw_chances(surface, view, self.coming, theme)
        surface.set_clip(clip)

    def _present(self):
        session, sand_view = self._sessions.now, self._display.sand_view
        world = session.world
        return world, world.iteration, world.activity.stamp, session.rule, sand_view.view

    def _look(self, before, known):
        """Find what can happen, and if one iteration has passed since `before`, what has."""
        world, iteration, stamp, rule, view = known
        part = part_in_sight(view)
        if before and before[:1] == (world,) and (before[1] + 1, before[2] + 1) == (iteration, stamp):
            done = happened(self.coming, world, part_in_sight(before[4]))
            self.trails, self.stays = self.coming.only(done), self.coming.only(~done)
        elif not before or before[:3] != known[:3]:
            self.trails = self.stays = None
        self.coming = coming_events(world, rule, part)


def _events_at(events, rule, block, done=False):
    """Return [(event, probability)] of the BlockEvents in a block; `done`: of those that have made it what it is."""
    here = np.flatnonzero((events.rows == block[0]) & (events.columns == block[1]))
    if not len(here):
        return []
    return told_events(rule, events.before[here[0]], events.after[here[0]] if done else None)


def _percent(p):
    return "always" if p >= 1.0 else f"{100 * p:.3g} %"


def part_in_sight(view):
    """Return the CropBox of the lattice of which any cell is in sight."""
    left, top, right, bottom = view.seen
    first, last = view.place(left, top), view.place(right, bottom)
    return CropBox.within(
        view.shape, *(math.floor(each) for each in first[::-1]), *(math.ceil(each) for each in last[::-1])
    )


def _draw_lines(surface, view, first, theme):
    """Draw fine lines between cells and stronger ones around blocks."""
    left, top, right, bottom = view.seen
    thick = max(1, round(view.cell / 20))
    rows, columns = view.shape
    ends = view.pixel(columns + (columns - first[0]) % 2, rows + (rows - first[1]) % 2)  # blocks reach outside
    edges = surface.get_clip().bottomright
    right, bottom = (min(math.ceil(end) + thick, edge) for end, edge in zip(ends, edges, strict=True))
    fine, strong = theme.rgb(look.GROUND), theme.rgb(look.RING)
    for colour, parity in ((fine, 1), (strong, 0)):
        wide = 1 if colour == fine else thick
        for column in range(int(view.place(left, top)[0]), int(view.place(right, top)[0]) + 2):
            if (column - first[0]) % 2 == parity and column >= first[0]:
                surface.fill(colour, (_edge(view.pixel(column, 0)[0]) - wide // 2, top, wide, bottom - top))
        for row in range(int(view.place(left, top)[1]), int(view.place(left, bottom)[1]) + 2):
            if (row - first[1]) % 2 == parity and row >= first[1]:
                surface.fill(colour, (left, _edge(view.pixel(0, row)[1]) - wide // 2, right - left, wide))


def _draw_moves(surface, view, events, bits, sprite_of):
    """Draw a sprite for every outcome of every event, over the corners of its block."""
    sprites = []
    for row, column, before, after in zip(*(each.tolist() for each in events[:4]), strict=True):
        x, y = view.pixel(column, row)
        sprites.append((sprite_of(moves_between(before, after, bits)), (_edge(x), _edge(y))))
    surface.blits(sprites, False)


def _draw_chances(surface, view, events, theme):
    """Write into each block how likely it is to change, where that is left to chance."""
    chances = {}
    for row, column, chance in zip(events.rows.tolist(), events.columns.tolist(), events.chances.tolist(), strict=True):
        chances[row, column] = chances.get((row, column), 0.0) + chance
    for (row, column), chance in chances.items():
        if chance >= 1:
            continue
        x, y = view.pixel(column + 1, row + 1)
        words = theme.words(f"{chance:.2g}", look.SMALL, look.TEXT)
        page = words.get_rect(center=(round(x), round(y)))
        surface.fill(theme.rgb(look.SUNKEN), page.inflate(theme.px(6), 0))
        surface.blit(words, page)


@lru_cache(maxsize=256)
def _arrow(cell, moves, inks):
    """Return arrows for what moves, and spots for what changes, in a sprite the size of a block."""
    canvas = _canvas(cell)
    for start, end in moves:
        for colour, margin in ((inks[0], cell * 0.06), (inks[2], 0)):
            if start == end:
                middle = [(part + 0.5) * cell * SMOOTHING for part in end[::-1]]
                pygame.draw.circle(canvas, colour, middle, (cell * 0.2 + margin) * SMOOTHING)
                continue
            pygame.draw.polygon(canvas, colour, _arrow_points(start, end, cell, margin))
    return pygame.transform.smoothscale(canvas, (2 * cell, 2 * cell))


@lru_cache(maxsize=256)
def _trail(cell, moves, inks):
    """Return the ways that what moved has come, as dots that grow."""
    canvas = _canvas(cell)
    for start, end in moves:
        for number, share in enumerate((0.0, 0.3, 0.55)):
            x, y = ((s + share * (e - s) + 0.5) * cell * SMOOTHING for s, e in zip(start[::-1], end[::-1], strict=True))
            radius = cell * SMOOTHING * (0.07 + 0.025 * number)
            pygame.draw.circle(canvas, inks[1], (x, y), radius)
    return pygame.transform.smoothscale(canvas, (2 * cell, 2 * cell))


@lru_cache(maxsize=256)
def _stay(cell, moves, inks):
    """Return a ring around each grain that chance has refused."""
    canvas = _canvas(cell)
    for (row, column), _ in moves:
        middle = (column + 0.5) * cell * SMOOTHING, (row + 0.5) * cell * SMOOTHING
        ring = cell * SMOOTHING * 0.36, max(1, round(cell * SMOOTHING * 0.07))
        pygame.draw.circle(canvas, inks[0], middle, *ring)
    return pygame.transform.smoothscale(canvas, (2 * cell, 2 * cell))


def _canvas(cell):
    canvas = pygame.Surface((2 * cell * SMOOTHING, 2 * cell * SMOOTHING), pygame.SRCALPHA, 32)
    canvas.fill((0, 0, 0, 0))
    return canvas


def _arrow_points(start, end, cell, margin):
    """Return the outline of an arrow from one corner of a block to another, `margin` pixels wider all round."""
    (y0, x0), (y1, x1) = start, end
    along = np.array([x1 - x0, y1 - y0]) / math.hypot(x1 - x0, y1 - y0)
    across = np.array([-along[1], along[0]])
    tail = (np.array([x0, y0]) + 0.5) * cell - along * margin
    tip = (np.array([x1, y1]) + 0.5) * cell + along * (0.12 * cell + 1.6 * margin)
    neck = tip - along * (0.36 * cell + 2.2 * margin)
    shaft, head = across * (0.07 * cell + margin), across * (0.22 * cell + 1.6 * margin)
    outline = (tail + shaft, neck + shaft, neck + head, tip, neck - head, neck - shaft, tail - shaft)
    return [tuple(point * SMOOTHING) for point in outline]


def _edge(position):
    """Return the first pixel of a cell that begins at a position."""
    return math.ceil(position - 0.5)
