"""Laws of rule files at the window: chosen, dropped, copied and changed on the disk, each is one act, or one line."""

import os

import pygame
import pytest

from game.play.storage.rule_files import POLL_S
from game.world.files.atomic import FileError
from game.world.files.paths import asset, folder_of
from game.world.rules.own_rules import copy_rule
from game.world.rules.rule import load_rule
from tests.play.player import Player

WATER = asset("rules", "water-and-oil.toml")


@pytest.fixture
def player():
    """Return a player of the aquarium, with time held."""
    player = Player("aquarium")
    player.hold_time()
    player.wait(1)
    yield player
    pygame.display.quit()


def own_file(tmp_path, old="", new=""):
    """Write the rule of water and oil to a file, with one text in place of another; return its path."""
    path = tmp_path / "pond.toml"
    path.write_text(WATER.read_text("utf-8").replace(old, new), "utf-8")
    return path


def look_again(player):
    """Let the window look at its files as often as it takes to read one anew."""
    for _ in range(4):
        player.frame(elapsed_ns=int(2e9 * POLL_S))
    player.settle()
    player.frame(elapsed_ns=0)


def change(path, old, new):
    path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")
    os.utime(path, ns=(1, path.stat().st_mtime_ns + 10**9))


def acts(player):
    return len(player.session.timeline.history.story())


def test_a_dropped_rule_is_played_and_undone_like_any_act(player, tmp_path):
    before, digest = player.session.rule, player.world.digest()
    player.drop(own_file(tmp_path, "value = 0.6,", "value = 0.25,"))
    assert player.session.rule.definition.name == "pond" and player.session.rule.chances["friction"] == 0.25
    player.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert player.session.rule == before and player.world.digest() == digest


def test_a_broken_rule_is_one_line_with_its_place_and_the_old_one_stays(player, tmp_path):
    before = player.session.rule
    path = own_file(tmp_path, 'class = "liquid", density = 20', 'class = "fluid", density = 20')
    player.drop(path)
    line = path.read_text("utf-8").split("fluid")[0].count("\n") + 1
    assert f"{path}:{line}: materials: water" in player.parts.notices.text and "\n" not in player.parts.notices.text
    assert player.session.rule is before


def test_a_file_changed_on_the_disk_is_read_anew_as_one_act_and_keeps_what_was_turned(player, tmp_path):
    path = own_file(tmp_path)
    player.drop(path)
    player.parts.rule_change.turn("creep", 0.125)
    player.frame(elapsed_ns=0)
    once, world = acts(player), player.world.digest()
    change(path, "value = 0.6,", "value = 0.375,")
    look_again(player)
    assert acts(player) == once + 1 and player.world.digest() == world
    assert dict(player.session.rule.chances) == {"friction": 0.375, "flow": 0.9, "creep": 0.125}
    assert "pond.toml was read anew" in player.parts.notices.text
    look_again(player)
    assert acts(player) == once + 1


def test_a_file_that_breaks_while_it_is_played_is_one_line_and_the_sand_goes_on(player, tmp_path):
    path = own_file(tmp_path)
    player.drop(path)
    before = player.session.rule
    change(path, "value = 0.6,", "value = 6,")
    look_again(player)
    assert player.session.rule is before
    assert f"{path}:" in player.parts.notices.text and "the rule stays as it was" in player.parts.notices.text
    change(path, "value = 6,", "value = 0.5,")
    look_again(player)
    assert player.session.rule.chances["friction"] == 0.5


def test_a_copy_says_what_was_turned_and_replaces_no_file(player):
    player.parts.rule_change.turn("friction", 0.3)
    player.parts.rule_change.turn("water.pour", 0.2)
    player.settle()
    player.parts.rule_files.copy()
    player.settle()
    path = folder_of("rules") / "my-water-and-oil.toml"
    assert str(path) in player.parts.notices.text and player.session.rule.definition.paths[0] == path
    made, text = load_rule(path), path.read_bytes()
    assert made.chances["friction"] == 0.3 and made.number("water.pour") == 0.2
    assert made.definition.own_numbers["water.pour"] == 0.2 and not made.definition.turned
    other = copy_rule(load_rule("water-and-oil"))
    assert other != path and path.read_bytes() == text and other.parent == path.parent


