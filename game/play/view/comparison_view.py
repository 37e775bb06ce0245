"""The comparison view: a pane for each world of a comparison, side by side; tools work on the leading one."""

from dataclasses import replace

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.view.frame_stats import own_ns
from game.play.view.sand_view import SandView
from game.play.view.swatches import colours_of_worlds
from game.world.sand.measure import grains_above

TITLE = 26  # height of a title at scale 1
PAD = 8  # in a title, beside and between its words
STRIPE = 4  # in the colour of a world, at the left of its title
GAP = 3  # between panes, so that zoomed worlds are not read as one
FORMS = (  # of a title, from the fullest: size of its name, words of its count, whether "p =" stands before a number
    *((look.HEADING, 3, True), (look.HEADING, 2, True), (look.HEADING, 1, True), (look.SMALL, 1, True)),
    *((look.HEADING, 0, True), (look.SMALL, 0, True), (look.SMALL, 0, False)),
)
LONGEST = "888,888 cells differ"  # of what stands beside a name
DRAWING_NS = 6_000_000  # of a frame; worlds that are left when it is spent are drawn in the next one, before others
REFRESH_S = 0.25  # the grains left are counted so often


class ComparisonView:
    """A SandView for each world; what is shown in one pane is shown in all."""

    def __init__(self, window, comparison, measured_row):
        """`measured_row()` returns the row above which the grains left are counted."""
        self._window, self._comparison, self._measured_row = window, comparison, measured_row
        self._theme = None
        self._views = {each: SandView(window) for each in comparison.sessions}
        self._lead = self._views[comparison.lead]
        self._shifts = {}  # of each pane from the leading one, in pixels
        self._titles, self._drawn, self._counted_s = {}, {}, None
        self._left = {}  # the grains above the neck in each world
        self._said = {}  # {name: words} that stand in its title instead
        self._codes = {}  # the MaterialCodes of each world that its view is made for
        self._rows = 1  # of words in a title
        self._gaps, self._gapped = [], False  # between panes; whether they are drawn
        self._overlay, self._covered = None, []  # as last drawn, and the rects that it covers
        self._left_out = ()  # names of worlds that the last frame had no time to draw

    # --- as a SandView ---

    area = property(lambda self: self._lead.area)
    view = property(lambda self: self._lead.view)
    whole = property(lambda self: self._lead.whole)
    turn = property(lambda self: self._lead.turn)

    @property
    def panes(self):
        """The parts of the window that show a lattice."""
        return tuple(each.area for each in self._views.values())

    @property
    def framed(self):
        """{name: the part of the window that shows a world and its title}."""
        return {name: self._titles[name].union(each.area) for name, each in self._views.items()}

    @property
    def heatmap(self):
        """What lies over the leading world."""
        return self._lead.heatmap

    @heatmap.setter
    def heatmap(self, heatmap):
        self._lead.heatmap = heatmap

    @property
    def blocks(self):
        """The blocks over the leading world."""
        return self._lead.blocks

    @blocks.setter
    def blocks(self, blocks):
        self._lead.blocks = blocks

    def fit(self, shape, area, margin, theme, walls, substances):
        """Show lattices of `shape` in as many columns of `area` as leave the largest cells."""
        self._theme, gap, number = theme, theme.px(GAP), len(self._views)
        ways = [self._split(area, columns, gap) for columns in range(number, 0, -1) if number % columns == 0]
        self._rows, high, rects = max(
            ways, key=lambda way: min(way[2][0].height / shape[0], way[2][0].width / shape[1])
        )
        sessions = self._comparison.sessions
        self._codes = {name: each.world.codes for name, each in sessions.items()}
        for (name, pane), rect, its in zip(self._views.items(), rects, substances, strict=True):
            pane.fit(shape, rect, margin, theme, walls, [its])
            self._titles[name] = pygame.Rect(rect.x, rect.y - high, rect.width, high)
        lead = self._lead.area
        self._shifts = {each: (s.area.x - lead.x, s.area.y - lead.y) for each, s in self._views.items()}
        self._gaps = _gaps([*self._titles.values()], rects, gap)
        self._drawn, self._gapped = {}, False

    def _split(self, area, columns, gap):
        """Return (rows of words in a title, its height, the rects of the worlds) in so many columns."""
        number, theme = len(self._views), self._theme
        for rows in (1, 2):
            high = theme.px(TITLE) + (rows - 1) * theme.line_height(look.SMALL)
            rects = _split(area, number, columns, high, gap)
            room = rects[0].width - self._beside_words()
            if all(_width(theme, title, look.HEADING, LONGEST) <= room for title, _ in self.titles().values()):
                break
        return rows, high, rects

    def lay_over(self, overlays, words):
        """Lay {name: HeatmapOverlay} over the worlds and write {name: words} in their titles; else nothing."""
        self._said = words
        for name, each in self._views.items():
            each.heatmap = overlays.get(name)

    def show(self, view):
        """Show the lattices through another view."""
        for name, pane in self._views.items():
            pane.show(_moved(view, *self._shifts[name]))

    def refresh(self):
        """Draw everything next time."""
        self._drawn, self._gapped, self._overlay, self._covered = {}, False, None, []
        for pane in self._views.values():
            pane.refresh()

    def start_turn(self, now_s, quarters):
        """Let the pictures go round by so many quarters, from now on."""
        for pane in self._views.values():
            pane.start_turn(now_s, quarters)

    def end_turn(self):
        """Show the worlds again as they are."""
        for pane in self._views.values():
            pane.end_turn()

    def draw(self, world, marks, overlay, now_s, streams=None):
        """Bring all panes up to date and return the rects of the window that changed; see `SandView.draw`."""
        if self._overlay and not overlay:
            self.refresh()
        first = {name: place for place, name in enumerate(self._left_out)}
        worlds = sorted(self._worlds().items(), key=lambda each: first.get(each[0], len(first)))
        panes = [(self._views[name], world, self._marks_in(name, marks)) for name, world in worlds]
        self._count(now_s)
        under = []  # what soft edges lie over comes first, in all panes
        if overlay is not self._overlay or self._new_titles() or any(_differs(*pane) for pane in panes):
            under = self._covered
            self._drawn = {each: t for each, t in self._drawn.items() if self._titles[each].collidelist(under) < 0}
            self._gapped = self._gapped and all(gap.collidelist(under) < 0 for gap in self._gaps)
        rects, begin, self._left_out = [], own_ns(), ()
        for number, ((name, _), (pane, world, here)) in enumerate(zip(worlds, panes, strict=True)):
            damaged = [rect for rect in under if rect.colliderect(pane.area)]
            if number and pane.can_wait and not damaged and own_ns() - begin > DRAWING_NS:
                self._left_out += (name,)
            else:
                rects += pane.draw(world, here, None, now_s, under=damaged)
        rects += self._draw_titles() + self._draw_gaps()
        before, self._overlay = self._overlay, overlay
        if overlay and (rects or overlay is not before):
            self._covered = overlay(self._window.surface)
            rects += [*under, *self._covered]
        return rects

    def _worlds(self):
        """Return the worlds by name, without those that are still on their way to the scene or rule of the leading one.

        What they show there has another shape or other materials than the views.
        """
        lead, codes = self._comparison.world, self._codes
        worlds = {name: session.world for name, session in self._comparison.sessions.items()}
        return {name: each for name, each in worlds.items() if (each.shape, each.codes) == (lead.shape, codes[name])}

    def _marks_in(self, name, marks):
        x, y = self._shifts[name]
        return tuple(each._replace(points=tuple((a + x, b + y) for a, b in each.points)) for each in marks)

    # --- titles ---

    def titles(self):
        """Return what is written above each world."""
        variants = self._comparison.variants
        left = {each: f"{self._left.get(each, 0):,} left above" for each in self._views} | self._said
        return {each: (variants[each].title, left[each]) for each in self._views}

    def _count(self, now_s):
        """Count the grains that are left above, if it is time to."""
        if self._counted_s is None or now_s - self._counted_s >= REFRESH_S:
            self._counted_s, row = now_s, self._measured_row()
            self._left |= {name: grains_above(world, row) for name, world in self._worlds().items()}

    def _written(self):
        """Return {name: (title, its size, its count)}: the fullest form that there is room for in all titles."""
        theme, titles = self._theme, self.titles()
        room = min(rect.width for rect in self._titles.values()) - self._beside_words()
        width = _width if self._rows == 1 else _wider
        for size, number, whole in FORMS:
            names = {each: name if whole else name.rpartition("= ")[2] for each, (name, _) in titles.items()}
            written = {each: (names[each], size, _first(left, number)) for each, (_, left) in titles.items()}
            if all(width(theme, *each) <= room for each in written.values()):
                break
        return written

    def _beside_words(self):
        """Return how much of a title's width is not for words."""
        return 2 * self._theme.px(PAD)

    def _new_titles(self):
        return {each: title for each, title in self._written().items() if title != self._drawn.get(each)}

    def _draw_titles(self):
        new, theme, surface = self._new_titles(), self._theme, self._window.surface
        colours = colours_of_worlds(theme.colours, self._views)
        for name, (title, size, left) in new.items():
            rect, leads = self._titles[name], name == self._comparison.lead
            draw_list.fill(surface, theme, rect, look.SUNKEN)
            if leads:
                line = theme.px(2)
                draw_list.fill(surface, theme, (rect.x, rect.bottom - line, rect.width, line), look.ACCENT)
            upper, lower = self._places(rect)
            stripe = (rect.x, rect.y, theme.px(STRIPE), rect.height)
            draw_list.fill(surface, theme, stripe, colours[name])
            draw_list.words(surface, theme, upper, title, size, look.BRIGHT_HANDLE if leads else look.DIM, 0)
            align = 1 if self._rows == 1 else 0
            draw_list.words(surface, theme, lower, left, look.SMALL, look.TEXT if leads else look.DIM, align)
        self._drawn |= new
        return [self._titles[each] for each in new]

    def _places(self, rect):
        """Return where the name stands in a title, and where the other words."""
        px = self._theme.px
        upper = pygame.Rect(rect.x + px(PAD), rect.y, rect.width - 2 * px(PAD), px(TITLE))
        if self._rows == 1:
            return upper, upper
        more = self._theme.line_height(look.SMALL)
        return upper, pygame.Rect(upper.x, rect.bottom - more - px(4), upper.width, more)

    def _draw_gaps(self):
        if self._gapped:
            return []
        self._gapped = True
        for gap in self._gaps:
            draw_list.fill(self._window.surface, self._theme, gap, look.EDGE)
        return self._gaps


