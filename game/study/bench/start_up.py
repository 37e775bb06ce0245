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
NOTE = (
    "Seconds from starting the process; medians of the starts. Playing: the first frame of the scene is shown. Cold: "
    "no kernel has been compiled before."
)


def start_table(plan):
    """Return when the window, the splash and the first frame are there, in seconds after the command."""
    rows, remarks = [], []
    with screen() as (environment, shown_on), tempfile.TemporaryDirectory(prefix="sandglass-") as folder:
        try:
            _start(environment)  # compiles what has not been compiled yet
            starts = [_start(environment) for _ in range(plan.starts)]
            rows.append(_row("warm", starts, shown_on, goals.WARM_S))
            if plan.cold:
                cold = _start(environment | {"SANDGLASS_CACHE_DIR": folder})
                rows.append(_row("cold", [cold], shown_on, goals.COLD_S))
                splash_s = rows[-1]["splash"]
                remarks.append(goals.at_most("cold start to the splash", splash_s, goals.COLD_SPLASH_S, " s"))
        except NoWindowError as error:
            remarks.append(f"left out: {error}")
    if not plan.cold:
        remarks.append("The cold start is left out of a quick run.")
    return Section("start", "6 · Start-up", [Table("", COLUMNS, rows), NOTE, *remarks])


def _start(environment):
    """Start the toy once and return its report."""
    return timing(["--start-up", "--since", time.time_ns()], environment)


def _row(name, starts, shown_on, limit_s):
    """Return the row of a kind of start whose first frame is wanted within `limit_s` seconds."""
    driver = starts[0]["driver"]
    marks = {mark: statistics.median(start["marks_s"][mark] for start in starts) for mark in MARKS}
    return {
        "name": name,
        **marks,
        "starts": len(starts),
        "driver": f"{driver} ({shown_on})" if shown_on else driver,
        "goal": goals.at_most(f"{name} start to the first frame", marks["playing"], limit_s, " s"),
    }
