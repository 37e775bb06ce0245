"""Times timers by the real clock: how late the last grain falls, on a busy machine, with lost frames and hands at work.

`python -m game.play.trials.timer_trial --help` says how. Each timer runs in a process and a window of its own.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import pygame

from game.play.app import App
from game.play.timer.timer import RUNNING
from game.play.window.wall_clock import wall_clock
from game.play.window.window import Window
from game.world.background.kernel_warmup import later_steps, steps
from game.world.rules.rule import Rule
from game.world.scenes.hourglass_maker import glass_for, scene_of
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Load, Paint, SetRule
from game.world.sessions.session import FRAMES_PER_SECOND

ALLOWED_S = 0.1  # beyond one frame
WINDOW = 1280, 720  # pixels
SEED = 2020
LOSS = 0.03  # of the frames that are lost where frames get lost, each for a length up to LONGEST_LOSS_S
LONGEST_LOSS_S = 0.6
SCENES = "", "", "hourglass", "paper", "funnel", "galton"  # "" is a glass made for the time
ALONE = {
    "load": "busy",
    "losses": "lost frames",
    "strokes": "strokes",
    "flips": "a flip",
    "changes": "p and size changed",
}


@dataclass(frozen=True)
class TimedRun:
    """One timer, and what happens to it on its way."""

    seconds: float
    scene: str
    load: bool = False  # another process computes without a pause meanwhile
    losses: bool = False
    strokes: bool = False
    flips: bool = False
    changes: bool = False

    @property
    def words(self):
        """What happens, in words."""
        return ", ".join(words for name, words in ALONE.items() if getattr(self, name)) or "nothing"


WARM_UP = TimedRun(2, "", strokes=True, flips=True, changes=True)  # compiles what the others need


def trials(count, shortest_s, longest_s):
    """Return so many trials, drawn at random with a fixed seed."""
    draw = np.random.default_rng(SEED)
    chances = {"load": 0.4, "losses": 0.5, "strokes": 0.5, "flips": 0.4, "changes": 0.3}
    return [
        TimedRun(
            round(float(draw.uniform(shortest_s, longest_s)), 1),
            SCENES[number % len(SCENES)],
            **{name: bool(draw.random() < chance) for name, chance in chances.items()},
        )
        for number in range(count)
    ]


def play(trial, seed):
    """Play one trial in this process and return {late_s, worst_frame_s, said}."""
    scene = load_scene(trial.scene) if trial.scene else scene_of(glass_for(trial.seconds))
    pygame.font.init()
    window = Window(WINDOW)
    for _, act in (*steps(scene.rule, scene.made_of), *later_steps(scene.rule)):
        act()
    app = App(window, scene, seed)
    acts = _acts(trial, app, np.random.default_rng(seed))
    losses = np.random.default_rng(seed + 1)
    pace, began_s = pygame.time.Clock(), wall_clock()
    app.parts.timer.set(trial.seconds)
    app.parts.timer.start()
    before = time.perf_counter_ns()
    worst_s, last_frame_s, shown_s = 0.0, 0.0, began_s
    while app.parts.timer.state == RUNNING:
        while acts and wall_clock() - began_s >= acts[0][0]:
            acts.pop(0)[1]()
        now = time.perf_counter_ns()
        app.frame(pygame.event.get(), now - before, now / 1e9)
        before = now
        last_frame_s, shown_s = wall_clock() - shown_s, wall_clock()
        worst_s = max(worst_s, last_frame_s)
        if trial.losses and losses.random() < LOSS:
            time.sleep(losses.uniform(0.05, LONGEST_LOSS_S))
        pace.tick(FRAMES_PER_SECOND)
    fallen = "The last grain fell" in app.parts.timer.said and app.parts.sessions.now.account.balanced(
        app.parts.sessions.now.world
    )
    app.parts.planner.close()
    return {
        "late_s": shown_s - began_s - trial.seconds,
        "frame_s": last_frame_s,
        "worst_frame_s": worst_s,
        "fallen": fallen,
        "iterations": app.parts.sessions.now.now,
    }


def _acts(trial, app, draw):
    """Return [(second, act)], what a player does on the way, in order."""
    acts = []
    at = lambda low, high: trial.seconds * draw.uniform(low, high)  # noqa: E731
    if trial.strokes:
        for _ in range(3):
            acts.append((at(0.1, 0.9), lambda: _stroke(app, draw)))
    if trial.flips:
        acts.append((at(0.3, 0.7), app.parts.commands.sand.flip))
    if trial.changes:
        acts.append(
            (at(0.2, 0.5), lambda: app.parts.sessions.do(SetRule(Rule.with_p(draw.uniform(0.3, 1.0), "balanced"))))
        )
        acts.append((at(0.5, 0.6), lambda: app.parts.sessions.do(Load(scene_of(glass_for(trial.seconds * 0.8)), 7))))
    return sorted(acts, key=lambda each: each[0])


def _stroke(app, draw):
    """Paint a stroke of sand somewhere in the upper half."""
    height, width = app.parts.sessions.now.world.shape
    x, y = width * draw.uniform(0.4, 0.6), height * draw.uniform(0.15, 0.35)
    for step in range(6):
        app.parts.sessions.do(Paint("sand", (x + step, y), (x + step + 1, y), 4), join=step > 0)


def run(wanted, together):
    """Run trials as processes, so many at a time; return their reports in order."""
    waiting, going, reports = list(enumerate(wanted)), {}, {}
    _report_of(_start(0, WARM_UP)[0])
    try:
        while waiting or going:
            while waiting and len(going) < together:
                number, trial = waiting.pop(0)
                going[number] = _start(number, trial)
            time.sleep(0.1)
            for number in [each for each, (process, _) in going.items() if process.poll() is not None]:
                process, load = going.pop(number)
                _end(load)
                reports[number] = asdict(wanted[number]) | {"words": wanted[number].words} | _report_of(process)
                print(_line(number, reports[number]), file=sys.stderr, flush=True)
    finally:
        for process, load in going.values():
            _end(process)
            _end(load)
    return [reports[number] for number in sorted(reports)]


def _start(number, trial):
    environment = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", **os.environ}
    command = [
        sys.executable,
        "-m",
        "game.play.trials.timer_trial",
        "--one",
        json.dumps(asdict(trial)),
        "--seed",
        str(number),
    ]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, env=environment, text=True)
    load = subprocess.Popen([sys.executable, "-c", "while True: pass"]) if trial.load else None
    return process, load


def _end(process):
    if process is not None and process.poll() is None:
        process.kill()
        process.wait()


def _report_of(process):
    text, _ = process.communicate()
    if process.returncode:
        raise RuntimeError(f"a timer ended with status {process.returncode}")
    return json.loads(text.splitlines()[-1])


def _beyond_s(report):
    """Return by how much a report's last grain was late beyond the length of the frame in which it fell."""
    return max(0.0, report["late_s"] - report["frame_s"])


