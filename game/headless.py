"""The headless run: the frames of the window without a window, timed, with one flip half way."""

import json
import statistics
import time

import numpy as np

from game.world.background.kernel_warmup import steps
from game.world.looks.painter import Painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View
from game.world.rules.rule import Rule
from game.world.sand import parameters
from game.world.sessions.action import Flip, SetRule
from game.world.sessions.session import BUDGET_NS, Session

FRAME_NS = 16_666_667  # 60 frames a second


def run(scene, frames=parameters.FRAMES.default, p=None, seed=0):
    """Play `frames` frames of `scene` and return the report as a dict.

    frame_ms covers stepping and drawing into an array the size of the scene's window.
    """
    session = Session(scene, seed)
    if p is not None:
        session.do(SetRule(Rule.with_p(p, session.rule.schedule)))
    for _, act in steps(session.rule, scene.made_of, scene.cell, scene.coloured, scene.fixtures):
        act()
    height, width = (side * scene.cell for side in scene.shape)
    painter = Painter(
        View.fit(scene.shape, 0, 0, width, height),
        walls=scene.made_of,
        substances=substances_of(scene.rule.definition.materials),
    )
    pixels = np.zeros((height, width), np.uint32)
    grains = session.world.grains
    times = [_frame(session, painter, pixels, flip=number == frames // 2) for number in range(frames)]
    return _report(session, grains, times)


def _frame(session, painter, pixels, flip):
    """Play one frame and return how long it took, in milliseconds."""
    start = time.perf_counter_ns()
    if flip:
        session.do(Flip())
    session.frame(FRAME_NS)
    painter.draw(session.world, pixels)
    return (time.perf_counter_ns() - start) / 1e6


def replay(recording):
    """Compute a Recording to its end and return the report as a dict."""
    start = time.perf_counter_ns()
    session = Session.retold(recording)
    session.seek(recording.end)
    took_ms = (time.perf_counter_ns() - start) / 1e6
    account, digest = session.account, session.world.digest()
    return {
        "scene": session.scene.name,
        "cells": session.world.shape[0] * session.world.shape[1],
        "acts": len(session.timeline.history.story()),
        "iterations": session.now,
        "grains_start": account.start,
        "grains_painted": account.painted,
        "grains_erased": account.erased,
        "grains_poured": account.poured,
        "grains_swallowed": account.swallowed,
        "grains_end": session.world.grains,
        "balanced": session.account.balanced(session.world),
        "digest": digest,
        "digest_wanted": recording.digest or None,
        "same": recording.problem is None and recording.digest in ("", digest),
        "ms": took_ms,
    }


def replay_status(report):
    """Return the exit status: 1 if the end is not the one recorded, or grains were made or lost."""
    return 0 if report["same"] and report["balanced"] else 1


def replay_text(report, as_json=False):
    """Return a replay's report as one JSON object or as a short table."""
    if as_json:
        return json.dumps(report)
    rows = {
        "scene": f"{report['scene']}, {report['cells']:,} cells",
        "replay": f"{report['acts']:,} acts, {report['iterations']:,} iterations in {report['ms']:.0f} ms",
        "grains": f"{report['grains_start']:,} at the start + {report['grains_painted']:,} painted"
        f" - {report['grains_erased']:,} erased{_traffic(report)}, {report['grains_end']:,} at the end",
        "digest": f"{report['digest']}: {'as recorded' if report['same'] else 'not as recorded'}",
    }
    return "\n".join(f"{name:<8}{value}" for name, value in rows.items())


def _traffic(report):
    """Return the words for the grains that went through taps and drains, if any did."""
    poured, swallowed = report["grains_poured"], report["grains_swallowed"]
    return f" + {poured:,} poured - {swallowed:,} swallowed" if poured or swallowed else ""


def _report(session, grains_start, times):
    median = statistics.median(times)
    budget = BUDGET_NS / 1e6
    return {
        "scene": session.scene.name,
        "cells": session.scene.sand.size,
        "frames": len(times),
        "iterations": session.world.iteration,
        "grains_start": grains_start,
        "grains_poured": session.account.poured,
        "grains_swallowed": session.account.swallowed,
        "grains_end": session.world.grains,
        "balanced": session.account.balanced(session.world),
        "digest": session.world.digest(),
        "frame_ms": {"median": median, "p99": float(np.percentile(times, 99)), "max": max(times)},
        "budget_ms": budget,
        "within_budget": median <= budget,
    }


def status(report):
    """Return the exit status: 1 if grains were lost or the median frame missed its budget."""
    return 0 if report["within_budget"] and report["balanced"] else 1


def text(report, as_json=False):
    """Return the report as one JSON object or as a short table."""
    if as_json:
        return json.dumps(report)
    frame = report["frame_ms"]
    rows = {
        "scene": f"{report['scene']}, {report['cells']:,} cells",
        "run": f"{report['frames']:,} frames, {report['iterations']:,} iterations, one flip",
        "grains": f"{report['grains_start']:,} at the start{_traffic(report)}, {report['grains_end']:,} at the end",
        "frame": f"median {frame['median']:.2f} ms, p99 {frame['p99']:.2f} ms, max {frame['max']:.2f} ms",
        "budget": f"{report['budget_ms']:.0f} ms, by the median {'kept' if report['within_budget'] else 'missed'}",
        "digest": report["digest"],
    }
    return "\n".join(f"{name:<8}{value}" for name, value in rows.items())
