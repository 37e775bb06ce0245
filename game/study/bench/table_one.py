"""Table I of the paper, its five sizes, beside ours. Source: Devlin & Schuster 2020, Table I (4 GHz Core i7-6700K)."""

from game.study.bench import worlds
from game.study.bench.checks import same_as_twin
from game.study.bench.rounds import MILLISECONDS, ours, take_turns, xor_pass
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.rules.rule import Rule

PAPER_MS = {
    (640, 480): 3.08,
    (800, 600): 4.57,
    (1920, 1080): 21.51,
    (2560, 1440): 38.84,
    (3840, 2160): 85.88,
}
BASELINE = (640, 480)
CALLS = 100  # iterations behind each mean, as in the paper
COLUMNS = (
    Column("size", "resolution", table.size),
    Column("cells", "cells"),
    Column("paper_ms", "paper ms", table.three_digits),
    Column("ours", "ours ms (range)", MILLISECONDS),
    Column("faster", "faster", table.ratio),
    Column("paper_scaling", "paper scaling", table.three_digits),
    Column("scaling", "our scaling", table.three_digits),
    Column("batch", "in a batch ms", MILLISECONDS),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("pace", "xor pace", table.ratio),
    Column("checked", "checked"),
)


def paper_table(plan):
    """Return the paper's Table I with our times for the same sizes."""
    rows = [_row(size, plan) for size in plan.paper_sizes]
    base = next((row["ours"] for row in rows if row["size"] == BASELINE), None)
    for row in rows:
        row["scaling"] = base and row["ours"].median / base.median
    notes = [
        f"One iteration, mean of {CALLS}, median and range of {plan.rounds} rounds. Ours: p = 1, half of all cells "
        f"sand at random, all of the lattice in motion; one call for each iteration, then all {CALLS} in one call.",
        "Gcell/s and xor pace are those of the batch. Xor pace: the time of one numpy.bitwise_xor pass, in place, over "
        "as many bits as there are cells, divided by the time of an iteration, in the same rounds.",
        "Checked: so many iterations gave the same cells as the plain twin, all of them compared. The paper's figures "
        "are from its own machine.",
    ]
    return Section("paper", "1 · Table I of the paper", [Table("", COLUMNS, rows), *notes])


def _row(size, plan):
    world, rule, cells = worlds.moving(size), Rule(), size[0] * size[1]
    checked = same_as_twin(world, rule, plan.checked)
    found = take_turns(
        [ours("ours", world, rule, 1, CALLS), ours("batch", world, rule, CALLS), xor_pass(cells, CALLS)],
        plan.rounds,
        plan.sample_ns,
    )
    paper_ms = PAPER_MS.get(size)
    return {
        "size": size,
        "cells": cells,
        "paper_ms": paper_ms,
        "paper_scaling": paper_ms and paper_ms / PAPER_MS[BASELINE],
        "ours": found["ours"],
        "faster": paper_ms and paper_ms * 1e6 / found["ours"].median,
        "batch": found["batch"],
        "gcells": cells / found["batch"].median,
        "xor": found["xor"],
        "pace": found["xor"].times(found["batch"]),
        "checked": checked,
    }
