"""The READMEs: what the first page shows of speed and of the study is what the full tables say."""

import re
from pathlib import Path

import pytest

from game.study.summary import DEFAULTS, HEADLINES, LEGEND

ROOT = Path(__file__).parents[3]
FULL = {"How fast": ROOT / "game/study/bench/README.md", "How right": ROOT / "game/study/README.md"}


def rows_of(text):
    """Return the rows of every Markdown table in a text, each as a set of (heading, cell)."""
    found, heads = [], None
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not cells:
            heads = None
        elif heads is None:
            heads = cells
        elif not all(re.fullmatch(":?-+:?", cell) for cell in cells):
            found.append(set(zip(heads, cells, strict=True)))
    return found


def section(title):
    return re.split(r"\n## ", (ROOT / "README.md").read_text("utf-8").split(f"\n## {title}\n", 1)[1])[0]


@pytest.mark.parametrize(("title", "count"), [("How fast", 3), ("How right", 5)])
def test_every_row_on_the_first_page_is_a_row_of_the_full_table(title, count):
    shown, full = rows_of(section(title)), rows_of(FULL[title].read_text("utf-8"))
    assert len(shown) == count and len(full) > count
    for row in shown:
        assert any(row <= whole for whole in full), dict(row)


@pytest.mark.parametrize("title", FULL)
def test_the_full_tables_say_when_and_on_what_they_were_measured(title):
    head = FULL[title].read_text("utf-8").splitlines()[2]
    assert re.match(r"Measured on \d{4}-\d\d-\d\d\b.*; Python 3", head)


def test_the_study_keeps_its_summary_as_it_is_written():
    text = FULL["How right"].read_text("utf-8")
    rows = {dict(row).get("quantity") for row in rows_of(text)}
    assert rows >= HEADLINES and LEGEND in text and DEFAULTS in text


@pytest.mark.parametrize("title", FULL)
def test_the_pictures_beside_the_tables_are_there(title):
    shown = re.findall(r"!\[[^]]+\]\(([^)]+)\)", FULL[title].read_text("utf-8"))
    assert shown and all((FULL[title].parent / name).is_file() for name in shown)
    assert FULL[title].parent.relative_to(ROOT).as_posix() in section(title)
