"""What the terminal shows: a bar while a part works, then its rows in a table."""

from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table as RichTable
from rich.text import Text

from game.study.report.markdown import HEADS, cells
from game.study.report.report import AGREES, DIFFERS, DISAGREES, NOTED

STYLES = {AGREES: "green", DISAGREES: "bold red", DIFFERS: "yellow", NOTED: "dim"}


class Desk:
    """The terminal of one run of the study."""

    def __init__(self, console=None):
        self.console = console or Console()
        self._progress = None

    @contextmanager
    def at_work(self, title):
        """Show a bar with `title` while the body runs."""
        columns = SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()
        with Progress(*columns, console=self.console, transient=True) as self._progress:
            self._progress.add_task(title, total=None)
            yield

    def track(self, items, words, total=None):
        """Yield from `items` behind a bar of their own; total: their number, where `len` cannot tell."""
        task = self._progress.add_task(f"  {words}", total=len(items) if total is None else total)
        for item in items:
            yield item
            self._progress.advance(task)
        self._progress.remove_task(task)

    def show(self, section):
        """Print the rows of a section that is done."""
        table = RichTable(*HEADS, title=f"{section.title} ({section.seconds:.1f} s)", title_justify="left")
        for row in section.rows:
            *words, verdict = cells(row)
            table.add_row(*map(Text, words), Text(verdict, STYLES[verdict]))
        self.console.print(table)

    def say(self, text, **options):
        """Print a line."""
        self.console.print(Text(text), **options)
