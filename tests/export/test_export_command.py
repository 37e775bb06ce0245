"""`export` writes three files, or refuses in one line and writes nothing."""

import pytest

from game import cli, load_rule, load_scene, rule_names
from game.export.folder import MARK
from game.export.rule_parts import constants
from tests.export.library import STRICT, builds, compiled, compiler_of, run
from tests.sweeps import sweep
from tests.world.rules.small_rule import TEXT, written

NAMES = {"sandglass.h", "example.c", "README.md"}


def export(*words):
    return cli.main(["export", *map(str, words)])


def test_three_files_are_written_and_written_again(tmp_path, capsys):
    out = tmp_path / "new" / "sand"
    for _ in range(2):
        assert export("--rule", "sand", "--out", out) == 0
        assert {path.name for path in out.iterdir()} == NAMES
    assert "cc -O2" in capsys.readouterr().out


def refused(capsys, *words):
    """Return the one line with which `export` refuses."""
    assert export(*words) == 2
    told = capsys.readouterr()
    assert told.out == "" and told.err.count("\n") == 1
    return told.err


def test_a_file_of_somebody_else_is_left_and_nothing_is_written(tmp_path, capsys):
    (tmp_path / "README.md").write_text("mine", encoding="utf-8")
    assert "README.md: file: found one that no export wrote" in refused(capsys, "--rule", "sand", "--out", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["README.md"]
    assert (tmp_path / "README.md").read_text(encoding="utf-8") == "mine"


def test_a_file_whose_mark_was_taken_out_is_somebodys_own(tmp_path, capsys):
    assert export("--rule", "sand", "--out", tmp_path) == 0
    capsys.readouterr()
    path = tmp_path / "example.c"
    own = path.read_text(encoding="utf-8").replace(MARK, "")
    path.write_text(own, encoding="utf-8")
    assert "example.c" in refused(capsys, "--rule", "three-sands", "--out", tmp_path)
    assert path.read_text(encoding="utf-8") == own
    assert "Three sands" not in (tmp_path / "sandglass.h").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--rule", "nope"), "nope: rule: found no such file"),
        (("--scene", "nope"), "nope: scene: found no such file"),
        (("--rule", "sand", "--scene", "kitchen"), "kitchen: rule: found alchemy, wanted a scene of sand"),
    ],
)
def test_what_is_not_there_is_told(words, said, tmp_path, capsys):
    assert said in refused(capsys, *words, "--out", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_broken_rule_file_is_told_with_its_line(tmp_path, capsys):
    path = tmp_path / "bad.toml"
    path.write_text(TEXT.replace("lw -> k.", "lw -> kq"), encoding="utf-8")
    assert "bad.toml:" in refused(capsys, "--rule", path, "--out", tmp_path / "out")


def test_a_folder_that_cannot_be_made_is_told(tmp_path, capsys):
    (tmp_path / "file").write_text("", encoding="utf-8")
    assert "cannot make the folder" in refused(capsys, "--rule", "sand", "--out", tmp_path / "file")
    assert "cannot make the folder" in refused(capsys, "--rule", "sand", "--out", tmp_path / "file" / "out")


def test_a_scene_of_too_many_runs_is_told(tmp_path, capsys):
    path = tmp_path / "noise.toml"
    path.write_text(f'cells = """\n{chr(10).join(["o." * 300] * 900)}\n"""', encoding="utf-8")
    assert "noise.toml: scene: found 540,000 runs" in refused(capsys, "--scene", path, "--out", tmp_path / "out")


@sweep("name", ["hourglass", "kitchen", "fountain"], keep=["hourglass", "fountain"])
def test_a_scene_is_painted_with_its_chances_and_schedule(name, tmp_path, capsys):
    assert export("--scene", name, "--out", tmp_path) == 0
    scene, told = load_scene(name), capsys.readouterr().out
    assert ("left out" in told) == bool(scene.fixtures)
    calls = compiled((tmp_path / "sandglass.h").read_text(encoding="utf-8"), builds()[0], tmp_path)
    twin, world = scene.world(9), calls.world(scene.cells * 0, 9)
    twin.fixtures = ()
    world.scene()
    assert (world.materials == scene.cells).all() and world.name() == twin.digest()
    assert [world.chance(each.encode()) for each in scene.rule.chances] == list(scene.rule.chances.values())


@pytest.mark.parametrize("name", rule_names())
def test_every_material_has_a_name_in_c(name):
    assert len(set(constants(load_rule(name).materials))) == len(load_rule(name).materials)


def test_names_that_would_be_the_same_in_c_are_told_apart():
    assert constants(("air", "a-b", "a b", "paper")) == [
        "SANDGLASS_AIR",
        "SANDGLASS_A_B",
        "SANDGLASS_A_B_2",
        "SANDGLASS_PAPER_3",
    ]


def test_words_of_a_rule_file_cannot_break_the_code(tmp_path):
    odd = r"*/ end /* ??/ \\ $x"
    changes = (
        ('title = "Small"', f'title = "{odd}"'),
        ("lava flows", odd),
        ('letter = "k"', 'letter = "\\""'),
        ("lw -> k. | kw", 'lw -> \\". | \\"w'),
    )
    path = written(tmp_path, *changes)
    assert export("--rule", path, "--out", tmp_path / "out") == 0
    run(*compiler_of(builds()[0]), *STRICT, "example.c", "-o", "example", cwd=tmp_path / "out")
    assert "lava" in run(tmp_path / "out" / "example", "0")
