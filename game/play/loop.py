"""The loop: opens the window, makes the kernels ready behind a splash, and runs frame after frame."""

import time

import pygame

from game.play.app import App
from game.play.frame_wait import FrameWait
from game.play.ui import theme as look
from game.play.view.splash import Progress, Splash
from game.play.window.allocator import freeze_objects, return_freed_memory
from game.play.window.layout import WindowLayout, first_scale, first_size, room_of, window_size
from game.play.window.window import NoDisplayError, Window, desktop_size
from game.process import ending_within, is_asked_to_end, noting_signals
from game.world.background.kernel_warmup import later_steps, make_stepping_beside, steps
from game.world.background.step_thread import StepThread
from game.world.files.atomic import drop_parts
from game.world.files.paths import clear_user_parts
from game.world.looks.view import View
from game.world.scenes.fine_glass import fine_glass

__all__ = ["NoDisplayError", "play"]

CLOSING_S = 2.0  # the longest that the end waits for what is being written


def play(scene, settings, seed=0, p=None, cell=None, fullscreen=False, recording=None, timer_s=None, suits=False):
    """Play `scene`, or a Recording, in a window until the player quits; raise NoDisplayError if none can be opened.

    timer_s: seconds that the timer is started with, if any. suits: a glass is made in cells that suit the window, and
    follows it while it is untouched. Threads may still be at work afterwards: who ends the process ends them, by
    `leave_threads`.
    """
    stepping = StepThread([("the stepping", make_stepping_beside)])  # at once: it takes longest
    return_freed_memory()
    pygame.font.init()
    if not settings.has("ui_scale"):
        settings["ui_scale"] = first_scale(desktop_size())
    theme = look.Theme(settings["ui_scale"])
    window = Window(_size(scene, settings, cell, theme), fullscreen)
    layout, base = WindowLayout(theme, window.size, panel_shown=True), scene
    if suits:
        scene = fine_glass(scene, room_of(layout, theme))
    cell = View.fit(scene.shape, *layout.sand).cell
    *others, moving = steps(scene.rule, scene.made_of, cell, scene.coloured, scene.fixtures)
    worker = StepThread([*others, ("the stepping", lambda: stepping.wait(None)), moving])
    try:
        with noting_signals():
            if _make_ready(window, theme, worker):
                worker = StepThread(later_steps(scene.rule))
                app = App(window, scene, seed, p, settings)
                _begin(app, recording, timer_s)
                if suits:
                    app.parts.window_glass.follow(base, brush_too=not settings.has("brush"))
                run(app, worker)
                pygame.quit()
                with ending_within(CLOSING_S, drop_parts):
                    app.parts.close()
    finally:
        pygame.quit()
        worker.stop()


def _begin(app, recording, timer_s):
    app.parts.background.do(clear_user_parts)
    app.parts.crash_recovery.start()
    if recording:
        app.parts.files.play(recording, recording.scene.title)
    if timer_s is not None:
        _start_timer(app, timer_s)


def _size(scene, settings, cell, theme):
    """Return the size that the window has to begin with: for `cell` pixels to a cell, as remembered, or as suits."""
    remembered = settings["window_width"], settings["window_height"]
    if cell:
        return window_size(scene, cell, theme)
    return remembered if all(remembered) else first_size(scene, theme, desktop_size())


def _start_timer(app, timer_s):
    app.parts.timer.set(timer_s)
    app.parts.timer.start()


def run(app, later=None):
    """Run frames until the player quits; later: the StepThread at what its first frames do not need, if any."""
    wait, events = FrameWait(), pygame.event.get()
    before = time.perf_counter_ns()
    while app.parts.running and not is_asked_to_end():
        now = time.perf_counter_ns()
        pointer = pygame.mouse.get_pos() if pygame.mouse.get_focused() else None
        app.frame(events, now - before, now / 1e9, pointer)
        before = now
        if later and later.wait(0):
            freeze_objects()
            later = None
        events = wait.events(app.parts.at_rest, app.parts.window.hidden)


def _make_ready(window, theme, worker):
    """Show a splash that says what a StepThread is at until it is done; return whether the player stayed."""
    to_do, splash, progress = worker.steps, Splash(theme), Progress(len(worker.steps))
    while not worker.wait(1 / 30):
        if is_asked_to_end() or any(event.type == pygame.QUIT for event in pygame.event.get()):
            return False
        number, now_s = min(worker.done, len(to_do) - 1), time.monotonic()
        words = f"Compiling {to_do[number][0]} … ({number + 1} of {len(to_do)}, once on this machine)"
        splash.draw(window.surface, words, progress.at(number, now_s), now_s)
        window.show()
    return True
