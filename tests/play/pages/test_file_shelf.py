"""The player's files in the gallery: named, renamed, deleted, brought back, sorted, and pictured as the window does."""

import os

import numpy as np
import pygame
import pytest

from game.play.view.scene_picture import picture_of
from game.world.files.paths import file_stem, folder_of, save_named
from game.world.looks.themes import NIGHT
from game.world.scenes.picture_file import open_picture
from game.world.sessions.recording import load_replay
from game.world.sessions.session import Session
from tests.play.player import Player
from tests.sweeps import sweep

CTRL, SHIFT = pygame.KMOD_LCTRL, pygame.KMOD_LSHIFT
TILES = {"Saved": 1, "Stamps": 2, "Replays": 3}


def type_in(player, text):
    for sign in text:
        player.key(ord(sign), sign)


def save_as(player, name, mod=CTRL):
    player.key(pygame.K_s, mod=mod)
    type_in(player, name)
    player.key(pygame.K_RETURN)
    player.settle()


def listed(player, title="Saved"):
    """Open a shelf of the gallery with the mouse; return its names."""
    gallery = player.parts.gallery
    if not gallery.shown:
        player.key(pygame.K_F2)
    player.click(gallery.tab(TILES[title]).center)
    player.settle()
    return [path.stem for path in gallery.shelf.paths]


@pytest.fixture
def saved(player):
    """Return a player who has saved three scenes, the oldest first: Castle, anthill, Bridge."""
    player.hold_time()
    for number, name in enumerate(("Castle", "anthill", "Bridge")):
        path = save_named("scenes", name, ".png", b"")
        save_as(player, f"x{number}")
        os.replace(folder_of("scenes") / f"x{number}.png", path)
        os.utime(path, (1e9 + number, 1e9 + number))
        player.parts.files._names.clear()
    return player


def test_a_name_is_asked_for_once_and_is_what_the_scene_is_called_from_then_on(player):
    player.hold_time()
    save_as(player, "My castle")
    player.key(pygame.K_s, mod=CTRL)
    player.settle()
    assert not player.parts.name_card.shown
    names = {path.name for path in folder_of("scenes").iterdir()}
    assert names == {"My castle.png", "My castle 2.png"}
    player.drop(folder_of("scenes") / "My castle.png")
    assert player.session.scene.title == "My castle"
    player.key(pygame.K_s, mod=CTRL)
    player.settle()
    assert (folder_of("scenes") / "My castle 3.png").exists()


def test_what_is_saved_is_the_sand_of_the_moment_of_the_key(player):
    player.click(player.pixel(60, 20))
    grains = player.world.grains
    player.key(pygame.K_s, mod=CTRL)
    player.wait(30)
    player.click(player.pixel(20, 20))
    player.click(player.parts.name_card.ui.rects["Save"].center)
    player.settle()
    (path,) = folder_of("scenes").iterdir()
    scene = open_picture(path).scene
    assert 0 < (scene.cells == 1).sum() <= player.world.grains and scene.cells.size
    assert (scene.cells == 1).sum() >= grains


def test_escape_saves_nothing(player):
    player.key(pygame.K_s, mod=CTRL)
    player.key(pygame.K_ESCAPE)
    player.settle()
    assert not folder_of("scenes").exists() or not list(folder_of("scenes").iterdir())


@pytest.mark.parametrize(
    "name, stem",
    [("a/b\\c:d", "a-b-c-d"), ("..", "sand"), ("con", "con-"), ("LPT1.x", "LPT1.x-"), (" x. ", "x"), ("é ü", "é ü")],
)
def test_a_name_becomes_a_file_that_every_system_has_room_for(name, stem):
    assert file_stem(name) == stem and len(file_stem(99 * "long ")) <= 40


@sweep("by", ["mouse", "keyboard"], keep=["keyboard"])
def test_a_saved_scene_is_renamed_and_that_can_be_taken_back(saved, by):
    def give(words, code, mod=0):
        gallery.action(words)
        saved.key(code, mod=mod) if by == "keyboard" else saved.click(gallery.action(words).center)

    assert listed(saved) == ["Bridge", "anthill", "Castle"]
    gallery = saved.parts.gallery
    saved.key(pygame.K_RIGHT)
    give("Rename", pygame.K_r)
    type_in(saved, "hill of ants")
    saved.key(pygame.K_RETURN) if by == "keyboard" else saved.click(gallery.tile(0).center)
    assert listed(saved) == ["Bridge", "hill of ants", "Castle"] and gallery.shown
    give("Undo", pygame.K_z, CTRL)
    assert listed(saved) == ["Bridge", "anthill", "Castle"]


def test_a_name_that_is_taken_is_told_and_nothing_is_lost(saved):
    listed(saved)
    saved.key(pygame.K_r)
    type_in(saved, "Castle")
    saved.key(pygame.K_RETURN)
    assert "There is a Castle.png already." in saved.words()
    assert sorted(listed(saved)) == ["Bridge", "Castle", "anthill"]
    saved.key(pygame.K_r)
    type_in(saved, "no")
    saved.key(pygame.K_ESCAPE)
    assert sorted(listed(saved)) == ["Bridge", "Castle", "anthill"] and saved.parts.gallery.shown


