"""Frames: where the milliseconds of a frame go, in the toy's own window."""

from game.study.bench import goals
from game.study.bench.checks import WrongCellsError
from game.study.bench.processes import NoWindowError, screen, timing
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table

STAGES = ("events", "stepping", "drawing", "panel", "present", "other")
COLUMNS = (
    Column("scene", "scene"),
    Column("shown", "with"),
    Column("cells", "cells", table.size),
    Column("window", "window", table.size),
    Column("cell", "px/cell", table.three_digits),
    Column("driver", "driver"),
    Column("iterations", "iterations/frame", table.three_digits),
    Column("streams", "streams"),
    *(Column(stage, stage, table.three_digits) for stage in STAGES),
    Column("median_ms", "median ms", table.three_digits),
    Column("p99_ms", "p99 ms", table.three_digits),
    goals.COLUMN,
)


def frame_table(plan):
    """Return where the time of the frames of each case goes, in milliseconds: medians, and the 99th percentile."""
    rows, notes = [], []
    with screen() as (environment, shown_on):
        for case in plan.frame_cases:
            try:
                rows.append(_row(case, timing(_arguments(case, plan), environment), shown_on))
            except NoWindowError as error:
                notes.append(f"{case.scene} left out: {error}")
    notes += [
        f"{plan.frames} frames of the toy, panel shown, one after another without a pause. Stages are "
        "means in ms; panel includes the line under the sand; median and p99 are of whole frames.",
        "Smooth streams: falling sand as the mean of the last four iterations; plain on more than four million cells.",
        "Checked: the world that was shown is the one that as many iterations without a window give.",
    ]
    return Section("frames", "5 · Frames", [Table("", COLUMNS, rows), *notes])


def _arguments(case, plan):
    """Return the arguments of game.play.trials.frame_timing for a case."""
    sizes = {"--size": case.size, "--window": case.window}
    given = [part for flag, pair in sizes.items() if pair for part in (flag, "x".join(map(str, pair)))]
    given += [] if case.smooth else ["--plain-streams"]
    given += ["--zoom", case.cell] if case.cell else []
    given += ["--with", *case.shown] if case.shown else []
    given += ["--p", case.p] if case.p is not None else []
    return ["--scene", case.scene, *given, "--iterations-per-frame", case.iterations, "--frames", plan.frames]


def _row(case, report, shown_on):
    if not report["same_as_without_window"]:
        raise WrongCellsError(f"{case.scene} in a window differs from the same without one: nothing was timed")
    driver = f"{report['driver']} ({shown_on})" if shown_on else report["driver"]
    row = {
        "scene": case.scene,
        "shown": _shown(case, report),
        "cells": tuple(report["cells"]),
        "window": tuple(report["window"]),
        "cell": report["pixels_per_cell"],
        "driver": driver,
        "iterations": report["iterations"] / report["frames"],
        "streams": "smooth" if report["smooth"] else "plain",
        **{stage: report["stage_ms"][stage] for stage in STAGES},
        "median_ms": report["frame_ms"]["median"],
        "p99_ms": report["frame_ms"]["p99"],
    }
    return row | {"goal": _goal(case, row) if case.goal else None}


def _shown(case, report):
    """Return what was seen besides the sand, and how often a forecast came."""
    pace = ""
    if "forecast" in report:
        pace = f" ({report['forecast']['runs']:,.0f} runs, {report['forecast']['per_second']:.0f} times a second)"
    return " and ".join(case.shown).replace("forecast", f"forecast{pace}")


def _goal(case, row):
    """Return the goal of a frame's time; sand left unmoved or another window than asked for spoil it."""
    spoiled = ""
    if row["iterations"] < case.iterations:
        spoiled = f"{row['iterations']:.2f} of {case.iterations} iterations"
    elif row["window"] != case.window:
        spoiled = f"the window is {table.size(row['window'])}"
    scene = " with ".join(filter(None, (case.scene, " and ".join(case.shown))))
    scene += f" at {case.cell:g} px per cell" if case.cell else ""
    what = f"{scene}, {table.size(case.window)} window, {case.iterations} iterations: p99"
    return goals.at_most(what, row["p99_ms"], goals.FRAME_MS, " ms", spoiled)
