"""What the README says is so."""

import contextlib
import io
import re
from pathlib import Path

import pytest

from game import load_scene, scene_names

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(section):
    """Return the code blocks of a section, in order."""
    body = re.split(r"\n##+ ", README.split(f"\n{section}\n", 1)[1])[0]
    return re.findall(r"^```\w*\n(.*?)^```$", body, re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("section", ["## Run", "## Test"])
def test_one_line_sets_everything_up(section):
    assert blocks(section)[0].count("\n") == 1


def test_the_ten_lines_print_what_is_shown_below_them():
    code, output = blocks("## In your own program")
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})
    assert printed.getvalue() == output


def test_the_scene_shown_is_a_scene(tmp_path):
    path = tmp_path / "wedge.toml"
    path.write_text(blocks("### A scene file")[0], encoding="utf-8")
    scene = load_scene(path)
    assert scene.shape == (40, 60) and scene.sand.sum() == 160 and scene.walls.any()


def test_every_shipped_scene_is_named():
    assert all(f"`{name}`" in README for name in scene_names())


def test_every_picture_shown_is_there_and_no_other():
    shown = set(re.findall(r"\((assets/pictures/[^)]+)\)", README))
    kept = {path.relative_to(ROOT).as_posix() for path in (ROOT / "assets" / "pictures").iterdir()}
    assert shown == kept
