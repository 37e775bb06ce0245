"""The paper's p on an hourglass in mid-flow, from its 61×61 cells to the largest lattice."""

from game.study.bench import goals, worlds
from game.study.bench.checks import same_as_twin
from game.study.bench.rounds import MICROSECONDS, ours, take_turns, xor_pass
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.rules.rule import Rule

PAPER_P = (0.25, 0.5, 0.75)
COLUMNS = (
    Column("size", "lattice", table.size),
    Column("p", "p", "{:g}".format),
    Column("time", "µs per iteration", MICROSECONDS),
    Column("xor", "xor pass µs", MICROSECONDS),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("pace", "xor pace", table.ratio),
    Column("checked", "checked"),
    goals.COLUMN,
)


def glass_table(plan):
    """Return the time of an iteration of hourglasses in mid-flow for the paper's values of p."""
    rows = [row for size in plan.glass_sizes for row in _rows(size, plan)]
    notes = [
        f"The shipped hourglass drawn at that size, about {worlds.PASSED:.0%} of its sand below, {plan.batch} "
        f"iterations in one call. Above {worlds.TALLEST} rows the sand is that of a smaller glass, enlarged, and has "
        f"then run 1/{worlds.REST} of the height in iterations.",
    ]
    title = "3b · What a scene needs: the paper's p, hourglass in mid-flow"
    return Section("glass", title, [Table("", COLUMNS, rows), *notes])


def _rows(size, plan):
    world, cells = worlds.flowing(size), size[0] * size[1]
    rules = {p: Rule.with_p(p, worlds.GLASS_RULE.schedule) for p in (*PAPER_P, 1.0)}
    checked = {p: same_as_twin(world, rule, plan.checked) for p, rule in rules.items()}
    workloads = [ours(p, world, rule, plan.batch) for p, rule in rules.items()]
    found = take_turns([*workloads, xor_pass(cells, plan.batch)], plan.rounds, plan.sample_ns)
    return [
        {
            "size": size,
            "p": p,
            "time": found[p],
            "xor": found["xor"],
            "gcells": cells / found[p].median,
            "pace": found["xor"].times(found[p]),
            "checked": checked[p],
            "goal": _goal(size, p, found[p], found["xor"]),
        }
        for p in rules
    ]


def _goal(size, p, timing, xor):
    what = f"hourglass in mid-flow, p = {p:g}, {table.size(size)}"
    if size in goals.SMALL_US:
        return goals.at_most(what, timing.median / 1e3, goals.SMALL_US[size], " µs")
    cells = size[0] * size[1]
    if cells < goals.PACED_FROM or p == 1.0:
        return None
    wanted = goals.PACE_CHANCE_LARGEST if cells >= goals.LARGEST else goals.PACE_CHANCE
    return goals.at_least(f"{what}: xor pace", xor.times(timing), wanted)
