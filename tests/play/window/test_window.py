"""The window on screens of other kinds: few colours, and a desktop that looks for its icon."""

import os
import shutil
import subprocess
import sys
from contextlib import contextmanager

import pygame
import pytest

from game.play.window.window import Window
from tests.sweeps import sweep


@pytest.mark.parametrize("bits", [15, 16])
def test_a_screen_of_few_colours_shows_what_is_drawn_in_many(monkeypatch, bits):
    window = Window((640, 480))
    screen = pygame.Surface((640, 480), 0, bits)
    monkeypatch.setattr(pygame.display, "get_surface", lambda: screen)
    window.paint(lambda pixels: pixels.fill(0xFF0000))
    window.show([pygame.Rect(0, 0, 9, 9)])
    assert window.size == (640, 480) and screen.get_at((639, 479))[:3] == (255, 0, 0)


@contextmanager
def virtual_screen(size):
    """Yield the name of a virtual X11 screen."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", size, "-noreset", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    with os.fdopen(reading) as number:
        name = f":{number.readline().strip()}"
    try:
        yield name
    finally:
        server.terminate()
        server.wait()


def run_under_x11(script, screen):
    """Return what a script prints, and what it complains of, on a virtual X11 screen.

    It draws on the screen's own surface, whatever the machine: else how long a flip takes decides about that.
    """
    with virtual_screen(screen) as display:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("SDL_VIDEO")}
        done = subprocess.run(
            [sys.executable, "-c", script],
            env=environment | {"DISPLAY": display, "SDL_VIDEODRIVER": "x11", "SDL_FRAMEBUFFER_ACCELERATION": "0"},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
    return done.stdout, done.stderr


@pytest.mark.skipif(not (shutil.which("Xvfb") and shutil.which("xprop")), reason="needs Xvfb and xprop")
def test_the_class_of_the_window_is_the_name_of_the_program():
    script = (
        "import subprocess, sys; sys.argv[0] = 'main.py'\n"
        "from game.play.window.window import Window; import pygame\n"
        "window = Window((640, 480)); window.show(); pygame.event.pump()\n"
        "at = str(pygame.display.get_wm_info()['window'])\n"
        "print(subprocess.run(['xprop', '-id', at, 'WM_CLASS'], capture_output=True, text=True).stdout)"
    )
    said, trouble = run_under_x11(script, "800x600x24")
    assert '"sandglass", "sandglass"' in said, trouble


@pytest.mark.skipif(not shutil.which("Xvfb"), reason="needs Xvfb")
@sweep("bits", [15, 16], keep=[16])
def test_on_a_screen_of_few_colours_all_is_drawn(bits):
    script = (
        "import pygame; from tests.play.player import Player; player = Player(size=(700, 500))\n"
        "player.hold_time(); player.drag(player.pixel(58, 45), player.pixel(62, 45))\n"
        "for key in (pygame.K_b, pygame.K_F1, pygame.K_F1, pygame.K_F2, pygame.K_ESCAPE): player.key(key)\n"
        "for _ in range(9): player.key(pygame.K_EQUALS, '=', pygame.KMOD_CTRL)\n"
        "player.parts.glow.start(player.now_s); player.wait(9)\n"
        "print('drawn', pygame.display.get_surface().get_bytesize())"
    )
    said, trouble = run_under_x11(script, f"800x600x{bits}")
    assert "drawn 2" in said, trouble
