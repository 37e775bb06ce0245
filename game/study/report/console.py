"""The terminal: a bar while a part works, then its tables and paragraphs."""

from contextlib import contextmanager

from rich import box
from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table as RichTable
from rich.text import Text

from game.study.report.report import AGREES, DIFFERS, DISAGREES, NOTED, Picture, blocks
from game.study.report.table import Table

STYLES = {AGREES: "green", DISAGREES: "bold red", DIFFERS: "yellow", NOTED: "dim"}
WIDE = 240  # characters to a line where the output is no terminal: no cell is broken


class Terminal:
    """What one run shows while it works; `quiet` shows nothing."""

    def __init__(self, quiet=False):
        self._console = Console(quiet=quiet)
        if not self._console.is_terminal:
            self._console.width = WIDE
        self._progress = None

    @contextmanager
    def at_work(self, title):
        """Show a bar with `title` while the body runs."""
        columns = SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()
        with Progress(*columns, console=self._console, transient=True) as self._progress:
            self._progress.add_task(title, total=None)
            yield

    def track(self, items, words, total=None):
        """Yield from `items` behind a bar of their own; total: their number, where `len` cannot tell."""
        task = self._progress.add_task(f"  {words}", total=len(items) if total is None else total)
        for item in items:
            yield item
            self._progress.advance(task)
        self._progress.remove_task(task)

    def show(self, section, items):
        """Print the title of a section and some items of it."""
        self.say(f"{section.title} ({section.seconds:.1f} s)" if section.seconds else section.title, "bold")
        for item in blocks(items):
            if isinstance(item, Table):
                self._show_table(item)
            elif not isinstance(item, Picture):
                self.say(item)
        self.say("")

    def _show_table(self, table):
        shown = RichTable(title=table.caption or None, title_justify="left", box=box.SIMPLE_HEAD)
        for column, of_figures in zip(table.columns, table.columns_of_figures(), strict=True):
            shown.add_column(column.heading, justify="right" if of_figures else "left")
        for cells in table.cells():
            shown.add_row(*(Text(cell, STYLES.get(cell, "")) for cell in cells))
        self._console.print(shown)

    def say(self, words, style=""):
        """Print a line."""
        self._console.print(Text(str(words), style))
