"""The loop: opens the window, makes the kernels ready behind a splash, and runs frame after frame."""

import threading
import time

import pygame

from game.play import hud, panel, splash
from game.play.toy import Toy
from game.play.ui.theme import Theme
from game.play.window import NoDisplayError, Window
from game.world.companion import steps_to_play

__all__ = ["NoDisplayError", "play"]

FRAMES_PER_SECOND = 60
MARGIN = 16  # pixels around the sand in a new window


def play(scene, settings, seed=0, p=None, cell=None, fullscreen=False, recording=None, timer_s=None):
    """Play `scene`, or a Recording, in a window until the player quits; raise NoDisplayError if none can be opened.

    timer_s: seconds that the timer is started with, if any.
    """
    pygame.font.init()
    theme = Theme(settings["ui_scale"])
    remembered = settings["window_width"], settings["window_height"]
    size = remembered if all(remembered) and not cell else window_size(scene, cell or scene.cell, theme)
    window = Window(size, fullscreen)
    dense = scene.shape[1] > window.size[0] or scene.shape[0] > window.size[1]
    first, later = steps_to_play(scene.rule, scene.made_of, dense, scene.colours is not None)
    if not _make_ready(window, theme, first):
        return 0
    toy = Toy(window, scene, seed, p, settings)
    threading.Thread(target=_do_all, args=(later,), daemon=True).start()
    toy.recovery.start()
    if recording:
        toy.files.play(recording, recording.scene.title)
    if timer_s is not None:
        toy.timer.set(timer_s)
        toy.timer.start()
        toy.panel.timer.open = True
    run(toy)
    pygame.quit()
    toy.close()
    return 0


def run(toy):
    """Run frames until the toy stops."""
    pace = pygame.time.Clock()
    before = time.perf_counter_ns()
    while toy.running:
        now = time.perf_counter_ns()
        pointer = pygame.mouse.get_pos() if pygame.mouse.get_focused() else None
        toy.frame(pygame.event.get(), now - before, now / 1e9, pointer)
        before = now
        pace.tick(FRAMES_PER_SECOND)


def window_size(scene, cell, theme):
    """Return the (width, height) in pixels of a window that shows `scene` with `cell` pixels to a cell."""
    height, width = (side * cell + MARGIN for side in scene.shape)
    return width + theme.px(panel.WIDTH), max(height + theme.px(hud.HEIGHT), theme.px(560))


def _make_ready(window, theme, steps):
    """Do the steps in the background while a splash says which; return whether the player stayed."""
    done = []
    worker = threading.Thread(target=_do_all, args=(steps, done), daemon=True)
    worker.start()
    while worker.is_alive():
        if any(event.type == pygame.QUIT for event in pygame.event.get()):
            return False
        number = min(len(done), len(steps) - 1)
        words = f"Compiling {steps[number][0]} … ({number + 1} of {len(steps)}, once on this machine)"
        splash.draw_splash(window.surface, theme, words, number / len(steps))
        window.show()
        worker.join(1 / 30)
    return True


def _do_all(steps, done=None):
    for what, act in steps:
        act()
        if done is not None:
            done.append(what)
