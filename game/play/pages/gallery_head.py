"""The head of the gallery: the titles of its shelves, a hint, and what can be done with the chosen file."""

from typing import NamedTuple

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look

HEAD, GAP = 40, 10  # pixels at scale 1: its height, and what is free around what can be clicked
PILL = 8  # from the edge of what can be clicked to its words
HINTS = (
    "Arrows choose    Enter opens    Tab: next shelf    Esc closes",
    *("Enter opens    Tab: next shelf    Esc closes", "Enter opens    Esc closes", "Esc closes", ""),
)


class ShelfAction(NamedTuple):
    """Something that can be done by a key or a click."""

    words: str
    key_label: str
    key: int
    ctrl: bool  # is to be held with it
    act: object  # a function without arguments


class GalleryHead(NamedTuple):
    """The head as it is laid out above a page."""

    theme: look.Theme
    page: pygame.Rect
    titles: tuple  # of the shelves
    actions: tuple  # of ShelfAction

    def tab(self, number):
        """Return the rect in the window of a shelf's title."""
        px, wide = self.theme.px, [self.theme.width(title, look.HEADING) for title in self.titles]
        x = self.page.x + sum(wide[:number]) + 2 * px(GAP) * number
        return pygame.Rect(x, 0, wide[number], px(HEAD))

    def places(self):
        """Return [(rect in the window, ShelfAction)], from right to left."""
        px, right, found = self.theme.px, self.page.right, []
        for each in reversed(self.actions):
            wide = self.theme.width(f"{each.words}  {each.key_label}", look.SMALL) + 2 * px(PILL)
            found.append((pygame.Rect(right - wide, px(GAP), wide, px(HEAD) - 2 * px(GAP)), each))
            right -= wide + px(GAP)
        return found

    def strokes(self, shown):
        """Return the strokes of the head, with the shelf of the number `shown` being looked at."""
        theme, places, strokes = self.theme, self.places(), []
        for number, title in enumerate(self.titles):
            colour = look.HANDLE if number == shown else look.FAINT
            strokes.append((draw_list.words, self.tab(number), title, look.HEADING, colour, 0))
        for rect, each in places:
            inner = rect.inflate(-2 * theme.px(PILL), 0)
            strokes.append((draw_list.box, rect, look.RAISED, theme.px(4)))
            strokes.append((draw_list.words, inner, each.words, look.SMALL, look.TEXT, 0))
            strokes.append((draw_list.words, inner, each.key_label, look.SMALL, look.FAINT, 1))
        left = self.tab(len(self.titles) - 1).right + theme.px(GAP)
        right = min((rect.x - theme.px(GAP) for rect, _ in places), default=self.page.right)
        free = pygame.Rect(left, 0, max(0, right - left), theme.px(HEAD))
        hint = next((each for each in HINTS if theme.width(each, look.SMALL) <= free.width), "")
        return [*strokes, (draw_list.words, free, hint, look.SMALL, look.FAINT, 1)]
