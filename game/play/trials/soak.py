"""The soak: the window under random input for minutes or hours, watched for errors, lost grains and growing memory.

    python -m game.play.trials.soak --minutes 120 --seed 1

prints a line a minute, and ends with status 1 at the first thing that is wrong: an exception, a grain that is not
accounted for, or more memory than the budget. What it saves goes to a folder that is removed. The same seed gives the
same input, though not the same frames, since those depend on the clock.
"""

import argparse
import os
import sys
import tempfile
import time
import traceback
from collections import deque

import pygame

from game.core import jit
from game.play.app import App
from game.play.trials.random_input import Hand
from game.play.window.allocator import freeze_objects, resident_mb, return_freed_memory
from game.play.window.window import Window
from game.world.background import kernel_warmup
from game.world.files.settings import Settings
from game.world.scenes.scene import load_scene, scene_names

MEMORY_MB = 64  # for the past
BUDGET_MB = 300  # growth after the first minute: the past of two sessions, large scenes, kernels compiled late
CALM_S = 20.0  # input comes in waves: so long it is busy, and so long it is calm
BUSY, CALM = 0.8, 0.02  # the share of frames in which something is done
TOLD = 40  # events that are told of when something goes wrong
SIZE = 1000, 700
LONGEST_PAGE = 200  # frames for which a page may cover the sand
RESTART_S = 45.0  # now and then another scene is opened, so that not every lattice gets painted full
FIRST = "hourglass"


class SoakError(Exception):
    """Something is wrong with the window."""


class Soak:
    """The window, the hand that uses it, and what is known about it so far."""

    def __init__(self, seed):
        return_freed_memory()
        settings = Settings()
        settings["memory"] = MEMORY_MB
        window, scene = Window(SIZE), load_scene(FIRST)
        for _, act in (*kernel_warmup.steps(scene.rule, scene.made_of), *kernel_warmup.later_steps(scene.rule)):
            act()
        self.app = App(window, scene, settings=settings)
        self.app.parts.crash_recovery.start()
        freeze_objects()
        self.hand = Hand(seed)
        self.frames = self.acts = 0
        self.longest_s = self.worked_s = 0.0  # the longest frame, and what of it was work of this thread
        self.slow = []  # the events in it
        self.recent = deque(maxlen=TOLD)
        self._opened, self._scenes = 0, scene_names()
        self._ready = jit.ready()

    def run(self, seconds, say):
        """Play for so long; raise SoakError, or whatever the window raises, for the first thing that is wrong."""
        start = before = time.perf_counter()
        told, least_mb = 0, None
        while before - start < seconds:
            now = time.perf_counter()
            self._frame(now, now - before, now - start)
            before = now
            if now - start >= 60 * (told + 1):
                told += 1
                used = resident_mb()
                least_mb = least_mb or used
                say(f"{told} min: {self.told(used)}")
                self.longest_s, self.worked_s, self.slow = 0.0, 0.0, []
                if used - least_mb > BUDGET_MB:
                    raise SoakError(f"memory grew from {least_mb:.0f} to {used:.0f} MB, budget {BUDGET_MB} MB")

    def told(self, used_mb):
        """Return how it stands, in one line."""
        world, past = self.app.parts.sessions.now.world, self.app.parts.sessions.now.past_bytes / 2**20
        slow = ", ".join(map(_name, self.slow)) or "no event"
        return (
            f"{self.frames:,} frames, {self.acts:,} events, {self.app.parts.sessions.now.scene.name}: "
            f"{world.grains:,} grains, "
            f"{used_mb:.0f} MB, {past:.0f} of them the past, longest frame {self.longest_s * 1e3:.0f} ms, "
            f"{self.worked_s * 1e3:.0f} at work ({slow}){self._compiled()}"
        )

    def _compiled(self):
        """Return what to say of kernels that were not ready before they were needed: for them frames have waited."""
        late, self._ready = jit.ready() - self._ready, jit.ready()
        return "".join(f", {name}{types} was not ready" for name, types in sorted(late))

    def _frame(self, now_s, elapsed_s, since_s):
        app = self.app
        worked_s = time.thread_time()
        busy = BUSY if since_s // CALM_S % 2 == 0 else CALM
        events = self.hand.events(app.parts.window.size, busy)
        if app.parts.display.page and self.frames % LONGEST_PAGE == 0:
            events.append(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_ESCAPE, mod=0, unicode=""))
        self.recent.extend(events)
        self.acts += len(events)
        if since_s // RESTART_S > self._opened:
            self._opened += 1
            app.parts.sessions.load(self._scenes[self._opened % len(self._scenes)])
        app.frame(events, round(elapsed_s * 1e9), now_s, self.hand.pointer)
        app.parts.running = True  # whatever the hand did to leave
        if app.parts.sessions.now.memory_mb > MEMORY_MB:  # the hand has found the slider
            app.parts.sessions.now.limit_memory(MEMORY_MB)
        self.frames += 1
        took_s = time.perf_counter() - now_s
        if took_s > self.longest_s:
            self.longest_s, self.worked_s, self.slow = took_s, time.thread_time() - worked_s, events
        self._audit()

    def _audit(self):
        session = self.app.parts.sessions.now
        if not session.account.balanced(session.world):
            raise SoakError(f"{session.world.grains} grains, wanted {session.account.expected}")


def _name(event):
    """Return what an event was, in a word or two."""
    kind = pygame.event.event_name(event.type)
    return f"{kind} {pygame.key.name(event.key)}" if event.type == pygame.KEYDOWN else kind


def main(arguments=None):
    """Soak the window and return the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m game.play.trials.soak", description="The window under random input."
    )
    parser.add_argument("--minutes", type=float, default=5.0, help="how long (default: 5)")
    parser.add_argument("--seed", type=int, default=0, help="picks the input")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["SANDGLASS_DATA_DIR"] = os.environ["SANDGLASS_CONFIG_DIR"] = folder
        pygame.font.init()
        soak = Soak(options.seed)
        try:
            soak.run(60 * options.minutes, lambda line: print(line, flush=True))
            soak.app.parts.close()
        except Exception as error:
            if not isinstance(error, SoakError):
                traceback.print_exc()
            for event in soak.recent:
                print(event, file=sys.stderr)
            print(f"after {soak.frames:,} frames, seed {options.seed}: {error}", file=sys.stderr)
            return 1
    print(f"nothing wrong: {soak.told(resident_mb())}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
