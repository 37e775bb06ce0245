"""Writers: a report as Markdown and JSON, and its pictures as PNG."""

import json
from math import isfinite

from game.study.report.headlines import HEADLINES
from game.study.report.numerals import measurement, number
from game.study.report.report import VERDICTS, Picture, Row, Table

HEADS = ("quantity", "measured", "expected", "source", "verdict")
DPI = 120


def write(report, folder):
    """Write study.md, summary.md, study.json and the pictures into `folder`, made if need be; return the first."""
    folder.mkdir(parents=True, exist_ok=True)
    for section in report.sections:
        for item in section.items:
            if isinstance(item, Picture):
                item.figure.savefig(folder / f"{item.name}.png", dpi=DPI)
    (folder / "study.json").write_text(json.dumps(_plain(as_dict(report)), indent=1) + "\n", encoding="utf-8")
    (folder / "summary.md").write_text(summary(report), encoding="utf-8")
    path = folder / "study.md"
    path.write_text(markdown(report), encoding="utf-8")
    return path


def markdown(report):
    """Return the report as Markdown."""
    verdicts = ", ".join(f"{count} {verdict}" for verdict, count in report.verdicts.items())
    about = "; ".join(f"{name}: {value}" for name, value in report.about.items())
    parts = ["# Sandglass study", f"{about}.", f"Verdicts: {verdicts}."]
    for section in report.sections:
        parts += [f"## {section.title}", *_blocks(section.items)]
    return "\n\n".join(parts) + "\n"


def summary(report):
    """Return the README's table: how many rows of each part have which verdict, and the HEADLINES among them."""
    counts = [(section.title, *(str(n) for n in section.verdicts.values())) for section in report.sections]
    rows = [cells(row) for row in report.rows if row.quantity in HEADLINES]
    return "\n\n".join([_table(("part", *VERDICTS), counts), _table(HEADS, rows)]) + "\n"


def cells(row):
    """Return a row's columns as text, in the order of HEADS."""
    return row.quantity, measurement(row.measured, row.error), number(row.expected), row.source, row.verdict


def _blocks(items):
    """Yield the Markdown of items; rows that follow each other share a table."""
    rows = []
    for item in [*items, None]:
        if isinstance(item, Row):
            rows.append(cells(item))
            continue
        if rows:
            yield _table(HEADS, rows)
            rows = []
        if isinstance(item, Table):
            yield item.caption
            yield _table(item.heads, [[number(each) for each in row] for row in item.rows])
        elif isinstance(item, Picture):
            yield f"![{item.caption}]({item.name}.png)\n\n{item.caption}"
        elif item is not None:
            yield item


def _table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(each.replace("|", "\\|") for each in line) + " |" for line in lines)


def as_dict(report):
    """Return the report as dicts and lists, each row by the names of its fields."""
    return {
        "about": report.about,
        "verdicts": report.verdicts,
        "sections": [
            {
                "name": section.name,
                "title": section.title,
                "seconds": round(section.seconds, 2),
                "rows": [vars(row) for row in section.rows],
                "tables": [vars(item) for item in section.items if isinstance(item, Table)],
                "pictures": [
                    {"file": f"{item.name}.png", "caption": item.caption}
                    for item in section.items
                    if isinstance(item, Picture)
                ],
            }
            for section in report.sections
        ],
    }


def _plain(value):
    """Return `value` as what JSON knows: numpy's numbers as Python's, infinity and NaN as words."""
    if isinstance(value, dict):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if hasattr(value, "item"):
        return _plain(value.item())
    return str(value) if isinstance(value, float) and not isfinite(value) else value