def test_a_copied_rule_stands_beside_the_shipped_ones_and_is_played_as_it_is_saved(player):
    path = copy_rule(load_rule("water-and-oil"))
    look_again(player)
    assert f"Yours: {path.stem}" in player.parts.rule_files.labels and "Alchemy" in player.parts.rule_files.labels
    player.parts.rule_files.choose(f"Yours: {path.stem}")
    player.settle()
    change(path, "value = 0.9,", "value = 0.5,")
    look_again(player)
    assert player.session.rule.chances["flow"] == 0.5


def test_reset_gives_back_all_that_the_file_says(player):
    player.parts.rule_change.turn("friction", 0.3)
    player.parts.rule_change.turn("oil.pour", 0.9)
    player.settle()
    assert player.parts.rule_files.is_turned
    player.parts.rule_files.reset()
    player.settle()
    assert player.session.rule == load_rule("water-and-oil") and not player.parts.rule_files.is_turned


def test_another_rule_takes_what_it_has_of_the_world_and_undo_brings_all_back(player):
    digest, sand = player.world.digest(), player.world.where("sand").sum()
    player.parts.rule_files.choose("Sand")
    player.settle()
    assert player.world.codes.is_sand and player.world.where("sand").sum() == sand > 0
    player.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    assert player.world.digest() == digest


def test_a_rule_that_is_chosen_says_what_it_is_about(player):
    for title, name in (("Alchemy", "alchemy"), ("Sand", "sand")):
        player.parts.rule_files.choose(title)
        player.settle()
        assert player.parts.notices.text == load_rule(name).definition.notice != ""


def test_a_copy_takes_along_what_the_rule_includes_and_replaces_no_file(player, tmp_path):
    (tmp_path / "flowing.toml").write_text(asset("rules", "motion.toml").read_text("utf-8") + "\n# mine\n", "utf-8")
    player.drop(own_file(tmp_path, 'include = ["motion"]', 'include = ["flowing"]'))
    player.parts.rule_files.copy()
    player.settle()
    folder = folder_of("rules")
    assert sorted(path.name for path in folder.iterdir()) == ["flowing.toml", "my-pond.toml"]
    assert player.session.rule.definition.paths == (folder / "my-pond.toml", folder / "flowing.toml")
    (folder / "flowing.toml").write_text("# another\n", "utf-8")
    with pytest.raises(FileError, match=r"flowing.toml: include: found another file of that name"):
        copy_rule(player.session.rule)
    assert (folder / "flowing.toml").read_text("utf-8") == "# another\n"


LIFT = """
[materials]
air = { letter = ".", class = "empty", colour = "#000000" }
sand = { letter = "o", class = "powder", density = 5, colour = "#e6aa50" }
wall = { letter = "#", class = "solid", colour = "#78828c" }

[[event]]
name = "rise"
chance = 0.5
picture = '''
.    o
o -> .
'''

[[event]]
name = "vanish"
chance = 0.01
picture = "o -> ."
"""


def test_a_rule_of_sand_and_walls_alone_need_not_be_the_papers(player, tmp_path):
    (tmp_path / "lift.toml").write_text(LIFT, "utf-8")
    player.drop(tmp_path / "lift.toml")
    grains = player.world.grains
    player.session.paused = False
    for key in (pygame.K_f, pygame.K_r, pygame.K_q, pygame.K_e, pygame.K_h, pygame.K_l):
        player.key(key)
        player.wait(40)  # the glass has turned
    assert player.session.rule.definition.name == "lift" and player.world.grains < grains
    assert player.session.account.balanced(player.world)
    player.parts.close()
