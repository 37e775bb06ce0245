"""The plots: what a session's sand does, drawn live beside it, and saved as tables of numbers."""

import math
import time
from functools import partial
from itertools import pairwise

import pygame

from game.play.plots import charts
from game.play.plots.audit_card import card, heights, widths
from game.play.plots.card_strip import CardStrip
from game.play.plots.comparison_cards import comparison_card, quantities
from game.play.plots.material_cards import amounts_card, books_card
from game.play.plots.pile_card import pile_card
from game.play.plots.reactions_card import reactions_card
from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.view.swatches import colours_of_worlds, swatches_of
from game.world.files.atomic import save_as_new
from game.world.files.paths import numbered, save_new
from game.world.sand.sand_colours import COLOURS
from game.world.sessions.measurements import COMMON_COLUMNS, PROFILE_COLUMNS, Measurements, csv
from game.world.sessions.session import BUDGET_NS

SAMPLE_S = 0.25
SHARE = 50  # sampling may take one part in 50 of the time; on a huge lattice it is done less often
LONGEST_S = 5.0  # … but not for longer than this
WATCH_SHARE = 20  # counting the reactions of one iteration in each frame may take one part in 20
GAP = 6  # pixels at scale 1 between cards
LEAST_CARD = 144  # pixels at scale 1: width of a card whose title and value have room
LOWEST_CARD, LOWEST_COMPARED = 86, 124  # pixels at scale 1: height of a card whose curves have room
MOST_AUDIT = 0.44  # of the cards' length, that the audit of coloured sand may take