@sweep("by", ["mouse", "keyboard"], keep=["mouse"])
def test_what_was_deleted_is_brought_back_one_after_the_other(saved, by):
    def give(words, code, mod=0):
        saved.key(code, mod=mod) if by == "keyboard" else saved.click(gallery.action(words).center)

    before, gallery = listed(saved), saved.parts.gallery
    for left in (2, 1, 0):
        give("Delete", pygame.K_DELETE)
        assert len(gallery.shelf) == left
    for left in (1, 2, 3):
        give("Undo", pygame.K_z, CTRL)
        assert len(gallery.shelf) == left
    assert [path.stem for path in gallery.shelf.paths] == before and gallery.action("Undo") is None


@sweep("by", ["mouse", "keyboard"], keep=["mouse"])
def test_files_are_sorted_by_age_or_by_name(saved, by):
    assert listed(saved) == ["Bridge", "anthill", "Castle"]
    gallery = saved.parts.gallery
    saved.key(pygame.K_s) if by == "keyboard" else saved.click(gallery.action("By name").center)
    assert [path.stem for path in gallery.shelf.paths] == ["anthill", "Bridge", "Castle"]
    assert gallery.shelf.name(gallery.chosen) == "Bridge"
    saved.key(pygame.K_s) if by == "keyboard" else saved.click(gallery.action("Newest first").center)
    assert [path.stem for path in gallery.shelf.paths] == ["Bridge", "anthill", "Castle"]


def test_the_picture_of_a_saved_glass_shows_its_wood_and_its_light(glass):
    glass.hold_time()
    save_as(glass, "Mine")
    listed(glass)
    glass.wait(2)
    picture = glass.parts.gallery.shelf.picture(0)
    scene = open_picture(folder_of("scenes") / "Mine.png").scene
    size, data = picture_of(scene, (640, 480), NIGHT)
    painted = pygame.transform.smoothscale(pygame.image.frombytes(data, size, "RGB"), picture.get_size())
    assert (pygame.surfarray.array3d(picture) == pygame.surfarray.array3d(painted)).all()
    assert len(np.unique(pygame.surfarray.array2d(painted))) > 100


@sweep("by", ["mouse", "keyboard"], keep=["keyboard"])
def test_a_session_is_saved_as_a_replay_and_played_from_the_gallery(player, by):
    player.drag(player.pixel(30, 20), player.pixel(80, 30))
    player.wait(20)
    player.key(pygame.K_z, mod=CTRL)
    player.drag(player.pixel(20, 40), player.pixel(90, 50))
    player.wait(5)
    player.hold_time()
    player.frame()
    if by == "keyboard":
        save_as(player, "Two strokes", CTRL | SHIFT)
    else:
        player.unfold("Recording and past")
        player.click(player.parts_of("Save as replay")[0].center)
        player.frame()
        type_in(player, "Two strokes")
        player.click(player.parts.name_card.ui.rects["Save"].center)
        player.settle()
    digest = player.world.digest()
    recording = load_replay(folder_of("replays") / "Two strokes.sandglass")
    told = Session.retold(recording)
    told.seek(recording.end)
    assert recording.problem is None and told.world.digest() == digest == recording.digest
    assert listed(player, "Replays") == ["Two strokes"]
    player.wait(2)
    assert player.parts.gallery.shelf.picture(0)
    player.key(pygame.K_RETURN)
    player.settle()
    assert player.parts.sessions.can_leave and player.session.timeline.history.story() == recording.entries


def test_a_stamp_is_kept_listed_and_taken_in_hand(player):
    player.hold_time()
    player.drag(player.pixel(30, 20), player.pixel(50, 25))
    player.key(pygame.K_s, mod=SHIFT)
    player.drag(player.pixel(20, 10), player.pixel(60, 40))
    stamped = player.world.grains
    player.key(pygame.K_k, mod=CTRL)
    type_in(player, "Lump")
    player.key(pygame.K_RETURN)
    player.settle()
    assert (folder_of("stamps") / "Lump.png").exists()
    player.key(pygame.K_F3)
    player.settle()
    player.wait(1)
    assert player.parts.gallery.shelf.picture(0)
    player.click(player.parts.gallery.tile(0).center)
    player.settle()
    player.click(player.pixel(80, 70))
    assert player.world.grains == 2 * stamped and player.parts.brush.tool == "stamp"


def test_a_stamp_of_a_glass_is_kept_as_glass(glass):
    glass.key(pygame.K_a, mod=CTRL)
    glass.key(pygame.K_k, mod=CTRL)
    glass.key(pygame.K_RETURN)
    glass.settle()
    scene = open_picture(folder_of("stamps") / "Stamp.png").scene
    assert scene.made_of == "glass" and scene.shape == glass.world.shape


@sweep("size", [(640, 480), (1280, 720), (3840, 2160)], keep=[(640, 480)])
def test_nothing_in_the_head_of_a_shelf_lies_over_another_or_is_cut(size):
    player = Player("blank", size)
    player.hold_time()
    save_as(player, "One")
    for number in (1, 2, 3):
        listed(player, next(title for title, place in TILES.items() if place == number))
        player.key(pygame.K_DELETE)
        player.key(pygame.K_z, mod=CTRL)
        gallery, theme = player.parts.gallery, player.parts.display.theme
        rects = [gallery.tab(each) for each in range(4)]
        rects += [gallery.action(each.words) for each in gallery.actions]
        assert all(rect.right <= size[0] for rect in rects)
        assert all(not one.colliderect(other) for one in rects for other in rects if one is not other)
        head = [each for each in player.written() if each[0].y < theme.px(40)]
        assert all(theme.width(text, kind) <= rect.width for rect, text, kind in head)
    pygame.display.quit()
