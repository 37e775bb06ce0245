"""Writing: a report as pages of Markdown with their pictures, and as JSON."""

import io
import json
from math import isfinite

from game.study.report.report import Finding, Picture, blocks
from game.study.report.table import Table
from game.world.files.atomic import save

DOTS_PER_INCH = 120


def write(report, pages, folder):
    """Write the pages ({file name: items}), their pictures and the report as JSON into a folder; raise FileError."""
    pictures = {}
    for name, items in pages.items():
        save(folder / name, page(report, items).encode())
        pictures |= {item.name: item.figure for item in items if isinstance(item, Picture)}
    for name, figure in pictures.items():
        file = io.BytesIO()
        figure.savefig(file, dpi=DOTS_PER_INCH)
        save(folder / f"{name}.png", file.getvalue())
    text = json.dumps(as_dict(report), indent=1)
    save(folder / f"{report.name}.json", f"{text}\n".encode())


def page(report, items):
    """Return a page of Markdown: title, date and machine, the command that makes it again, and the items."""
    extent = "quick" if report.quick else "full"
    head = (
        f"# {report.title}",
        f"Measured on {report.date}, {extent} run; {report.machine}.",
        f"Made by `{report.command}`; the same command makes it again.",
    )
    return "\n\n".join([*head, *map(_block, blocks(items))]) + "\n"


def _block(item):
    if isinstance(item, Table):
        return "\n\n".join(filter(None, (item.caption, _table(item))))
    if isinstance(item, Picture):
        return f"![{item.caption}]({item.name}.png)\n\n{item.caption}"
    return str(item)


def _table(table):
    heads = [each.heading for each in table.columns]
    sides = ["---:" if of_figures else ":---" for of_figures in table.columns_of_figures()]
    lines = [heads, sides, *table.cells()]
    return "\n".join("| " + " | ".join(each.replace("|", "\\|") for each in line) + " |" for line in lines)


def as_dict(report):
    """Return the report as dicts and lists that JSON knows, each row by the names of its fields."""
    return {
        "date": report.date,
        "machine": report.machine,
        "quick": report.quick,
        "seconds": round(sum(section.seconds for section in report.sections), 2),
        "sections": [_section_as_dict(section) for section in report.sections],
    }


def _section_as_dict(section):
    pictures = [item for item in section.items if isinstance(item, Picture)]
    notes = [str(item) for item in section.items if not isinstance(item, Finding | Table | Picture)]
    return {
        "name": section.name,
        "title": section.title,
        "seconds": round(section.seconds, 2),
        "rows": [_plain(vars(row)) for row in section.rows],
        "tables": [{"caption": table.caption, "rows": _plain(table.rows)} for table in section.tables],
        "pictures": [{"file": f"{each.name}.png", "caption": each.caption} for each in pictures],
        "notes": notes,
    }


def _plain(value):
    """Return `value` as what JSON knows: numpy's numbers as Python's, infinity and NaN as words."""
    if hasattr(value, "as_dict"):
        value = value.as_dict()
    if isinstance(value, dict):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if hasattr(value, "item"):
        return _plain(value.item())
    return str(value) if isinstance(value, float) and not isfinite(value) else value
