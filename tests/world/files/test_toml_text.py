"""Laws of TOML: what it costs is bounded by its length, and texts may hold what they like."""

import tomllib

import pytest

from game.world.files.settings import ROWS
from game.world.files.settings_format import read_lines
from game.world.files.toml_text import DEEPEST, parse_toml
from game.world.scenes.scene import SceneError, load_scene

DEEP = ".".join("a" * 20_000)


@pytest.mark.parametrize(
    "text",
    [
        f"{DEEP} = 1",
        f"[{DEEP}]",
        f"[[ {DEEP} ]]",
        f"x = {{ {DEEP} = 1 }}",
        f"{DEEP.replace('a', chr(34) * 2).replace('.', ' . ')} = 1",
        f"{DEEP.replace('a', repr('a'))} = 1",
        f'x = """it"""\n{DEEP} = 1',
    ],
)
def test_a_key_of_thousands_of_parts_is_refused_before_it_is_read(tmp_path, monkeypatch, text):
    monkeypatch.setattr(tomllib, "loads", lambda text: {"x": "it"} if len(text) < 100 else pytest.fail("read"))
    (tmp_path / "some.toml").write_text(text)
    with pytest.raises(SceneError, match="found a number or a nesting out of bounds"):
        load_scene(tmp_path / "some.toml")
    kept = read_lines(text.encode(), {row.name: row for row in ROWS})
    assert not kept.values


@pytest.mark.parametrize(
    "text",
    [
        f"x = '{DEEP}'",
        f'x = "{DEEP}"',
        f'x = """\n{DEEP}\n"""',
        f"x = '''\n{DEEP}\n'''",
        f"x = 1 # {DEEP}",
        f'x = "\\"{DEEP}"',
        ".".join("a" * DEEPEST) + " = 1",
        "x = [1.5, 2.5, 3.5]",
    ],
)
def test_texts_comments_and_ordinary_keys_are_read_as_ever(text):
    assert parse_toml(text) == tomllib.loads(text)


UNENDED = ('x = """' + '\\"""' * 50_000, 'x = "' + '\\"' * 50_000, "'" * 50_001, "a." * 50_000)


@pytest.mark.parametrize("text", UNENDED)
def test_what_has_no_end_is_refused_at_once(text):
    with pytest.raises(ValueError):
        parse_toml(text)
