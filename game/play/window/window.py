"""The window: opens it, knows its size and pixels, and shows them by the cheapest way there is."""

import gc
import os
import statistics
import sys
import time
import warnings
from contextlib import suppress
from functools import cache

import numpy as np
import pygame

from game.play.window import icon

SMALLEST = (640, 480)  # that a window is made, where the desktop has room for it
LEAST_SURFACE = (320, 240)  # a smaller window shows the corner of a surface of this size
ROOM_FOR_DECORATION = (16, 64)  # pixels of the desktop that are left for the title bar and the desktop's own panels
SWITCH_S = 1.0  # within which a switch to or from full screen is done
SLOW_FLIP_MS = 3.0  # a flip that takes longer goes through software OpenGL: writing to the window is far cheaper
TITLE = "Sandglass"
INVISIBLE = ("offscreen", "dummy")  # drivers that SDL falls back on where there is no screen


class NoDisplayError(Exception):
    """There is no display to open a window on."""


class Window:
    """The one window, resizable, with 32-bit pixels."""

    def __init__(self, size, fullscreen=False):
        """Open a window of `size` (width, height) in pixels, or what of it fits the desktop.

        Raises NoDisplayError if there is no display.
        """
        self._title, self._aside = TITLE, None
        self.covered = False  # by what is drawn on `front`, over what is drawn on `surface`
        self._pointer = self._left = None  # where pointer and window were on the desktop before the last switch
        self._since_s = 0.0  # when that was
        try:
            _start_display()
            self._windowed_size = self._fitting(size)
            self.fullscreen = fullscreen
            self._open()
            self._avoid_slow_flips()
        except pygame.error as error:
            raise NoDisplayError(str(error)) from None
        pygame.key.set_repeat(350, 40)

    @property
    def surface(self):
        """The window's pixels, as pygame draws on them.

        Where the window is smaller than LEAST_SURFACE, or its pixels have other than 32 bits, they are a surface that
        is copied to it, so that all parts have room and can draw. Where it is covered, they are a surface behind it.
        """
        shown = pygame.display.get_surface()
        size = tuple(max(sides) for sides in zip(shown.get_size(), LEAST_SURFACE, strict=True))
        if not self.covered and size == shown.get_size() and shown.get_bytesize() == 4:
            self._aside = None
            return shown
        if self._aside is None or self._aside.get_size() != size:
            self._aside = pygame.Surface(size, 0, 32)
        return self._aside

    @property
    def front(self):
        """The pixels that are seen: those of the window itself while it is covered."""
        return pygame.display.get_surface() if self.covered else self.surface

    @property
    def size(self):
        """(width, height) of `surface` in pixels."""
        return self.surface.get_size()

    @property
    def hidden(self):
        """Whether nobody can see it: it is minimised, or on another workspace."""
        return not pygame.display.get_active()

    @property
    def map_rgb(self):
        """A function of red, green, blue that gives a pixel: the same one as long as pixels hold them alike."""
        return _mapper(self.surface.get_shifts()[:3])

    def toggle_fullscreen(self):
        """Switch to full screen, or back to the window as it was."""
        self.fullscreen = not self.fullscreen
        self._pointer, self._left = _on_desktop(pygame.mouse.get_pos()), pygame.display.get_window_position()
        self._since_s = time.monotonic()
        window = _of_sdl()
        if self.fullscreen:
            window.set_fullscreen(True)  # at the desktop's resolution; SDL remembers the window's place and size
        else:
            window.set_windowed()

    def find_pointer(self):
        """After a switch, put the pointer where it was on the desktop: else X11 tells its place only when it moves."""
        if self._pointer is None:
            return
        place = pygame.display.get_window_position()
        if time.monotonic() - self._since_s > SWITCH_S:
            self._pointer = None
        elif place != self._left:
            x, y = (of_pointer - of_window for of_pointer, of_window in zip(self._pointer, place, strict=True))
            pygame.mouse.set_pos(x - 1, y)  # setting the place that it has tells nothing
            pygame.mouse.set_pos(x, y)
            self._pointer = None

    def set_title(self, title):
        """Show a title, also while the window is minimised."""
        if title != self._title:
            self._title = title
            pygame.display.set_caption(title)

    def paint(self, draw):
        """Call `draw` with the window's pixels: an (h, w) uint32 array over the surface, valid only during the call."""
        draw(self._pixels())
        if self.surface.get_locked():
            gc.collect()  # compiling a kernel meanwhile left a reference cycle that holds the pixels

    def _pixels(self):
        surface = self.surface
        return np.frombuffer(surface.get_buffer(), np.uint32).reshape(surface.get_height(), surface.get_pitch() // 4)

    def show(self, rects=None):
        """Show what was drawn in `rects`, or everywhere, on the screen."""
        if self._aside and not self.covered and rects != []:
            pygame.display.get_surface().blit(self._aside, (0, 0))
            rects = None
        if rects is None:
            pygame.display.flip()
        elif rects:
            pygame.display.update(rects)

    def _open(self):
        pygame.display.set_icon(icon.load())
        pygame.display.set_mode(self._windowed_size, pygame.RESIZABLE, 32)
        pygame.display.set_caption(self._title)
        with suppress(AttributeError, pygame.error):  # not every window manager obeys
            _of_sdl().minimum_size = self._fitting(SMALLEST)
        if self.fullscreen:
            _of_sdl().set_fullscreen(True)
            pygame.event.pump()  # from here on the surface has the screen's size

    def _fitting(self, size):
        room = room_on(pygame.display.get_desktop_sizes()[0])
        return tuple(min(max(side, least), most) for side, least, most in zip(size, SMALLEST, room, strict=True))

    def _avoid_slow_flips(self):
        """Reopen an X11 window without acceleration where that has to be emulated, unless the user decided it."""
        if pygame.display.get_driver() != "x11" or "SDL_FRAMEBUFFER_ACCELERATION" in os.environ:
            return
        self.show()
        if statistics.median(self._flip_ms() for _ in range(5)) < SLOW_FLIP_MS:
            return
        os.environ["SDL_FRAMEBUFFER_ACCELERATION"] = "0"
        pygame.display.quit()
        pygame.display.init()
        self._open()

    def _flip_ms(self):
        start = time.perf_counter()
        self.show()
        return (time.perf_counter() - start) * 1e3


def _on_desktop(place):
    """Return where a place in the window is on the desktop, or None without X11 or with the pointer elsewhere."""
    if pygame.display.get_driver() != "x11" or not pygame.mouse.get_focused():
        return None
    return tuple(sum(sides) for sides in zip(place, pygame.display.get_window_position(), strict=True))


def _of_sdl():
    """Return SDL's window. pygame deprecates this way to it, but has no other yet.

    With a new window in its place, some window managers would change its size.
    """
    with warnings.catch_warnings(action="ignore", category=DeprecationWarning):
        return pygame.Window.from_display_module()


@cache
def _mapper(shifts):
    return lambda *colour: sum(part << shift for part, shift in zip(colour, shifts, strict=True))


def desktop_size():
    """Return the (width, height) in pixels of the desktop; raise NoDisplayError if there is none."""
    try:
        _start_display()
        return pygame.display.get_desktop_sizes()[0]
    except pygame.error as error:
        raise NoDisplayError(str(error)) from None


def room_on(desktop):
    """Return the (width, height) in pixels that a desktop has for a window."""
    sides = zip(LEAST_SURFACE, desktop, ROOM_FOR_DECORATION, strict=True)
    return tuple(max(least, most - taken) for least, most, taken in sides)


def _start_display():
    """Start the display; refuse a driver without a screen unless the user asked for it by name."""
    asked_for = os.environ.get("SDL_VIDEODRIVER")
    os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")  # else Windows stretches the window's pixels
    screens = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if sys.platform == "linux" and not asked_for and not screens:
        raise NoDisplayError("neither DISPLAY nor WAYLAND_DISPLAY is set")
    pygame.display.init()
    if pygame.display.get_driver() in INVISIBLE and asked_for not in INVISIBLE:
        pygame.display.quit()
        raise NoDisplayError("no screen was found")
