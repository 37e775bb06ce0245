"""The grid of the gallery: where its tiles lie between head and foot."""

from functools import cached_property

import pygame

from game.play.pages.gallery_head import GAP, HEAD

PAD = 20  # pixels at scale 1: around the page
FOOT = 46
NAME = 24  # height of a name under its picture
EDGE = 5  # around a picture in its tile
NARROWEST = 132  # tile; what does not fit then is scrolled to
LEAST = 6  # tiles that a page has room for: fewer are no larger
PICTURE = 0.72  # height of a picture, as a share of its width


class TileGrid:
    """So many tiles on a page in a window of a size, as large as lets all of them be seen, if possible."""

    def __init__(self, theme, size, count):
        self._px, self._count = theme.px, count
        px, (width, height) = theme.px, size
        self.page = pygame.Rect(px(PAD), px(HEAD), width - 2 * px(PAD), height - px(HEAD) - px(FOOT))

    @cached_property
    def _laid(self):
        """(Columns, rows in view, tile size)."""
        page, px = self.page, self._px
        most = max(1, (page.width + px(GAP)) // (px(NARROWEST) + px(GAP)))
        for columns in range(1, most + 1):
            wide = (page.width + px(GAP)) // columns - px(GAP)
            high = round(PICTURE * wide) + px(NAME)
            rows = max(1, page.height // (high + px(GAP)))
            if columns * rows >= max(LEAST, self._count):
                break
        return columns, rows, (wide, min(high, page.height))

    @property
    def columns(self):
        """How many tiles are side by side."""
        return self._laid[0]

    @property
    def rows_in_view(self):
        """How many rows of tiles there is room for."""
        return self._laid[1]

    @property
    def rows(self):
        """How many rows there are."""
        return -(-self._count // self.columns)

    def tiles(self, top):
        """Return {number: rect} of the tiles that show, with the row `top` at the top."""
        px, (columns, rows, (wide, high)) = self._px, self._laid
        y = self.page.y + max(0, (self.page.height - min(rows, self.rows) * (high + px(GAP))) // 2)
        x = self.page.x + max(0, columns - self._count) * (wide + px(GAP)) // 2
        shown = range(top * columns, min(self._count, (top + rows) * columns))
        places = ((number, divmod(number - top * columns, columns)) for number in shown)
        return {
            number: pygame.Rect(x + column * (wide + px(GAP)), y + row * (high + px(GAP)), wide, high)
            for number, (row, column) in places
        }

    def picture_rect(self, tile):
        """Return what of a tile its picture may fill."""
        edge = self._px(EDGE)
        return pygame.Rect(tile.x + edge, tile.y + edge, tile.width - 2 * edge, tile.height - self._px(NAME) - edge)
