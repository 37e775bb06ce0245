"""`rule` tells what a rule says and keeps, in words or in a picture."""

import re
from itertools import product

import pytest
from PIL import Image

from game import cli, load_rule, rule_names
from game.core.compiler.plan import gate_count, kinds_of, plan
from tests.sweeps import sweep
from tests.world.rules.small_rule import TEXT, written


@sweep("name", rule_names(), keep=["sand", "alchemy"])
def test_all_of_a_rule_is_told(name, capsys):
    assert cli.main(["rule", name]) == 0
    told, rule = capsys.readouterr().out, load_rule(name)
    for each in (*rule.materials, *rule.chances, *(law.words for law in rule.definition.books)):
        assert each in told
    for event in rule.definition.told_events():
        head, first = re.escape(event.name), re.escape(event.picture.lines()[0])
        assert re.search(rf"^  {head}: .+\n    {first}", told, re.M)
    assert max(map(len, told.splitlines())) <= 180


def test_words_are_these(tmp_path, capsys):
    assert cli.main(["rule", str(written(tmp_path))]) == 0
    told = capsys.readouterr().out
    assert "4     w       water     liquid  20       flow 0.5" in told
    assert "lava + stone is kept                  yes   by every event" in told
    assert "  lava and water: boil 0.5 | 0.25, turned all ways\n    lw -> k. | kw\n" in told
    assert "  flow: M.flow, mirrored too\n    M. -> .M\n    ##    ##\n" in told


@sweep("name", rule_names(), keep=["sand", "water-and-oil"])
def test_a_rule_is_drawn(name, tmp_path):
    assert cli.main(["rule", name, "--out", str(tmp_path / "rule.png")]) == 0
    with Image.open(tmp_path / "rule.png") as image:
        colours = {colour for _, colour in image.convert("RGB").getcolors(2**20)}
    assert {each.colour for each in load_rule(name).definition.materials} <= colours


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (TEXT.replace("lw -> k.", "lw -> kq"), "event 'lava and water': picture: found 'q', wanted"),
        ("?", "found broken TOML"),
    ],
)
def test_a_bad_file_is_refused_in_one_line(text, said, tmp_path, capsys):
    path = tmp_path / "bad.toml"
    path.write_text(text, encoding="utf-8")
    assert cli.main(["rule", str(path)]) == 2
    told = capsys.readouterr()
    assert told.out == "" and told.err.count("\n") == 1 and said in told.err


def test_a_picture_that_cannot_be_saved_is_told(tmp_path, capsys):
    assert cli.main(["rule", "sand", "--out", str(tmp_path / "no" / "rule.png")]) == 2
    assert "cannot save" in capsys.readouterr().err


def test_what_an_included_file_says_of_classes_that_are_not_there_is_left_out(capsys):
    assert cli.main(["rule", "water-and-oil"]) == 0
    told = capsys.readouterr().out
    assert "  pour: " in told and "  rise: " not in told and "never" not in told


@pytest.mark.parametrize("name", ["sand", "water-and-oil"])
def test_how_many_block_states_have_an_event_and_how_many_gates_say_so_is_told(name, capsys):
    rule = load_rule(name)
    states = list(product(range(len(rule.materials)), repeat=4))
    busy = sum(bool(rule.outcomes(block)) for block in states)
    assert cli.main(["rule", name]) == 0
    told = capsys.readouterr().out
    gates = gate_count(plan(rule.table, kinds_of(rule.table, rule.values)))
    assert f"Something can happen in {busy:,} of {len(states):,} block states; the circuit for it has {gates}" in told
