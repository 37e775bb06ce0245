"""The study: runs its parts one after the other, shows what they find and writes it down.

A part is a module with a TITLE and a function `run(study)` that yields Rows, Tables, Pictures and paragraphs (str) in
the order of reading. `study.quick` asks for a run of seconds; `study.track` draws a bar.
"""

import time
from dataclasses import dataclass
from pathlib import Path

from game.study import hard_cases, schedules
from game.study.exact import part as exact
from game.study.paper import part as paper
from game.study.physics import part as physics
from game.study.report.console import Terminal
from game.study.report.markdown import write
from game.study.report.report import DISAGREES, Report, Section, count_verdicts
from game.study.summary import summary
from game.study.trade import part as trade
from game.world.files.atomic import make_folder

PARTS = {
    "exact": exact,
    "paper": paper,
    "trade": trade,
    "schedules": schedules,
    "hard": hard_cases,
    "physics": physics,
}  # in the order of reading


@dataclass(frozen=True)
class Study:
    """What a part may ask while it runs."""

    quick: bool
    terminal: Terminal

    def track(self, items, words, total=None):
        """Yield from `items` behind a progress bar that says `words`; total: their number, where `len` cannot tell."""
        return self.terminal.track(items, words, total)

    def either(self, quick, full):
        """Return `quick` in a quick run, else `full`."""
        return quick if self.quick else full


def run(quick=False, folder=Path("study"), parts=tuple(PARTS)):
    """Run the parts named, write the report to `folder` and return 1 if a row disagrees, else 0.

    Raises FileError if the folder cannot be written to.
    """
    make_folder(folder)  # before the work: a folder that cannot be made would waste it
    study = Study(quick, Terminal())
    report = Report("study", "How right the sand is", quick)
    for name in parts:
        section = run_part(study, name, PARTS[name])
        study.terminal.show(section, section.rows)
        report.sections.append(section)
    verdicts = count_verdicts(report.rows)
    counts = ", ".join(f"{count} {verdict}" for verdict, count in verdicts.items())
    pages = {"README.md": summary(report), "study.md": [f"Verdicts: {counts}.", *report.items]}
    write(report, pages, folder)
    study.terminal.say(f"{counts}; written to {folder / 'study.md'}")
    return 1 if verdicts[DISAGREES] else 0


def run_part(study, name, part):
    """Return the Section that a part makes."""
    section = Section(name, part.TITLE)
    start = time.perf_counter()
    with study.terminal.at_work(part.TITLE):
        section.items.extend(part.run(study))
    section.seconds = time.perf_counter() - start
    return section
