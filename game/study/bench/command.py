"""The command: measures table after table, shows each, and writes them down."""

import json
import time

from game.study.bench import (
    acts,
    frames,
    hourglass_p,
    materials,
    peer_table,
    rules_and_motion,
    scale,
    start_up,
    table_one,
)
from game.study.bench.checks import WrongCellsError
from game.study.bench.goals import goal_section
from game.study.bench.plan import FULL, QUICK
from game.study.report.console import Terminal
from game.study.report.markdown import as_dict, write
from game.study.report.report import Report
from game.world.files.atomic import make_folder

TABLES = (
    table_one.paper_table,
    peer_table.peer_table,
    materials.rule_peer_table,
    rules_and_motion.scene_table,
    hourglass_p.glass_table,
    materials.material_table,
    acts.act_table,
    scale.scale_table,
    frames.frame_table,
    start_up.start_table,
)


def run(quick=False, as_json=False, folder=None, plan=None):
    """Run the bench and return the exit status: 0, or 1 where an implementation moved sand elsewhere than the twin.

    folder: where the tables go as Markdown and JSON, and the picture, if anywhere. Raises FileError before anything is
    measured if it cannot be made.
    """
    if folder:
        make_folder(folder)
    terminal, report = Terminal(quiet=as_json), Report("bench", "How fast the sand is", quick)
    terminal.say(f"{report.machine}\n")
    try:
        for measure in TABLES:
            section = _timed(measure, plan or (QUICK if quick else FULL))
            terminal.show(section, section.items)
            report.sections.append(section)
    except WrongCellsError as error:
        print(json.dumps({"error": str(error)}) if as_json else f"sandglass bench: {error}")
        return 1
    goals = goal_section(report.sections)
    terminal.show(goals, goals.items)
    report.sections.append(goals)
    terminal.say(f"{sum(section.seconds for section in report.sections):.0f} s")
    if as_json:
        print(json.dumps(as_dict(report)))
    if folder:
        _write(report, folder)
    return 0


def _timed(measure, plan):
    """Return the section that `measure` makes, with the seconds that it took."""
    start = time.perf_counter()
    section = measure(plan)
    section.seconds = time.perf_counter() - start
    return section


def _write(report, folder):
    from game.study.bench import picture  # here, as nothing else in the bench needs matplotlib

    rows = {section.name: section.tables[0].rows for section in report.sections}
    write(report, {"README.md": [picture.draw(rows), *report.items]}, folder)
