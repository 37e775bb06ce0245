"""Start-up: from the command to the first frame of the default scene, with kernels compiled before and without."""

import statistics
import tempfile
import time

from game.study.bench import goals
from game.study.bench.processes import NoWindowError, screen, timing
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table

MARKS = ("imported", "window", "splash", "playing")
COLUMNS = (
    Column("name", "start"),
    *(Column(mark, f"{mark} s", table.three_digits) for mark in MARKS),
    Column("starts", "starts"),
    Column("driver", "driver"),
    goals.COLUMN,
)


def start_table(plan):
    """Return when the window, the splash and the first frame are there, in seconds after the command."""
    rows, further = [], []
    notes = [
        "Seconds from starting the process; medians of the starts. Playing: the first frame of the scene is shown."
    ]
    with screen() as (environment, shown_on), tempfile.TemporaryDirectory(prefix="sandglass-") as folder:
        try:
            _start(environment)  # compiles what has not been compiled yet
            warm = _row("warm", [_start(environment) for _ in range(plan.starts)], shown_on)
            rows.append(
                warm | {"goal": goals.at_most("warm start to the first frame", warm["playing"], goals.WARM_S, " s")}
            )
            if plan.cold:
                cold = _row(
                    "cold, no compiled kernels", [_start(environment | {"SANDGLASS_CACHE_DIR": folder})], shown_on
                )
                rows.append(
                    cold | {"goal": goals.at_most("cold start to the first frame", cold["playing"], goals.COLD_S, " s")}
                )
                further = [goals.at_most("cold start to the splash", cold["splash"], goals.COLD_SPLASH_S, " s")]
        except NoWindowError as error:
            notes.append(f"left out: {error}")
    if not plan.cold:
        notes.append("The cold start is left out of a quick run.")
    return Section("start", "6 · Start-up", [Table("", COLUMNS, rows), *notes, *further])


def _start(environment):
    """Start the toy once and return its marks."""
    return timing(["--start-up", "--since", time.time_ns()], environment)


def _row(name, starts, shown_on):
    driver = starts[0]["driver"]
    return {
        "name": name,
        **{mark: statistics.median(start["marks_s"][mark] for start in starts) for mark in MARKS},
        "starts": len(starts),
        "driver": f"{driver} ({shown_on})" if shown_on else driver,
    }
