"""The gallery: a page of pictures, a shelf of shipped scenes that run, and one for each kind of the player's files."""

import pygame

from game.play.controls import keymap
from game.play.pages.file_shelf import BY_AGE, BY_NAME, REPLAYS, SCENES, STAMPS, FileShelf
from game.play.pages.gallery_head import GalleryHead, ShelfAction
from game.play.pages.shipped_scenes import ShippedScenes
from game.play.pages.tile_grid import NAME, PAD, TileGrid
from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.input import key_name
from game.play.ui.scroll import thumb
from game.play.ui.text_line import TYPING_KEYS, TextLine, types

ARROWS = {pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1)}
ENTERS = pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE
GOES_ON = {
    *("view.toggle_help", "view.toggle_fullscreen", "view.toggle_sound"),
    *("files.show_scenes", "files.open_scenes", "files.open_stamps", "files.shoot_window"),
}
POINTING = pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION, pygame.MOUSEWHEEL


class GalleryPage:
    """The page."""

    fills_window = True

    def __init__(self, display, sessions, files, stamps, background, notices):
        self._display, self._notices = display, notices
        self.shown = False
        shipped = ShippedScenes(sessions, display, background, is_open=lambda: self.shown)
        kinds = (SCENES, files.open), (STAMPS, stamps.take), (REPLAYS, files.open)
        self.shelves = shipped, *(FileShelf(*kind, display, background, notices) for kind in kinds)
        self.shelf = self.shelves[0]
        self.chosen = 0
        self._typing = None  # the TextLine of the name that is being changed
        self._top = 0  # the first row that shows
        self._drawn = None  # what the page looks like but for its pictures
        self._now_s = 0.0

    def toggle(self, number):
        """Open the shelf of that number, or close the gallery where it is open already."""
        if self.shown and self.shelf is self.shelves[number]:
            self.close()
        else:
            self._look_at(self.shelves[number])

    def close(self):
        """Close the gallery."""
        self._end_typing(True)
        self.shown = False
        self._display.lay_out_anew()

    def forget(self):
        """Draw everything next time."""
        self._drawn = None

    def handle_events(self, events, now_s, mouse_pos):
        """Handle what is meant for the page and return the other events."""
        self._now_s = now_s
        return [event for event in events if not (self.shown and self._handle(event))]

    def draw(self, surface):
        """Bring the page up to date on the window; return the rects that changed."""
        grid = self._grid
        tiles = grid.tiles(self._top)
        room = {number: grid.picture_rect(rect) for number, rect in tiles.items()}
        moved = self.shelf.run(self._now_s, {number: rect.size for number, rect in room.items()})
        drawing = self._strokes(surface, grid, tiles)
        if drawing != self._drawn:
            self._drawn = drawing
            surface.fill(self._display.theme.rgb(look.SUNKEN))
            draw_list.draw(surface, self._display.theme, drawing)
            moved = room
        for number in moved:
            self._draw_picture(surface, number, room[number])
        return [surface.get_rect()] if moved is room else [room[number] for number in moved]

    def tile(self, number):
        """Return the rect in the window of a scene's tile, or None while it is scrolled out of view."""
        return self._grid.tiles(self._top).get(number)

    def tab(self, number):
        """Return the rect in the window of a shelf's title."""
        return self._head().tab(number)

    def action(self, words):
        """Return the rect in the window of what can be done, by its words; None if it cannot."""
        return {each.words: rect for rect, each in self._head().places()}.get(words)

    @property
    def actions(self):
        """What can be done with the chosen file and its shelf: ShelfActions."""
        shelf, found = self.shelf, ()
        if shelf.lets_go and len(shelf):
            other = BY_NAME if shelf.order == BY_AGE else BY_AGE
            found = (
                ShelfAction("Rename", "R", pygame.K_r, False, self._begin_typing),
                ShelfAction("Delete", "Del", pygame.K_DELETE, False, self._put_away),
                ShelfAction(other, "S", pygame.K_s, False, self._sort),
            )
        if shelf.can_take_back:
            found = (*found, ShelfAction("Undo", key_name("Ctrl+Z"), pygame.K_z, True, self._take_back))
        return found

    def _head(self):
        titles = tuple(each.title for each in self.shelves)
        return GalleryHead(self._display.theme, self._grid.page, titles, self.actions)

    # --- what it looks like ---

    def _strokes(self, surface, grid, tiles):
        strokes = [(draw_list.fill, surface.get_rect(), look.SUNKEN)]
        strokes += self._head().strokes(self.shelves.index(self.shelf))
        for number, rect in tiles.items():
            strokes += self._tile_strokes(number, rect, grid.picture_rect(rect))
        return [*strokes, *self._empty(grid.page), *self._thumb(grid), *self._about(grid.page)]

    def _empty(self, page):
        """Yield the strokes of what there is to say of a shelf without scenes."""
        theme = self._display.theme
        lines = theme.lines(self.shelf.empty, look.BODY, page.width) if not len(self.shelf) else ()
        line = theme.line_height(look.BODY)
        for number, each in enumerate(lines):
            place = pygame.Rect(page.x, page.centery + number * line, page.width, line)
            yield draw_list.words, place, each, look.BODY, look.DIM, 0.5

    def _thumb(self, grid):
        """Return the strokes of the scroll bar's thumb, where not all rows show."""
        page, px = grid.page, self._display.theme.px
        track = pygame.Rect(page.right + px(PAD) // 2, page.y, px(4), page.height)
        return thumb(self._display.theme, track, self._top, grid.rows_in_view, grid.rows)

    def _tile_strokes(self, number, rect, picture):
        px, chosen = self._display.theme.px, number == self.chosen
        strokes = [(draw_list.box, rect, look.HOVER if chosen else look.RAISED, px(5))]
        if chosen:
            strokes.append((draw_list.ring, rect, look.ACCENT, px(5), max(1, px(2))))
        if self.shelf.picture(number) is None:
            strokes.append((draw_list.words, picture, self.shelf.waiting, look.SMALL, look.FAINT, 0.5))
        words = pygame.Rect(rect.x + px(8), rect.bottom - px(NAME), rect.width - 2 * px(8), px(NAME))
        name, colour = self.shelf.name(number), look.TEXT if chosen else look.DIM
        if chosen and self._typing:
            strokes.append((draw_list.box, words.inflate(0, -px(2)), look.SUNKEN, px(4)))
            name, colour = self._typing.text + "|", look.DIM if self._typing.fresh else look.HANDLE
        return [*strokes, (draw_list.words, words, name, look.SMALL, colour, 0.5)]

    def _about(self, page):
        """Return the strokes of the sentence on the chosen scene."""
        theme = self._display.theme
        line = theme.line_height(look.SMALL)
        text = self._notices.text or (self.shelf.about(self.chosen) if len(self.shelf) else "")
        foot = pygame.Rect(page.x, page.bottom, page.width, line)
        lines = theme.lines(text, look.SMALL, page.width)
        return [
            (draw_list.words, foot.move(0, number * line), each, look.SMALL, look.TEXT, 0.5)
            for number, each in enumerate(lines)
        ]

    def _draw_picture(self, surface, number, room):
        picture = self.shelf.picture(number)
        if picture:
            surface.fill(self._display.theme.rgb(look.SUNKEN), room)
            surface.blit(picture, picture.get_rect(center=room.center))

    # --- events ---

    def _handle(self, event):
        if event.type == pygame.KEYDOWN:
            return self._key(event)
        if event.type in POINTING:
            self._point(event)
            return True
        return False

    def _key(self, event):
        """Handle a key; return False for those of commands that do not touch the sand."""
        if self._typing:
            return self._type(event)
        ctrl = bool(event.mod & keymap.CTRL)
        action = next((each for each in self.actions if (each.key, each.ctrl) == (event.key, ctrl)), None)
        if action:
            action.act()
        elif event.key in ARROWS and not event.mod & keymap.CTRL:
            dx, dy = ARROWS[event.key]
            self._choose(self.chosen + dx + dy * self._grid.columns)
        elif event.key in ENTERS:
            self._open()
        elif event.key in (pygame.K_HOME, pygame.K_END):
            self._choose(0 if event.key == pygame.K_HOME else len(self.shelf) - 1)
        elif event.key == pygame.K_TAB:
            self._look_at(self.shelves[(self.shelves.index(self.shelf) + 1) % len(self.shelves)])
        elif event.key == pygame.K_ESCAPE:
            self.close()
        else:
            return keymap.command(event) not in GOES_ON
        return True

    def _type(self, event):
        """Type a name; return False for what is none of its keys."""
        if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_ESCAPE):
            self._end_typing(event.key == pygame.K_ESCAPE)
        elif event.key in TYPING_KEYS or (types(event.unicode) and not event.mod & keymap.CTRL):
            self._typing = self._typing.typed(event.key, event.unicode)
        return True

    def _begin_typing(self):
        self._typing = TextLine(self.shelf.name(self.chosen))

    def _end_typing(self, forgets):
        """Call the chosen file what has been typed, or leave it as it was."""
        typed, self._typing = self._typing, None
        if typed and not forgets:
            self.chosen = self.shelf.rename(self.chosen, typed.text.strip())
            self._choose(self.chosen)
            self.forget()

    def _put_away(self):
        self.shelf.put_away(self.chosen)
        self.chosen = max(0, min(self.chosen, len(self.shelf) - 1))
        self._choose(self.chosen)
        self.forget()

    def _sort(self):
        path = self.shelf.paths[self.chosen]
        self.shelf.sort()
        self._choose(self.shelf.paths.index(path) if path in self.shelf.paths else 0)
        self.forget()

    def _take_back(self):
        number = self.shelf.take_back()
        self._choose(self.chosen if number is None else number)
        self.forget()

    def _point(self, event):
        if event.type == pygame.MOUSEWHEEL:
            self._scroll(self._top - (event.y > 0) + (event.y < 0))
            return
        pressed = event.type == pygame.MOUSEBUTTONDOWN and event.button == 1
        under = next(
            (number for number, rect in self._grid.tiles(self._top).items() if rect.collidepoint(event.pos)), None
        )
        if self._typing and pressed:
            self._end_typing(False)
            return
        if under is not None and event.type != pygame.MOUSEBUTTONUP and not self._typing:
            self.chosen = under
        if not pressed:
            return
        for rect, action in self._head().places():
            if rect.collidepoint(event.pos):
                action.act()
                return
        for number, shelf in enumerate(self.shelves):
            if self.tab(number).collidepoint(event.pos):
                self._look_at(shelf)
        if under is not None:
            self._open()

    def _look_at(self, shelf):
        self._typing = None
        self.shelf, self.shown, self.chosen, self._top = shelf, True, 0, 0
        shelf.begin()
        self.chosen = shelf.first
        self._choose(self.chosen)
        self.forget()

    def _choose(self, number):
        if 0 <= number < len(self.shelf):
            self.chosen = number
            row = number // self._grid.columns
            self._scroll(min(max(self._top, row - self._grid.rows_in_view + 1), row))

    def _scroll(self, top):
        self._top = min(max(top, 0), max(0, self._grid.rows - self._grid.rows_in_view))

    def _open(self):
        if len(self.shelf):
            self.close()
            self.shelf.open(self.chosen)

    @property
    def _grid(self):
        """The TileGrid of the shelf."""
        return TileGrid(self._display.theme, self._display.window.size, len(self.shelf))
