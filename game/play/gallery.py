"""The gallery: the saved scenes as small pictures, of which one can be opened by pointer or keyboard."""

from functools import partial

import pygame

from game.play.card import draw_box
from game.play.ui import paint
from game.play.ui import theme as look
from game.world.places import folder_of

TILE = 168, 128  # pixels at scale 1, picture and name
NAME = 24  # height of the name
GAP = 10
HEAD = 40
MARGIN = 24  # around the card
BATCH = 6  # pictures read at a time
ARROWS = {pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1)}
ENTERS = pygame.K_RETURN, pygame.K_KP_ENTER


def saved_scenes():
    """Return the paths of the saved scenes, the newest first."""

    def age(path):
        try:
            return path.stat().st_mtime_ns
        except OSError:
            return 0

    return sorted(folder_of("scenes").glob("*.png"), key=age, reverse=True)


class Gallery:
    """The list of saved scenes, if it is open."""

    def __init__(self, toy):
        self._toy = toy
        self.shown = False
        self.chosen = 0
        self.paths = []
        self._sprites = {}  # path: a surface, or None where there is no picture in it
        self._top = 0  # the first row that shows

    def toggle(self):
        """Open the list, or close it."""
        self.shown = not self.shown
        self._toy.refresh()
        if self.shown:
            self.paths, self._sprites, self.chosen, self._top = saved_scenes(), {}, 0, 0
            self._read_on()

    def listen(self, events, now_s, mouse_pos):
        """Obey what is meant for the list and return the other events."""
        if events:
            self._toy.refresh()
        return [event for event in events if not (self.shown and self._hear(event))]

    def draw(self, surface, theme, area):
        """Draw the list over the sand."""
        card, px = self._card(), theme.px
        draw_box(surface, theme, card)
        head = card.x + px(GAP), card.y, card.width - 2 * px(GAP), px(HEAD)
        paint.words(surface, theme, head, "Saved scenes", look.HEADING, look.HANDLE, 0)
        paint.words(surface, theme, head, "Enter opens    Esc closes", look.SMALL, look.FAINT, 1)
        if not self.paths:
            said = "Nothing is saved yet: Ctrl+S saves the scene as it is."
            paint.words(surface, theme, card, said, look.BODY, look.DIM, 0.5)
        for number, rect in self._tiles():
            self._draw_tile(surface, theme, number, rect)

    def tile(self, number):
        """Return the rect in the window of a scene's tile, or None while it is scrolled out of view."""
        return dict(self._tiles()).get(number)

    def _draw_tile(self, surface, theme, number, rect):
        px, path = theme.px, self.paths[number]
        chosen = number == self.chosen
        paint.box(surface, theme, rect, look.HOVER if chosen else look.RAISED, px(5))
        if chosen:
            paint.ring(surface, theme, rect, look.ACCENT, px(5), max(1, px(2)))
        room = rect.inflate(-2 * px(6), -2 * px(6))
        room.height -= px(NAME) - px(4)
        sprite = self._sprites.get(path)
        if sprite:
            scaled = _fitting(sprite, room.size)
            surface.blit(scaled, scaled.get_rect(center=room.center))
        elif path in self._sprites:
            paint.words(surface, theme, room, "unreadable", look.SMALL, look.FAINT, 0.5)
        words = pygame.Rect(rect.x + px(8), rect.bottom - px(NAME), rect.width - 2 * px(8), px(NAME))
        paint.words(surface, theme, words, path.stem, look.SMALL, look.TEXT if chosen else look.DIM, 0.5)

    def _hear(self, event):
        if event.type == pygame.KEYDOWN:
            return self._key(event)
        if event.type == pygame.MOUSEWHEEL:
            self._scroll(self._top - (1 if event.y > 0 else -1))
            return True
        if event.type in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN):
            if not self._card().collidepoint(event.pos):
                return False
            under = next((number for number, rect in self._tiles() if rect.collidepoint(event.pos)), None)
            if under is not None:
                self.chosen = under
                if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
                    self._open()
            return True
        return False

    def _key(self, event):
        if event.key == pygame.K_ESCAPE:
            self.toggle()
        elif event.key in ENTERS:
            self._open()
        elif event.key in ARROWS:
            dx, dy = ARROWS[event.key]
            self._choose(self.chosen + dx + dy * self._columns())
        elif event.key in (pygame.K_HOME, pygame.K_END):
            self._choose(0 if event.key == pygame.K_HOME else len(self.paths) - 1)
        else:
            return False
        return True

    def _choose(self, number):
        if 0 <= number < len(self.paths):
            self.chosen = number
            row = number // self._columns()
            self._scroll(min(max(self._top, row - self._rows() + 1), row))

    def _scroll(self, top):
        rows = -(-len(self.paths) // self._columns())
        self._top = min(max(top, 0), max(0, rows - self._rows()))

    def _open(self):
        if self.paths:
            self.toggle()
            self._toy.files.open(self.paths[self.chosen])

    # --- where things lie ---

    def _room(self):
        """Return the rect that the card may take at most."""
        px = self._toy.theme.px
        return self._toy.layout.sand.inflate(-2 * px(MARGIN), -2 * px(MARGIN))

    def _card(self):
        px, card = self._toy.theme.px, self._room()
        rows = min(self._rows(), max(1, -(-len(self.paths) // self._columns())))
        card.height = px(HEAD) + rows * (px(TILE[1]) + px(GAP))
        return card

    def _columns(self):
        px = self._toy.theme.px
        return max(1, (self._room().width - px(GAP)) // (px(TILE[0]) + px(GAP)))

    def _rows(self):
        px = self._toy.theme.px
        return max(1, (self._room().height - px(HEAD)) // (px(TILE[1]) + px(GAP)))

    def _tiles(self):
        """Yield (number, rect) of the scenes that show."""
        px, card, columns = self._toy.theme.px, self._card(), self._columns()
        wide = (card.width - px(GAP)) // columns
        for number in range(self._top * columns, min(len(self.paths), (self._top + self._rows()) * columns)):
            row, column = divmod(number - self._top * columns, columns)
            x, y = card.x + px(GAP) + column * wide, card.y + px(HEAD) + row * (px(TILE[1]) + px(GAP))
            yield number, pygame.Rect(x, y, wide - px(GAP), px(TILE[1]))

    # --- pictures ---

    def _read_on(self):
        """Read the next few pictures beside the frames."""
        next_ones = [path for path in self.paths if path not in self._sprites][:BATCH]
        if next_ones and self.shown:
            self._toy.background.do(partial(_thumbnails, next_ones), self._take)

    def _take(self, found):
        for path, size, data in found:
            self._sprites[path] = pygame.image.frombytes(data, size, "RGB") if size else None
        self._toy.refresh()
        self._read_on()


def _thumbnails(paths):
    """Return [(path, size, RGB bytes)], with (path, None, None) for a file without a picture."""
    from PIL import Image

    found = []
    for path in paths:
        try:
            with Image.open(path, formats=("PNG",)) as image:
                small = image.convert("RGB")
                small.thumbnail((3 * TILE[0], 3 * TILE[1]), Image.Resampling.BOX)
                found.append((path, small.size, small.tobytes()))
        except Exception:  # Pillow's decoders raise whatever a damaged file makes them trip over
            found.append((path, None, None))
    return found


def _fitting(sprite, room):
    """Return the sprite as large as `room` allows."""
    scale = min(room[0] / sprite.get_width(), room[1] / sprite.get_height())
    size = max(1, round(sprite.get_width() * scale)), max(1, round(sprite.get_height() * scale))
    return pygame.transform.smoothscale(sprite, size) if scale < 1 else pygame.transform.scale(sprite, size)