def _first(words, number):
    return " ".join(words.split(" ")[:number])


def _width(theme, name, size, left):
    """Return how much room a title takes, with what is free between its words."""
    return theme.width(name, size) + (theme.px(PAD) + theme.width(left, look.SMALL) if left else 0)


def _wider(theme, name, size, left):
    """Return how much room a title takes that has two rows of words."""
    return max(theme.width(name, size), theme.width(left, look.SMALL))


def _differs(pane, world, marks):
    return pane.turn is not None or pane.differs(world, marks)


def _split(area, number, columns, high, gap):
    """Return `number` rects of one size in columns of `area`, with `high` pixels free above each and gaps between."""
    rows = number // columns
    wide, tall = (area.width - (columns - 1) * gap) // columns, (area.height - (rows - 1) * gap) // rows
    places = [divmod(k, columns) for k in range(number)]
    corners = [(area.x + column * (wide + gap), area.y + row * (tall + gap)) for row, column in places]
    return [pygame.Rect(x, y + high, wide, max(1, tall - high)) for x, y in corners]


def _gaps(titles, rects, gap):
    """Return the gaps at the right of all panes and below them, but for those of the last column and row."""
    panes = [title.union(rect) for title, rect in zip(titles, rects, strict=True)]
    last = panes[-1]
    right = [pygame.Rect(pane.right, pane.y, gap, pane.height) for pane in panes if pane.x < last.x]
    below = [
        pygame.Rect(pane.x, pane.bottom, pane.width + gap * (pane.x < last.x), gap) for pane in panes if pane.y < last.y
    ]
    return right + below


def _moved(view, x, y):
    """Return the view moved by pixels."""
    frame = view.frame and (view.frame[0] + x, view.frame[1] + y, *view.frame[2:])
    return replace(view, left=view.left + x, top=view.top + y, frame=frame)
