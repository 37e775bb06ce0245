"""Laws of the settings: what was set is found again, whatever else happens to the file."""

import errno
import os
import threading
import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.world.files import settings as module
from game.world.files.atomic import FileError
from game.world.files.setting_types import Switch
from game.world.files.settings import ROWS, Settings
from game.world.sand.parameters import Knob

CHANGED = {"theme": "day", "ui_scale": 1.5, "sound": True, "hints_seen": ("paint", "flip"), "brush": 12}


@pytest.fixture
def path(tmp_path):
    return tmp_path / "config" / "settings.toml"


def saved(path, **values):
    """Return the text of the file after `values` were set and saved."""
    changed = Settings(path)
    for name, value in values.items():
        changed[name] = value
    changed.take_unsaved()()
    return path.read_text(encoding="utf-8")


def edited(path, text):
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return Settings(path)


def test_what_was_set_is_found_again(path):
    assert tomllib.loads(saved(path, **CHANGED))["ui_scale"] == 1.5
    found = Settings(path)
    assert found.problem is None and all(found[name] == value for name, value in CHANGED.items())


def test_the_file_tells_every_setting_its_default_and_what_it_takes(path):
    text = saved(path)
    assert set(tomllib.loads(text)) == {"version"}
    for row in ROWS:
        assert f"# {row.name} = " in text and row.wanted in text
    uncommented = text.replace("# Sandglass", "#").replace("\n# ", "\n")
    settings_lines = [
        line for line in uncommented.split("\n") if line.partition(" = ")[0] in {row.name for row in ROWS}
    ]
    assert edited(path, "\n".join(settings_lines)).problem is None and len(settings_lines) == len(ROWS)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('theme = "nigth"', "line 2: theme: found 'nigth', wanted one of day, night, high-contrast"),
        ("theme = night", "line 2: found 'theme = night', wanted key = value"),
        ("ui_scale = 9", "line 2: ui_scale: found 9, wanted in [0.75, 3]"),
        ("ui_scale = nan", "line 2: ui_scale: found nan, wanted in [0.75, 3]"),
        ("sound = 1", "line 2: sound: found 1, wanted true or false"),
        ("hints_seen = 'paint'", "line 2: hints_seen: found 'paint', wanted a list of at most 100 words"),
        ("nonsense", "line 2: found 'nonsense', wanted key = value"),
        (b"theme = '\xff'", "line 2: found \"theme = '\ufffd'\", wanted key = value"),
        (f"brush = 1{'0' * 9000}", f"line 2: found 'brush = 1{'0' * 41}', wanted key = value"),
    ],
)
def test_a_bad_line_is_named_and_costs_no_other(path, line, told):
    line = line if isinstance(line, bytes) else line.encode()
    found = edited(path, b"volume = 0.25\n" + line + b"\nsmooth_streams = false\n")
    assert found.problem == f"{path}: {told}; the default is used"
    assert found["volume"] == 0.25 and not found["smooth_streams"]
    assert found["theme"] == "night" and found["ui_scale"] == 1.0 and found["brush"] == 6


def test_a_bad_line_is_told_of_once_and_stays_in_the_file(path):
    edited(path, 'theme = "nigth"\n')
    for _ in range(2):
        text = saved(path, volume=0.1)
        assert text.count('#? theme = "nigth"') == 1 and Settings(path).problem is None


def test_what_another_version_wrote_is_kept(path):
    later = 'version = 7\nlustre = "high"\nvolume = 0.75\n[sky]\nstars = 3\n'
    assert edited(path, later).problem is None
    for _ in range(2):
        found = tomllib.loads(saved(path, theme="day"))
        assert found == {"version": 7, "lustre": "high", "volume": 0.75, "theme": "day", "sky": {"stars": 3}}


def test_a_setting_that_a_later_version_adds_has_its_default(path):
    saved(path, theme="day")
    found = Settings(path, (*ROWS, Switch("lustre", True, "shine")))
    assert found["lustre"] and found["theme"] == "day" and found.problem is None