class Plots:
    """The cards. Closed, they measure nothing."""

    def __init__(self, sessions, display, frame_stats, background, notices):
        self._sessions, self._display, self._frame_stats = sessions, display, frame_stats
        self._background, self._notices = background, notices
        self._lacks_room = False
        self._set_row = None  # (scene, row): where the player wants to measure in that scene
        self.measurements = None  # since the plots were opened
        self._compared = {}  # {name: Measurements} of worlds side by side
        self._strip = CardStrip()
        self._account = None  # as it was at the last sample
        self._since_s = self._next_s = self._next_watch_s = 0.0
        self._slowest_ns = 0

    @property
    def shown(self):
        """Whether they are open."""
        return self._display.plots_shown

    def toggle(self):
        """Open the plots, or close them."""
        self._display.plots_shown = not self.shown
        self.measurements = None
        self._display.lay_out_anew()

    @property
    def own_row(self):
        """The row that the scene itself asks for: the middle of its glass, or of the scene."""
        neck, height = self._sessions.now.scene.neck, self._sessions.now.world.shape[0]
        return height // 2 if neck is None or neck >= height else neck

    @property
    def measured_row(self):
        """The row at which flow is measured: the scene's, or the one that was set in its place."""
        scene, row = self._set_row or (None, 0)
        rows = self._sessions.now.world.shape[0]  # a quarter turn may have left fewer than there were
        return min(row, rows) if scene is self._sessions.now.scene else self.own_row

    @measured_row.setter
    def measured_row(self, row):
        self._set_row = self._sessions.now.scene, row

    def update(self, now_s):
        """Measure if it is time to; say so when there is no more room."""
        self._look_for_room()
        if not self.shown:
            return
        self._slowest_ns = max(self._slowest_ns, self._frame_stats.frame_ns)
        now, found = self._sessions.now, self.measurements
        fits = found and (found.session, found.row, found.codes) == (now, self.measured_row, now.world.codes)
        fits = fits and len(found.pile.heights) == now.world.shape[1]
        fits = fits and all(each.codes == each.session.world.codes for each in self._compared.values())
        if fits and now_s < self._next_s:
            self._watch(now_s)
            return
        begin = time.perf_counter()
        if not fits:
            self._begin()
            self._since_s = now_s
        for each in self._compared.values():
            each.follow(now_s - self._since_s, self._slowest_ns / 1e6)
        self._next_s = now_s + min(max(SAMPLE_S, SHARE * (time.perf_counter() - begin)), LONGEST_S)
        self._slowest_ns, self._account = 0, self._sessions.now.account
        self._strip.renew()

    def _begin(self):
        """Measure anew from here on."""
        session, row = self._sessions.now, self.measured_row
        self._compared = {name: Measurements(each, row) for name, each in session.sessions.items()}
        self.measurements = next(each for each in self._compared.values() if each.session is session)

    def compared_table(self):
        """Return (columns, rows) of what was measured in all worlds; the present alone, where that is nothing."""
        if not self.measurements:
            self._begin()
            for each in self._compared.values():
                each.follow(0.0, 0.0)
            compared, self.measurements = self._compared, None
        else:
            compared = self._compared
        alike = len({each.codes for each in compared.values()}) == 1
        columns = next(iter(compared.values())).lasting_columns
        columns = columns if alike else COMMON_COLUMNS
        return ("world", *columns), [
            (name, *row[: len(columns)]) for name, each in compared.items() for row in each.rows()
        ]

    def _watch(self, now_s):
        """Count reactions if there are any to count and it is time to."""
        if now_s < self._next_watch_s or self._strip.busy or self._sessions.now.rule.codes.is_sand:
            return
        begin = time.perf_counter()
        self.measurements.watch()
        self._next_watch_s = now_s + min(WATCH_SHARE * (time.perf_counter() - begin), LONGEST_S)

    def _look_for_room(self):
        lacked, self._lacks_room = self._lacks_room, self.shown and self._display.layout.plots is None
        if self._lacks_room and not lacked:
            key = " P hides the panel and makes room." if self._display.hidden_panel_makes_room else ""
            self._notices.say(f"The window is too small for the plots.{key}", holds=lambda: self._lacks_room)

    def forget(self):
        """Draw the cards anew next time."""
        self._strip.forget()

    def draw(self, surface):
        """Draw the cards if they look different; return the rects that changed."""
        area = self._display.layout.plots
        if not area or not self.measurements or self.measurements.codes != self._sessions.now.rule.codes:
            return []  # a world that became another one since is measured in the next frame
        return self._strip.draw(surface, self._display.theme, area, partial(self._placed, area))

    def save(self):
        """Save what was measured so far: its history as one table, the pile's profile as another."""
        if not self.measurements:
            self._notices.say("Nothing has been measured yet. L opens the plots.")
            return
        name, columns, rows = self._sessions.now.scene.name, self.measurements.columns, self.measurements.rows()
        pile = self.measurements.pile
        profile = list(zip(range(len(pile.heights)), pile.heights.tolist(), pile.surface.tolist(), strict=True))

        def work():
            path = save_new("measures", name, ".csv", csv(columns, rows))
            save_as_new(numbered(path.with_name(f"{path.stem} profile.csv")), csv(PROFILE_COLUMNS, profile))
            return path

        say = self._notices.say
        self._background.do(work, lambda path: say(f"Saved as {path}, with the profile beside it"), writes=True)

    # --- the cards ---

    def _placed(self, area):
        """Return [(rect, function that returns the strokes of the card there)]."""
        gap, px = self._display.theme.px(GAP), self._display.theme.px
        tall, placed = area.height > area.width, []
        length, least = area.width, LEAST_CARD
        if tall:
            length, least = area.height, LOWEST_CARD if len(self._compared) < 2 else LOWEST_COMPARED
        cards = self._fitting(length // px(least))
        edges = self._edges(length, tall, cards)
        for each, (start, end) in zip(cards, pairwise(edges), strict=True):
            if tall:
                rect = pygame.Rect(area.x, area.y + start, area.width, end - start)
            else:
                rect = pygame.Rect(area.x + start, area.y, end - start, area.height)
            rect = rect.inflate(-gap, -gap)
            placed.append((rect, partial(each, rect)))
        return placed

    def _fitting(self, most):
        """Return the functions that draw the cards that there is room for; on the stage all that is of the sand."""
        cards = list(self._cards())
        for each in (self._frames, self._audit):
            if each in cards and (len(cards) > most or self._display.on_stage):
                cards.remove(each)
        return cards[: max(1, most)]

    def _cards(self):
        """Return the functions that draw the cards: of sand how it flows and lies, of others how much there is."""
        if len(self._compared) > 1:
            theme, colours = self._display.theme, colours_of_worlds(self._display.theme.colours, self._compared)
            return [partial(self._comparison, theme, quantity, colours) for quantity in quantities(self.measurements)]
        if self._sessions.now.rule.codes.is_sand:
            return self._flow, self._filling, self._pile, self._frames, self._audit
        return self._amounts, self._reactions, self._books, self._frames, self._audit

    def _comparison(self, theme, quantity, colours, rect):
        return comparison_card(theme, rect, quantity, self._compared, colours)

    def _amounts(self, rect):
        rule = self._sessions.now.rule
        names = {name: sorted(rule.codes.codes_of(name)) for name in rule.codes.told_of(rule.codes.filled)}
        samples = [(each.now, each.amounts) for each in self.measurements.samples]
        colours = swatches_of(self._display.theme.colours, rule.definition.materials)
        return amounts_card(self._display.theme, rect, samples, names, colours)

    def _reactions(self, rect):
        reactions, speed = self.measurements.reactions(), self._sessions.now.clock.speed
        return reactions_card(self._display.theme, rect, self._nows(), reactions, speed)

    def _books(self, rect):
        books = sorted(self._sessions.now.rule.definition.books, key=lambda book: len(book.but))
        return books_card(self._display.theme, rect, self._account, self._amounts_now, books)

    def _edges(self, length, tall, cards):
        """Return where the cards begin and end along the area; the audit of coloured sand may take more than others."""
        count = len(cards)
        if self._audit not in cards:
            return [length * number // count for number in range(count + 1)]
        account, audit = self._account, length // count
        if account.mixed:
            theme, gap = self._display.theme, self._display.theme.px(GAP)
            most = round(MOST_AUDIT * length)
            if not tall:
                most = min(most, length - (count - 1) * theme.px(LEAST_CARD))
            wanted = (
                heights(theme, account) if tall else widths(theme, account, self._display.layout.plots.height - gap)
            )
            audit = max(audit, next((side + gap for side in wanted if side + gap <= most), most))
        rest = length - audit
        return [*(rest * number // (count - 1) for number in range(count)), length]

    def _flow(self, rect):
        flows = self.measurements.flows()
        known = [each for each in flows if not math.isnan(each)]
        now = "" if not flows or math.isnan(flows[-1]) else f"{flows[-1]:.3g} grains/it."
        title = f"Flow at row {self.measurements.row:,}"
        strokes, room = charts.card(self._display.theme, rect, title, now, "Flow")
        strokes, room = self._named(strokes, room, "grains per iteration")
        room, foot = charts.with_foot(self._display.theme, room, self._nows())
        low = -charts.round_up(-min([0.0, *known]))
        high = charts.round_up(max([0.1, *known]))
        figures, room = self._scale(room, low, high)
        lines = charts.curves(room, [(self._nows(), flows, look.ACCENT)], low, high)
        return strokes + foot + figures + lines

    def _filling(self, rect):
        samples, last = self.measurements.samples, self.measurements.samples[-1]
        strokes, room = charts.card(self._display.theme, rect, "Grains above", f"{last.above:,}")
        below = (room.x, room.y, room.width, self._display.theme.px(charts.HEAD))
        strokes.append((draw_list.words, below, "below", look.SMALL, look.RING, 0))
        strokes.append((draw_list.words, below, f"{last.below:,}", look.SMALL, look.RING, 1))
        room = pygame.Rect(room.x, below[1] + below[3], room.width, room.height - below[3])
        strokes, room = self._named(strokes, room, "grains")
        room, foot = charts.with_foot(self._display.theme, room, self._nows())
        most = charts.round_up(max(1, *(max(each.above, each.below) for each in samples)))
        figures, room = self._scale(room, 0, most)
        numbers = ([e.above for e in samples], look.ACCENT), ([e.below for e in samples], look.RING)
        series = [(self._nows(), *each) for each in numbers]
        return strokes + foot + figures + charts.curves(room, series, 0, most)

    def _pile(self, rect):
        return pile_card(self._display.theme, rect, self.measurements, self._display.on_stage)

    def _frames(self, rect):
        samples, now = self.measurements.samples, _spell_ms(self.measurements.samples[-1].frame_ms)
        strokes, room = charts.card(self._display.theme, rect, "Slowest frame", now, "Frame")
        numbers, budget = [each.frame_ms for each in samples], BUDGET_NS / 1e6
        high = charts.round_up(max(2 * budget, *numbers))
        figures, room = self._scale(room, 0, high, [(budget, f"{budget:g} ms")])
        level = room.bottom - 1 - round(budget / high * (room.height - 1))
        strokes.append((draw_list.fill, (room.x, level, room.width, self._display.theme.px(1)), look.EDGE))
        lines = charts.curves(room, [([each.seconds for each in samples], numbers, look.DIM)], 0, high)
        return strokes + figures + lines

    def _audit(self, rect):
        session = self._sessions.now
        theme, materials = self._display.theme, session.rule.definition.materials
        if session.rule.codes.is_sand:
            swatches = [theme.colours.swatch(number) for number in range(len(COLOURS))]
        else:
            swatches = swatches_of(theme.colours, materials)
        return card(theme, rect, self._account.met(self._amounts_now), self._amounts_now, swatches)

    @property
    def _amounts_now(self):
        return self.measurements.samples[-1].amounts

    def _named(self, strokes, room, name):
        """Return strokes with the name of the upright axis, on the stage, and the rect left for the chart."""
        if not self._display.on_stage:
            return strokes, room
        return charts.with_name(self._display.theme, strokes, room, name)

    def _nows(self):
        return [each.now for each in self.measurements.samples]

    def _scale(self, room, low, high, marks=()):
        """Return (figures at the left of `room`, what is left of it): those of `marks`, then the ends and 0."""
        ends = [(each, charts.figure(each)) for each in dict.fromkeys((high, low, 0))]
        return charts.scale(self._display.theme, room, [*marks, *ends], low, high)


def _spell_ms(ms):
    """Return a time in at most six characters."""
    return f"{ms:.1f} ms" if ms < 99.95 else f"{ms:.0f} ms" if ms < 999.5 else f"{ms / 1e3:.1f} s"