def _line(number, report):
    scene = report["scene"] or "a glass for it"
    end = f"{report['late_s'] * 1e3:+.1f} ms" + ("" if report["fallen"] else ", but sand or grains are amiss")
    return f"{number + 1:>2}. {report['seconds']:.1f} s, {scene}, {report['words']}: {end}"


def table(reports):
    """Return the reports as a Markdown table with what they come to."""
    rows = [
        "| timer | sand | on the way | iterations | last grain late | in a frame of | slowest frame |",
        "| ---: | :--- | :--- | ---: | ---: | ---: | ---: |",
    ]
    for each in reports:
        scene = f"`{each['scene']}`" if each["scene"] else "a glass for the time"
        rows.append(
            f"| {each['seconds']:.1f} s | {scene} | {each['words']} | {each['iterations']:,} "
            f"| {each['late_s'] * 1e3:.1f} ms | {each['frame_s'] * 1e3:.0f} ms | {each['worst_frame_s'] * 1e3:.0f} ms |"
        )
    late = [each["late_s"] for each in reports]
    told = f"{len(late)} timers: median {statistics.median(late) * 1e3:.1f} ms late, worst {max(late) * 1e3:.1f} ms; "
    rows += ["", told + f"beyond the frame in which the grain fell, worst {max(map(_beyond_s, reports)) * 1e3:.1f} ms."]
    return "\n".join(rows)


def main():
    """Run the trials that the command line asks for; status 1 if one was late by more than is allowed."""
    parser = argparse.ArgumentParser(prog="python -m game.play.trials.timer_trial", description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=20, metavar="N", help="how many timers")
    parser.add_argument("--shortest", type=float, default=10, metavar="S", help="seconds of the shortest")
    parser.add_argument("--longest", type=float, default=60, metavar="S", help="and of the longest")
    parser.add_argument("--together", type=int, default=4, metavar="N", help="how many at a time")
    parser.add_argument("--out", type=Path, metavar="FILE", help="write the table here as well")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=0, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(play(TimedRun(**json.loads(options.one)), options.seed)))
        return 0
    reports = run(trials(options.count, options.shortest, options.longest), options.together)
    print(table(reports))
    if options.out:
        options.out.write_text(table(reports) + "\n", encoding="utf-8")
    return 0 if all(each["fallen"] and _beyond_s(each) < ALLOWED_S for each in reports) else 1


if __name__ == "__main__":
    sys.exit(main())