def test_a_flag_wins_and_is_not_saved(path):
    saved(path, ui_scale=1.25)
    found = Settings(path)
    found.override("ui_scale", 2)
    assert found["ui_scale"] == 2 and not found.unsaved
    found["theme"] = "day"
    found.take_unsaved()()
    assert Settings(path)["ui_scale"] == 1.25
    found["ui_scale"] = 3
    assert found["ui_scale"] == 3 and found.unsaved


def test_two_windows_keep_what_the_other_changed(path):
    one, other = Settings(path), Settings(path)
    one["theme"], other["volume"] = "day", 0.1
    for each in (one, other):
        each.take_unsaved()()
    assert (Settings(path)["theme"], Settings(path)["volume"]) == ("day", 0.1)


def test_many_windows_at_once_lose_nothing(path):
    rows = [Knob(f"knob_{number}", 0, 0, 9, "", "turns", whole=True) for number in range(12)]

    def change(name):
        window = Settings(path, rows)
        window[name] = 5
        window.take_unsaved()()

    threads = [threading.Thread(target=change, args=(row.name,)) for row in rows]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(Settings(path, rows)[row.name] == 5 for row in rows)
    assert sorted(os.listdir(path.parent)) == [".settings.toml.lock", "settings.toml"]


def test_only_what_is_allowed_can_be_set():
    for name, value in (("theme", "pink"), ("ui_scale", 9), ("sound", 1), ("hints_seen", ["\n"]), ("brush", 1.5)):
        with pytest.raises(ValueError, match=f"{name} must be"):
            Settings()[name] = value


def test_a_file_that_cannot_be_read_or_written_is_told_in_one_line(tmp_path, monkeypatch):
    (tmp_path / "folder").mkdir()
    found = Settings(tmp_path / "folder")
    assert "found a folder" in found.problem and found["theme"] == "night"
    (tmp_path / "file").write_text("")
    other = Settings(tmp_path / "file" / "settings.toml")
    other["theme"] = "day"
    with pytest.raises(FileError, match="cannot save"):
        other.take_unsaved()()
    monkeypatch.setattr(module, "LARGEST_FILE", 100)
    assert "at most 100 bytes" in edited(tmp_path / "large.toml", "#" * 101).problem


def test_a_folder_that_is_closed_to_the_user_gives_the_defaults_and_a_line(path, monkeypatch):
    def denied(*_, **__):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(type(path), "stat", denied)
    found = Settings(path)
    assert found["theme"] == "night" and "cannot read: permission denied" in found.problem


WHOLE = b'version = 1\ntheme = "day"\nui_scale = 1.5\nhints_seen = ["paint", "flip"]\nother = 3\nsound = true\n'
PIECES = st.one_of(
    st.binary(max_size=4), st.sampled_from([b"\n", b"[", b"[[a]]\n", b"=", b'"', b"#?", b"'''", b"\r\n"])
)


@given(st.lists(st.tuples(st.integers(0, len(WHOLE)), PIECES, st.integers(0, 9)), min_size=1, max_size=4))
def test_a_damaged_file_gives_settings_that_can_be_used_and_saved(tmp_path, damages):
    data = WHOLE
    for at, piece, gone in damages:
        data = data[:at] + piece + data[at + gone :]
    path = tmp_path / "settings.toml"
    found = edited(path, data)
    assert found.problem is None or found.problem.isprintable()
    for name, row in found.rows.items():
        row.check(found[name])
    before = {name: found[name] for name in found.rows}
    saved(path)
    again = Settings(path)
    assert {name: again[name] for name in again.rows} == before and again.problem is None
    text = path.read_bytes()
    saved(path)
    assert path.read_bytes() == text


def test_every_bad_line_is_named_up_to_a_number(tmp_path):
    bad = [f'theme = "bad {number}"' for number in range(7)]
    told = edited(tmp_path / "settings.toml", "\n".join(bad[:3])).problem
    assert "line 1: theme" in told and told.endswith("; the same with line 2, line 3")
    assert edited(tmp_path / "many.toml", "\n".join(bad)).problem.endswith("line 5, line 6, more")
