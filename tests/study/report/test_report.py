"""The report: verdicts mean what they say, and what was found is written down."""

import json
from datetime import date
from types import SimpleNamespace

import numpy as np
import pytest

from game import cli
from game.study import run
from game.study.physics.claims import CAPTION
from game.study.report import report
from game.study.report.drawing import figure
from game.study.report.report import AGREES, DIFFERS, DISAGREES, NOTED, Picture
from game.study.report.table import Table, measurement, number, three_digits
from game.study.summary import HEADLINES


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        (report.close("q", 1.0, 0.1, 1.39, "s"), AGREES),
        (report.close("q", 1.0, 0.1, 1.41, "s"), DISAGREES),
        (report.close("q", 1.0, 0.1, 1.41, "s", expected_error=0.1), AGREES),
        (report.close("q", float("nan"), 0.1, 1.0, "s"), DISAGREES),
        (report.same("q", 3, 3, "s"), AGREES),
        (report.same("q", 3, 4, "s"), DISAGREES),
        (report.within("q", 0.9, None, 1, 2, "s"), DISAGREES),
        (report.within("q", 0.9, 0.1, 1, 2, "s"), AGREES),
        (report.within("q", 5, None, 1, float("inf"), "s"), AGREES),
        (report.claimed("q", 45, 0.1, 30, 35, "s"), DIFFERS),
        (report.claimed("q", 35.3, 0.1, 30, 35, "s"), AGREES),
        (report.likely("p", 0.00009, "s"), DISAGREES),
        (report.likely("p", 0.5, "s"), AGREES),
        (report.noted("q", 1.0), NOTED),
    ],
)
def test_a_verdict_says_whether_measured_and_expected_agree(row, expected):
    assert row.verdict == expected


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (0.123456, 0.0012, "0.1235 ± 0.0012"),
        (12345.678, 23.0, "12,346 ± 23"),
        (5, None, "5"),
        (np.int64(1_000_000), None, "1,000,000"),
        (0.25, 0.0, "0.25 ± 0"),
        (float("nan"), 0.1, "nan ± 0.1"),
        (2.0**-32, 1e-12, "2.32831e-10 ± 1e-12"),
        ("none", None, "none"),
    ],
)
def test_a_measurement_has_the_digits_its_error_allows(value, error, text):
    assert measurement(value, error) == text


@pytest.mark.parametrize(
    ("value", "shown"),
    [(0.0391, "0.0391"), (2.0, "2.00"), (85.88, "85.9"), (99.97, "100"), (2070.4, "2,070"), (0, "0")],
)
def test_a_time_or_a_pace_has_three_digits(value, shown):
    assert three_digits(value) == shown


def test_columns_without_a_word_are_aligned_on_the_right():
    table = Table.of("", ("name", "size", "p"), [("tower", "61×61", 0.5), ("1. Exact", "2", 1e-9)])
    assert table.columns_of_figures() == [False, True, True]


def test_a_number_is_short():
    assert (
        number(1 / 3) == "0.3333"
        and number(1234567.8) == "1,234,568"
        and number(1e300) == "1e+300"
        and number(float("inf")) == "inf"
    )


def part(*items):
    return SimpleNamespace(TITLE="A part", run=lambda study: (item for item in study.track(items, "working")))


@pytest.mark.parametrize(("measured", "status"), [(2, 0), (3, 1)])
def test_the_report_has_every_item_and_the_status_follows_the_verdicts(tmp_path, monkeypatch, measured, status):
    drawing, axes = figure()
    axes.plot([0, 1], [0, 1])
    items = (
        "A paragraph.",
        report.same("two | deux", measured, 2, "counting"),
        report.close("nothing", np.float64(0.1), float("inf"), 0.0, "faith"),
        Table.of("Some figures.", ("a", "b"), [(1, 0.5), ("x", np.int64(7))]),
        Picture("line", drawing, "A line."),
    )
    monkeypatch.setattr(run, "PARTS", {"one": part(*items)})
    assert run.run(True, tmp_path / "out", ("one",)) == status
    text = (tmp_path / "out" / "study.md").read_text("utf-8")
    assert all(each in text for each in ("A paragraph.", "two \\| deux", "Some figures.", "![A line.](line.png)"))
    found = json.loads((tmp_path / "out" / "study.json").read_text("utf-8"))
    assert found["sections"][0]["rows"][0]["measured"] == measured
    assert f"Verdicts: {2 - status} agrees, {status} disagrees, 0 differs, 0 noted." in text
    assert (tmp_path / "out" / "line.png").stat().st_size > 1000


def test_the_readme_counts_verdicts_and_shows_the_headlines_with_date_and_machine(tmp_path, monkeypatch):
    headline = sorted(HEADLINES)[0]
    claims = Table.of(CAPTION, ("real sand", "some sand"), [("it is sand", "yes: 1")])
    items = report.same(headline, 1, 1, "counting"), report.noted("an aside", 2), claims
    monkeypatch.setattr(run, "PARTS", {"one": part(*items)})
    run.run(True, tmp_path, ("one",))
    text = (tmp_path / "README.md").read_text("utf-8")
    assert "| A part | 1 | 0 | 0 | 1 |" in text and headline in text and "an aside" not in text
    assert CAPTION in text and "| it is sand | yes: 1 |" in text
    assert f"Measured on {date.today().isoformat()}, quick run; " in text and "numpy" in text
    assert "python main.py study --quick --out DIR" in text


def test_without_its_packages_the_study_says_so_in_one_line(monkeypatch, capsys):
    monkeypatch.setattr(cli, "STUDY_NEEDS", ("matplotlib", "no_such_package"))
    assert cli.main(["study"]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1 and "sandglass[study]" in message


@pytest.mark.parametrize("arguments", [["--part", "astrology"], ["--quick", "--out", "/dev/null/here"]])
def test_what_the_study_cannot_do_is_one_line(arguments, capsys, monkeypatch):
    monkeypatch.setattr(run, "PARTS", {"one": part()})
    assert cli.main(["study", *arguments]) == 2
    assert capsys.readouterr().err.count("\n") == 1
