"""The command: measures table after table, prints each, and writes them down."""

import json
import time
from functools import partial
from pathlib import Path

from game.study.bench import (
    acts,
    frames,
    hourglass_p,
    machine,
    peer_table,
    rules_and_motion,
    scale,
    start_up,
    table_one,
    threads,
)
from game.study.bench.checks import WrongCellsError
from game.study.bench.plan import FULL, QUICK

TABLES = (
    table_one.paper_table,
    peer_table.peer_table,
    rules_and_motion.scene_table,
    hourglass_p.glass_table,
    acts.act_table,
    scale.scale_table,
    frames.frame_table,
    threads.thread_table,
    start_up.start_table,
)
AGAIN = "python main.py bench"
PICTURE = "bench.png"


class CannotWriteError(Exception):
    """What was asked for cannot be written; says in one line why, and what to do about it."""


def run(quick=False, as_json=False, out=None, plan=None):
    """Run the bench and return the exit status: 0, or 1 where an implementation moved sand elsewhere than the twin.

    out: a folder for the tables as Markdown and JSON and for the picture. Raises CannotWriteError before anything is
    measured if the folder cannot be made or the picture not be drawn.
    """
    plan = plan or (QUICK if quick else FULL)
    say = (lambda *_: None) if as_json else partial(print, flush=True)
    picture = _picture() if out else None
    if out:
        _make_folder(out)
    head = machine.line()
    say(f"{head}\n")
    start, tables = time.perf_counter(), []
    try:
        for measure in TABLES:
            tables.append(measure(plan))
            say(f"{tables[-1].text()}\n")
    except WrongCellsError as error:
        print(json.dumps({"error": str(error)}) if as_json else f"sandglass bench: {error}")
        return 1
    took_s = time.perf_counter() - start
    say(_verdicts(tables) + f"\n\n{took_s:.0f} s")
    report = as_dict(head, tables, quick, took_s)
    if as_json:
        print(json.dumps(report))
    if out:
        _write(Path(out), head, tables, report, quick, picture)
    return 0


def as_dict(head, tables, quick, took_s):
    """Return everything as data for JSON. Times are in nanoseconds where a key says nothing else."""
    return {
        "machine": head,
        "quick": quick,
        "seconds": took_s,
        "tables": {each.key: each.as_dict() for each in tables},
        "goals": [goal.as_dict() for each in tables for goal in each.goals],
    }


def markdown(head, tables, quick):
    """Return the tables as one page that says how to make it again."""
    again = f"Made by `{AGAIN}{' --quick' if quick else ''} --out DIR`; the same command makes it again."
    picture = f"![Time of an iteration against cells]({PICTURE})"
    parts = [f"# Speed\n\n{head}\n\n{again}\n\n{picture}\n", *(each.markdown() for each in tables)]
    return "\n".join([*parts, f"## Goals\n\n```\n{_verdicts(tables)}\n```\n"])


def _verdicts(tables):
    """Return every goal with its figure, and how many were met."""
    goals = [goal for each in tables for goal in each.goals]
    met = sum(goal.met for goal in goals)
    return "\n".join([f"Goals: {met} of {len(goals)} met", "", *(f"  {goal.line}" for goal in goals)])


def _picture():
    try:
        from game.study.bench import picture
    except ModuleNotFoundError as error:
        raise CannotWriteError(
            f"--out draws a picture and needs {error.name}, which is not installed: pip install 'sandglass[study]'"
        ) from None
    return picture


def _make_folder(out):
    try:
        Path(out).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotWriteError(f"--out needs a folder that can be written: {error}") from None


def _write(folder, head, tables, report, quick, picture):
    (folder / "bench.md").write_text(markdown(head, tables, quick), encoding="utf-8")
    (folder / "bench.json").write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    picture.draw({each.key: each.rows for each in tables}, folder / PICTURE)
