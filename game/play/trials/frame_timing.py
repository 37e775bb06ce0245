"""Times the program in its own window: where a frame's time goes, and how soon the first one is there.

`python -m game.play.trials.frame_timing --help` says how; the bench runs it in a process of its own.
"""

import argparse
import json
import statistics
import time
from collections import Counter

import numpy as np
import pygame

from game.play import loop
from game.play.app import App
from game.play.ui.theme import Theme
from game.play.view.frame_stats import own_ns
from game.play.window import layout
from game.play.window.window import Window
from game.process import leave_threads
from game.world.background.kernel_warmup import CELLS, later_steps, steps
from game.world.files.settings import Settings
from game.world.sand import parameters
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene
from game.world.sessions.session import FRAMES_PER_SECOND

FRAME_NS = 10**9 // FRAMES_PER_SECOND
WARM_UP = 5  # frames before the count: the first ones draw everything and fill caches of rendered text
STAGES = {  # what each stage is made of; the rest of a frame is "other"
    "stepping": lambda app: [(app.parts.sessions.now, "frame")],
    "drawing": lambda app: [(app.parts.window, "paint")],
    "panel": lambda app: [
        (app.parts.panel, "lay_out"),
        (app.parts.panel.ui, "end"),
        (app.parts.status_line, "drawing"),
        (app.parts.status_line, "update"),
    ],
    "present": lambda app: [(app.parts.window, "show")],
}


# what can be shown besides the sand, by which command
SHOWN = {
    "forecast": "view.toggle_forecast",
    "plots": "view.toggle_plots",
    "compare": "sand.compare",
    "differences": "view.toggle_differences",
    "density": "view.toggle_density",
}


def frames(scene, window_size, iterations, count, smooth=True, p=None, shown=(), cell=None):
    """Play `count` frames of `scene` at `iterations` a frame, without pauses, and return the report as a dict.

    shown: names of SHOWN, what is to be seen besides the sand. cell: pixels to a cell; None: the lattice fits.
    """
    pygame.font.init()
    window = Window(window_size or layout.window_size(scene, scene.cell, Theme(1.0)))
    for each in CELLS:
        for _, act in steps(scene.rule, scene.made_of, each):
            act()
    for _, act in later_steps(scene.rule) if shown else ():
        act()
    app = App(window, scene, p=p)
    app.parts.settings["smooth_streams"] = smooth
    app.parts.sessions.now.clock.speed = iterations * FRAMES_PER_SECOND
    for name in shown:
        app.parts.commands.give(SHOWN[name])
    spent = Counter()
    _watch(app, spent)
    played = []  # each frame's nanoseconds by stage
    forecasts = {}  # the runs of each question that was answered
    for number in range(WARM_UP + count):
        if number == WARM_UP:
            first, begin = app.parts.sessions.now.world.iteration, time.perf_counter()
            forecasts.clear()
        spent.clear()
        _play_frame(app, spent, number * FRAME_NS / 1e9)
        played.append(dict(spent))
        if number == 0 and cell:  # the stage is there from the first frame on
            app.parts.camera.zoom_to(cell)
        if app.parts.forecasting.answer:
            forecasts[app.parts.forecasting.answer.request] = app.parts.forecasting.answer.runs
    seconds = time.perf_counter() - begin
    report = _report(app, scene, played[WARM_UP:], app.parts.sessions.now.world.iteration - first)
    app.parts.close()
    if forecasts:
        report["forecast"] = {"per_second": len(forecasts) / seconds, "runs": statistics.median(forecasts.values())}
    return report | {"shown": list(shown)}


def _watch(app, spent):
    """Let each stage add its time to `spent`."""
    for stage, parts in STAGES.items():
        for holder, name in parts(app):
            setattr(holder, name, _timed(getattr(holder, name), stage, spent))


def _timed(act, stage, spent):
    def timed(*arguments, **named):
        start = time.perf_counter_ns()
        try:
            return act(*arguments, **named)
        finally:
            spent[stage] += time.perf_counter_ns() - start

    return timed


def _play_frame(app, spent, now_s):
    """Play one frame of a sixtieth of a second, as the loop does."""
    start, worked = time.perf_counter_ns(), own_ns()
    events = pygame.event.get()
    spent["events"] = time.perf_counter_ns() - start
    app.frame(events, FRAME_NS, now_s)
    spent["frame"] = time.perf_counter_ns() - start
    spent["other"] = 2 * spent["frame"] - sum(spent.values())
    spent["own"] = own_ns() - worked


