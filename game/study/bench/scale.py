"""Scale: the time of a cell from the smallest lattice to the largest."""

from game.study.bench import goals, worlds
from game.study.bench.checks import same_as_table_twin, same_as_twin
from game.study.bench.materials import ALCHEMY, SAND, rules
from game.study.bench.rounds import MICROSECONDS, Workload, ours, take_turns, xor_pass
from game.study.report import machine, table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.sand.advance import advance

REFERENCE = (1920, 1080)  # its time per cell is 1
FLAT = 1.5  # times the reference up to which the time per cell counts as flat
COLUMNS = (
    Column("rule", "rule"),
    Column("size", "lattice", table.size),
    Column("cells", "cells"),
    Column("planes_mb", "planes MB", table.three_digits),
    Column("batch", "in one call"),
    Column("time", "µs per iteration", MICROSECONDS),
    Column("cell_ps", "ps per cell", table.three_digits),
    Column("relative", "of 1080p", table.ratio),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("pace", "xor pace", table.ratio),
    Column("checked", "checked"),
    goals.COLUMN,
)


def scale_table(plan):
    """Return the time per cell of lattices in motion by size, of sand at p = 1 and of a rule of sixteen materials."""
    rows = _rows_of(SAND, plan.scale_sizes, plan) + _rows_of(ALCHEMY, plan.rule_scale_sizes, plan)
    notes = [
        "Half of all cells sand at random, or of all materials but wall, so many iterations in one call that none of "
        "it comes to rest."
    ]
    notes += [
        f"Not flat: {row['rule']}, {table.size(row['size'])}, {table.ratio(row['relative'])}, {row['why']}."
        for row in rows
        if row["why"]
    ]
    planes = [
        goals.at_most(f"planes of {table.size(row['size'])}", row["planes_mb"], goals.PLANES_MB, " MB")
        for row in rows
        if row["cells"] >= goals.LARGEST and row["rule"] == SAND
    ]
    return Section("scale", "4 · Scale", [Table("", COLUMNS, rows), *notes, *planes])


def _rows_of(name, sizes, plan):
    """Return the rows of a rule, each beside that of its own REFERENCE."""
    rows = [_row(name, size, plan) for size in sizes]
    reference = next((row for row in rows if row["size"] == REFERENCE), rows[-1])
    for row in rows:
        row["relative"] = row["cell_ps"] / reference["cell_ps"]
        row["why"] = _why(row)
    return rows


def _row(name, size, plan):
    rule, cells = rules()[name], size[0] * size[1]
    world = worlds.moving(size) if name == SAND else worlds.strewn(size, rule)
    checked = (same_as_twin if name == SAND else same_as_table_twin)(world, rule, plan.checked)
    batch = worlds.moving_iterations(size, plan.batch)
    call = Workload("call", lambda state: advance(state, rule, 0), world.copy, batch)
    found = take_turns(
        [ours("time", world, rule, batch), xor_pass(cells, batch), call], plan.rounds, plan.sample_ns // 4
    )
    return {
        "rule": name,
        "size": size,
        "cells": cells,
        "batch": batch,
        "planes_mb": _bytes_of(world) / 1e6,
        **found,
        "cell_ps": 1e3 * found["time"].median / cells,
        "gcells": cells / found["time"].median,
        "pace": found["xor"].times(found["time"]),
        "checked": checked,
        "goal": _goal(size, found["time"], found["xor"]) if name == SAND else None,
    }


def _bytes_of(world):
    """Return what the planes of `world` take, and whatever other arrays it keeps."""
    return sum(getattr(getattr(world, name), "nbytes", 0) for name in world.__slots__)


def _goal(size, timing, xor):
    cells = size[0] * size[1]
    if cells < goals.PACED_FROM:
        return None
    wanted = goals.PACE_P1_LARGEST if cells >= goals.LARGEST else goals.PACE_P1
    return goals.at_least(f"all moving, p = 1, {table.size(size)}: xor pace", xor.times(timing), wanted)


def _why(row):
    """Say why a cell of this lattice takes longer than one of the reference, in a few words, or None if it does not."""
    if row["relative"] <= FLAT:
        return None
    if row["cells"] < REFERENCE[0] * REFERENCE[1]:
        call = row["call"].median / row["time"].median
        return f"as a loop has few words, and the call itself is {call:.0%}"
    cache = next((size for size in machine.cache_bytes() if size > row["planes_mb"] * 1e6), None)
    return "as the planes outgrow the caches" if cache is None else "as the planes outgrow the first caches"