def _report(app, scene, played, iterations):
    """Return what the frames took, and whether the world shown is the one that a run without a window gives."""
    world = app.parts.sessions.now.world
    twin = scene.world(world.seed)
    advance(twin, app.parts.sessions.now.rule, world.iteration)
    names = *STAGES, "events", "other", "frame", "own"
    columns = {stage: [each.get(stage, 0) / 1e6 for each in played] for stage in names}
    whole, own = columns.pop("frame"), columns.pop("own")
    return {
        "scene": scene.name,
        "cells": scene.shape[::-1],
        "window": app.parts.window.size,
        "pixels_per_cell": app.parts.display.sand_view.view.cell,
        "driver": pygame.display.get_driver(),
        "frames": len(played),
        "iterations": iterations,
        "smooth": app.parts.sessions.now.streams is not None and app.parts.sessions.now.streams.follows(world),
        "stage_ms": {stage: statistics.mean(column) for stage, column in columns.items()},
        "frame_ms": _summary(whole),
        "own_ms": _summary(own),  # the work of the frames' thread, without what other programs took
        "same_as_without_window": world.digest() == twin.digest(),
    }


def _summary(numbers):
    """Return mean, median, 99th percentile and maximum of numbers."""
    return {
        "mean": statistics.mean(numbers),
        "median": statistics.median(numbers),
        "p99": float(np.percentile(numbers, 99)),
        "max": max(numbers),
    }


def start_up(since_ns):
    """Start the program, stop it after its first frame, and return when each part was there, in seconds.

    since_ns: time.time_ns() when the process was started, from which the seconds count.
    """
    marks = {}

    def mark(name):
        marks.setdefault(name, (time.time_ns() - since_ns) / 1e9)

    mark("imported")
    _after(Window, "__init__", lambda *_: mark("window"))
    _after(Window, "show", lambda *_: "window" in marks and mark("splash"))
    _after(App, "frame", lambda app: (mark("playing"), setattr(app.parts, "running", False)))
    driver = []
    _after(App, "frame", lambda *_: driver.append(pygame.display.get_driver()))
    loop.play(load_scene("hourglass"), Settings())
    return {"marks_s": marks, "driver": driver[0]}


def _after(kind, name, act):
    """Call `act` with the object each time after the method `name` of the class `kind`."""
    method = getattr(kind, name)

    def followed(self, *arguments, **named):
        result = method(self, *arguments, **named)
        act(self)
        return result

    setattr(kind, name, followed)


def _pair(text):
    width, height = map(int, text.lower().split("x"))
    return width, height


def main():
    """Print the report that the command line asks for."""
    parser = argparse.ArgumentParser(
        prog="python -m game.play.trials.frame_timing", description=__doc__.splitlines()[0]
    )
    parser.add_argument("--scene", default="hourglass", metavar="NAME|FILE")
    parser.add_argument("--size", type=_pair, metavar="WxH", help="lattice, in cells (default: the scene's)")
    parser.add_argument("--window", type=_pair, metavar="WxH", help="window, in pixels (default: the scene's)")
    parser.add_argument("--iterations-per-frame", type=int, default=16, metavar="N")
    parser.add_argument("--frames", type=int, default=300, metavar="N")
    parser.add_argument("--p", type=float, metavar="P", help=parameters.P.meaning)
    parser.add_argument("--with", dest="shown", nargs="+", default=[], choices=SHOWN, help="what to show besides")
    parser.add_argument("--zoom", type=float, metavar="PX", help="pixels to a cell (default: the lattice fits)")
    parser.add_argument("--plain-streams", action="store_true", help="draw falling sand cell by cell")
    parser.add_argument("--start-up", action="store_true", help="time the start instead of frames")
    parser.add_argument("--since", type=int, default=time.time_ns(), metavar="NS", help="when the process was started")
    parser.add_argument("--json", action="store_true", help="print one JSON object on one line")
    options = parser.parse_args()
    if options.start_up:
        report = start_up(options.since)
    else:
        scene = load_scene(options.scene, options.size)
        report = frames(
            scene,
            options.window,
            options.iterations_per_frame,
            options.frames,
            not options.plain_streams,
            options.p,
            options.shown,
            options.zoom,
        )
    print(json.dumps(report, indent=None if options.json else 2))
    leave_threads(0)


if __name__ == "__main__":
    main()
