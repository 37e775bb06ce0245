"""Files in and out of the window: saved scenes, dropped files, journals, pictures and recordings."""

import re
import sys
import threading
import time
import tracemalloc
import weakref
from pathlib import Path

import numpy as np
import pygame
import pytest
from PIL import Image

from game import load_rule
from game.play.app import App
from game.play.pages import file_shelf
from game.play.storage import open_sessions, recorder
from game.play.storage.files import demos
from game.play.storage.films.film import Film
from game.play.storage.films.film_file import FilmFile, enlarged
from game.play.storage.films.gif import GifEncoder
from game.play.storage.open_sessions import MOST_WAITING
from game.play.window.window import Window
from game.world.files.paths import asset, folder_of, numbered
from game.world.looks.painter import Painter
from game.world.looks.themes import NIGHT
from game.world.looks.view import View
from game.world.sand.world import World
from game.world.scenes.scene import load_scene
from game.world.sessions import journal, timeline
from game.world.sessions.history import UNDO, Entry
from game.world.sessions.journal import Journal
from game.world.sessions.recording import load_replay
from game.world.sessions.snapshots import MEGABYTE
from tests.play.player import Player, words_of
from tests.saved import load_picture, save_replay

DATA = Path(__file__).parents[2] / "data"
CTRL = pygame.KMOD_LCTRL
SHIFT = pygame.KMOD_LSHIFT
UNSPELLED = "caf\udce9.png"  # as Python tells a name of bytes that are no letters in UTF-8
on_linux = pytest.mark.skipif(sys.platform != "linux", reason="elsewhere no file can have such a name")


def save(player):
    player.key(pygame.K_s, mod=CTRL)
    if player.parts.name_card.shown:
        player.key(pygame.K_RETURN)
    player.settle()


def the_file(kind):
    (path,) = folder_of(kind).iterdir()
    return path


def as_new(world):
    """Return the digest of a world's cells as a scene starts with them."""
    return World.from_cells(world.sand, world.walls, world.seed).digest()


# --- scenes ---


def test_what_is_saved_is_what_is_opened(glass):
    glass.wait(60)
    glass.hold_time()
    rule, sand = glass.session.rule, as_new(glass.world)
    save(glass)
    assert str(the_file("scenes")) in glass.parts.notices.text
    glass.key(pygame.K_c)
    glass.key(pygame.K_o, mod=CTRL)
    glass.settle()
    glass.key(pygame.K_RETURN)
    glass.settle()
    assert as_new(glass.world) == sand and glass.session.rule == rule and not glass.parts.gallery.shown


def test_opening_a_scene_can_be_taken_back(glass):
    glass.hold_time()
    save(glass)
    glass.key(pygame.K_c)
    glass.drop(the_file("scenes"))
    assert glass.world.grains
    glass.key(pygame.K_z, mod=CTRL)
    assert glass.world.grains == 0


def test_saving_twice_keeps_both(player):
    save(player)
    save(player)
    assert len(list(folder_of("scenes").iterdir())) == 2


def test_a_photo_beside_the_saved_scenes_is_listed_upright_and_opened(player):
    held = Image.Exif()
    held[0x0112] = 6  # turned by a quarter
    folder_of("scenes").mkdir(parents=True)
    Image.fromarray(np.full((30, 60, 3), 200, np.uint8)).save(folder_of("scenes") / "Beach.JPG", exif=held)
    player.key(pygame.K_o, mod=CTRL)
    player.settle()
    player.wait(1)
    wide, tall = player.parts.gallery.shelf.picture(0).get_size()
    assert tall == pytest.approx(2 * wide, abs=2)
    player.key(pygame.K_RETURN)
    player.settle()
    assert player.parts.photo_import.shown


def test_del_puts_a_saved_scene_away_where_it_is_not_lost(player):
    for _ in range(2):
        save(player)
    player.key(pygame.K_o, mod=CTRL)
    player.settle()
    shelf = player.parts.gallery.shelf
    first, second = shelf.paths
    for gone in (first, second):
        data = gone.read_bytes()
        player.key(pygame.K_DELETE)
        kept = folder_of("scenes") / file_shelf.AWAY / gone.name
        assert not gone.exists() and kept.read_bytes() == data and str(kept) in player.parts.notices.text
    player.key(pygame.K_DELETE)
    assert len(shelf) == 0 and player.parts.gallery.shown
    player.wait(2)
    player.key(pygame.K_F2)
    player.key(pygame.K_DELETE)
    assert len(player.parts.gallery.shelf) > 10


def test_the_list_of_saved_scenes_is_walked_by_keys_and_clicked(player):
    player.hold_time()
    grains = []
    for x in (20, 60, 100):
        player.click(player.pixel(x, 40))
        grains.append(player.world.grains)
        save(player)
        time.sleep(0.01)
    gallery = player.parts.gallery
    player.key(pygame.K_o, mod=CTRL)
    player.settle()
    assert len(gallery.shelf) == 3 and all(gallery.shelf.picture(number) for number in range(3))
    player.key(pygame.K_END)
    assert gallery.chosen == 2
    player.key(pygame.K_ESCAPE)
    assert not gallery.shown and player.parts.running
    player.key(pygame.K_o, mod=CTRL)
    player.click(gallery.tile(1).center)
    player.settle()
    assert player.world.grains == grains[1]


def test_a_single_saved_scene_is_shown_no_larger_than_six(player):
    sizes = []
    for number in range(6):
        save(player)
        player.key(pygame.K_o, mod=CTRL)
        if number in (0, 5):
            sizes.append([player.parts.gallery.tile(each).size for each in range(number + 1)])
        player.key(pygame.K_ESCAPE)
    one, six = sizes
    assert len(one) == 1 and set(six) == set(one)


def test_of_many_saved_scenes_only_the_pictures_seen_last_are_kept(player, monkeypatch):
    monkeypatch.setattr(file_shelf, "KEPT", 5)
    kept, read = weakref.WeakSet(), pygame.image.frombytes
    monkeypatch.setattr(pygame.image, "frombytes", lambda *told: (surface := read(*told), kept.add(surface))[0])
    save(player)
    first = next(folder_of("scenes").iterdir())
    for number in range(120):
        first.with_name(f"copy {number}.png").write_bytes(first.read_bytes())
    player.hold_time()
    player.key(pygame.K_o, mod=CTRL)
    gallery = player.parts.gallery
    for key in (pygame.K_HOME, *[pygame.K_PAGEDOWN] * 20, pygame.K_END, *[pygame.K_PAGEUP] * 5):
        player.key(key)
        for _ in range(5):
            player.settle()
        in_sight = [number for number in range(len(gallery.shelf)) if gallery.tile(number)]
        assert all(gallery.shelf.picture(number) for number in in_sight)
        assert 0 < len(kept) <= len(in_sight) + file_shelf.BATCH + 5 < 60


def test_a_damaged_saved_scene_is_shown_as_such_and_costs_a_line(player):
    folder_of("scenes").mkdir(parents=True)
    (folder_of("scenes") / "torn.png").write_bytes(b"\x89PNG\r\n\x1a\n torn")
    player.hold_time()
    before = player.world.digest()
    player.key(pygame.K_o, mod=CTRL)
    player.settle()
    player.key(pygame.K_RETURN)
    player.settle()
    assert "unreadable" in player.parts.notices.text
    assert player.world.digest() == before


def test_a_folder_that_cannot_be_written_costs_a_line_and_no_sand(player, own_folder):
    own_folder.write_text("a file where the folder should be")
    player.click(player.pixel(60, 40))
    grains = player.world.grains
    save(player)
    assert "cannot make the folder" in player.parts.notices.text and player.world.grains == grains


@on_linux
def test_a_file_whose_name_spells_no_letters_is_listed(player):
    save(player)
    the_file("scenes").rename(folder_of("scenes") / UNSPELLED)
    player.key(pygame.K_o, mod=CTRL)
    player.settle()
    player.wait(1)
    assert player.parts.gallery.shelf.picture(0)


# --- what is dropped ---


def test_a_dropped_scene_file_is_played(player, tmp_path):
    path = tmp_path / "two.toml"
    path.write_text('title = "Two"\ncells = """\no.o\n###\n"""\n')
    player.drop(path)
    assert player.world.shape == (2, 3) and player.world.grains == 2


def test_a_scene_is_said_to_be_opened_by_its_title(player):
    player.parts.files.open_shipped("winter-pond")
    player.settle()
    assert player.parts.notices.text == "Opened Winter pond. Ctrl+Z takes you back."


def test_a_scene_file_that_was_edited_is_shown_by_its_new_title(player, tmp_path):
    path = tmp_path / "own.toml"
    for title in ("First", "Second"):
        path.write_text(f'title = "{title}"\nwidth = 20\nheight = 20\n')
        player.drop(path)
        player.settle()
        assert player.parts.sessions.title_of("own") == player.session.scene.title == title


def test_a_dropped_replay_is_played_and_left_again(player, glass, tmp_path):
    glass.wait(30)
    glass.key(pygame.K_c)
    glass.wait(10)
    save_replay(tmp_path / "clear.sandglass", glass.session)
    player.click(player.pixel(60, 40))
    player.hold_time()
    sand = player.world.digest()
    player.drop(tmp_path / "clear.sandglass")
    assert player.session.scene.name == "hourglass" and player.session.now == 0
    player.session.seek(glass.session.now)
    assert player.world.digest() == glass.world.digest()
    player.session.seek(0)
    player.key(pygame.K_z, mod=CTRL)
    assert player.world.digest() == sand


def test_every_shipped_replay_can_be_played_from_the_panel_and_left_by_the_way_it_came(player):
    player.click(player.pixel(60, 40))
    player.click(player.control("Recording and past"))
    sessions = [player.session]
    for number, path in enumerate(sorted(asset("replays").glob("*.sandglass"))):
        player.click(player.control("Demo"))
        player.click(player.parts.panel.ui.parts("Demo")[number + 1].center)
        player.settle()
        assert path.stem in player.parts.notices.text and player.session.reached > 0
        player.frame()
        sessions.append(player.session)
    for before in sessions[-2::-1]:
        assert player.parts.sessions.can_leave
        player.click(player.control("Back to my sand"))
        assert player.session is before
    assert not player.parts.sessions.can_leave


def test_many_replays_take_no_more_memory_and_the_players_own_sand_stays_behind_them(player):
    player.click(player.pixel(60, 40))
    player.hold_time()
    own, sand = player.session, player.world.digest()
    for _ in range(2 * MOST_WAITING):
        player.drop(asset("replays", "rooms.sandglass"))
        player.wait(20)
    former = list(player.parts.sessions.waiting)
    assert former[0] is own and len(former) == MOST_WAITING
    assert all(session.timeline.snapshots.bytes <= MEGABYTE for session in former)
    memory = player.session.timeline.memory_mb
    while player.parts.sessions.leave():
        player.frame()
    assert player.session is own and player.world.digest() == sand and own.timeline.memory_mb == memory


def test_a_session_that_waits_gives_its_past_back_and_computes_it_anew(glass, monkeypatch):
    monkeypatch.setattr(timeline, "SPACING_NS", 1)
    monkeypatch.setattr(timeline, "SHARE", 0)
    own = glass.session
    glass.click(glass.pixel(60, 40))
    while own.timeline.snapshots.bytes <= 2 * MEGABYTE:
        own.timeline.run(50)
    end, sand = own.now, own.world.digest()
    glass.parts.files.play_demo(demos()[0])
    glass.settle()
    assert glass.session is not own and own.timeline.snapshots.bytes <= MEGABYTE
    glass.parts.sessions.leave()
    own.seek(1)
    own.seek(end)
    assert own.world.digest() == sand


def test_a_photo_is_looked_at_before_it_is_taken(player, tmp_path):
    grey = np.tile(np.linspace(0, 255, 64).astype(np.uint8), (48, 1))
    Image.fromarray(grey).convert("RGB").save(tmp_path / "grey.png")
    player.drop(tmp_path / "grey.png")
    assert player.parts.photo_import.shown and player.session.scene.name == "blank"
    player.frame()
    track = player.parts.photo_import.ui.parts("Threshold")[0]
    player.click((track.left + track.width * 3 // 4, track.centery))
    player.key(pygame.K_RETURN)
    sand = player.session.scene.sand
    assert not player.parts.photo_import.shown and player.session.scene.shape == (48, 64)
    assert 0 < sand.sum() < load_picture(tmp_path / "grey.png").scene.sand.sum()


def test_a_photo_becomes_materials_of_the_rule_in_play(tmp_path):
    player = Player("kitchen")
    Image.fromarray(np.tile(np.arange(64, dtype=np.uint8) * 4, (48, 1))).save(tmp_path / "grey.png")
    player.drop(tmp_path / "grey.png")
    player.frame()
    card = player.parts.photo_import.ui
    player.click(card.rects["Bright is"].center)
    player.click(card.parts("Bright is")[9].center)
    player.click(card.rects["Use"].center)
    player.settle()
    world = player.world
    assert world.shape == (48, 64) and world.codes == load_rule("alchemy").codes
    row = [world.codes.names[code] for code in world.materials[7]]
    assert row[0] == "air" and row[30] == "wall" and row[63] == "brine"


def test_a_photo_put_in_place_of_many_cells_comes_after_a_picture_that_says_so(player, tmp_path, monkeypatch):
    Image.fromarray(np.tile(np.arange(64, dtype=np.uint8) * 4, (48, 1))).save(tmp_path / "grey.png")
    player.drop(tmp_path / "grey.png")
    monkeypatch.setattr(open_sessions, "LARGE", 100)
    with player.reading() as drawn:
        player.press(pygame.K_RETURN)
    assert player.session.scene.name == "blank" and any("Opening grey.png" in text for _, text, _ in words_of(drawn))
    player.frame()
    assert player.session.scene.shape == (48, 64) and not player.parts.photo_import.shown


def test_a_lossy_copy_of_a_saved_scene_is_opened_with_the_number_of_guessed_cells(player):
    player.drop(DATA / "saved-rainbow-95.jpg")
    assert "found 936 of 43,200 cells in no material's colour: the nearest was guessed" in player.words()


def test_a_photo_can_be_left(player, tmp_path):
    Image.fromarray(np.tile(np.arange(64, dtype=np.uint8) * 4, (48, 1))).save(tmp_path / "grey.png")
    player.drop(tmp_path / "grey.png")
    player.key(pygame.K_ESCAPE)
    assert not player.parts.photo_import.shown and player.session.scene.name == "blank" and player.parts.running


@on_linux
@pytest.mark.parametrize("length", [1, 240])
def test_what_was_opened_from_a_file_of_any_name_is_saved_and_gone_on_with(player, tmp_path, length):
    photo = np.tile(np.linspace(0, 255, 64).astype(np.uint8), (48, 1))
    Image.fromarray(photo).save(tmp_path / "grey.png")
    path = (tmp_path / "grey.png").rename(tmp_path / (length * "g" + UNSPELLED))
    player.parts.crash_recovery.start()
    player.hold_time()
    player.drop(path)
    player.wait(1)
    player.key(pygame.K_RETURN)
    player.frame()
    save(player)
    sand = player.session.scene.sand
    assert (load_picture(the_file("scenes")).scene.sand == player.world.sand).all()
    crash(player)
    recording = Journal.resume(next(journal.unfinished()))[1]
    assert recording.problem is None and (recording.entries[-1].what.scene.sand == sand).all()


@pytest.fixture
def late(glass, monkeypatch):
    """Return a player whose sand is on its way to another moment, and stays there."""
    glass.wait(30)
    monkeypatch.setattr(type(glass.session.timeline), "catch_up", lambda *_: None)
    glass.session.timeline.goal = 1
    return glass


def test_a_file_is_not_said_to_be_opened_where_the_sand_could_not_give_way(late, tmp_path):
    before = late.session.scene
    (tmp_path / "two.toml").write_text('cells = """\no.o\n###\n"""\n')
    late.drop(tmp_path / "two.toml")
    assert "two was not opened" in late.parts.notices.text and late.session.scene is before


def test_a_photo_waits_until_the_sand_can_give_way_to_it(late, tmp_path):
    Image.fromarray(np.tile(np.arange(64, dtype=np.uint8) * 4, (48, 1))).save(tmp_path / "grey.png")
    late.drop(tmp_path / "grey.png")
    late.key(pygame.K_RETURN)
    assert late.parts.photo_import.shown
    late.session.timeline.goal = None
    late.key(pygame.K_RETURN)
    assert not late.parts.photo_import.shown and late.session.scene.shape == (48, 64)


@pytest.mark.parametrize("name", ("bad.toml", "bad.sandglass", "bad.png", "bad.txt", "gone.toml", "gone.jpg", ""))
def test_a_bad_file_costs_a_line_and_no_sand(player, tmp_path, name):
    if name.startswith("bad"):
        (tmp_path / name).write_bytes(b"\x00 nothing of use \xff")
    player.hold_time()
    sand = player.world.digest()
    player.drop(tmp_path / name)
    assert player.parts.notices.text.count("\n") == 0 and str(tmp_path) in player.parts.notices.text
    assert player.world.digest() == sand


# --- journals ---


def crash(player):
    """End the session's journal as a crash does."""
    player.session.journal.abandon()
    player.session.journal = None


def test_a_session_cut_off_is_offered_and_goes_on_where_it_was(player):
    player.parts.crash_recovery.start()
    player.drag(player.pixel(20, 20), player.pixel(60, 20))
    player.wait(10)
    player.key(pygame.K_f)
    at, cells = player.session.now, as_new(player.world)
    crash(player)
    player = Player()
    player.parts.crash_recovery.start()
    player.settle()
    assert player.parts.dialog.shown
    player.key(pygame.K_RETURN)
    player.settle()
    assert player.session.now == at and as_new(player.world) == cells and player.session.journal


@pytest.mark.parametrize(("key", "offered_again"), ((pygame.K_ESCAPE, True), (pygame.K_DELETE, False)))
def test_a_session_cut_off_can_wait_or_be_let_go(player, key, offered_again):
    player.parts.crash_recovery.start()
    player.click(player.pixel(20, 20))
    crash(player)
    player = Player()
    player.parts.crash_recovery.start()
    player.settle()
    player.key(key)
    player.settle()
    assert not player.parts.dialog.shown and player.world.grains == 0 and player.parts.running
    player.parts.close()
    assert (next(journal.unfinished(), None) is not None) == offered_again


def test_the_question_does_not_keep_anyone_from_playing(player):
    begun = Journal.begin(player.session.scene, 0)
    begun.note(Entry(0, UNDO))
    begun.abandon()
    player.parts.crash_recovery.start()
    player.settle()
    at = player.session.now
    player.drag(player.pixel(20, 60), player.pixel(60, 60))
    assert player.parts.dialog.shown and player.world.grains and player.session.now > at
    ui = player.parts.dialog.ui
    player.click(ui.rects["Later"].center)
    assert not player.parts.dialog.shown


def test_a_journal_that_cannot_be_kept_costs_a_line_and_no_sand(player, own_folder):
    own_folder.write_text("a file where the folder should be")
    player.parts.crash_recovery.start()
    player.click(player.pixel(20, 20))
    player.settle()
    assert "cannot keep a journal" in player.parts.notices.text and player.world.grains


def test_a_journal_that_breaks_off_costs_a_line_and_no_sand(player, monkeypatch):
    player.parts.crash_recovery.start()
    player.settle()

    def full(handle, line):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(journal.os, "write", full)
        player.click(player.pixel(20, 20))
        player.frame()
    assert "no space left on device" in player.parts.notices.text and player.world.grains
    player.wait(5)
    assert player.session.journal is None


def test_the_journal_of_a_paused_window_does_not_grow(player, monkeypatch):
    monkeypatch.setattr(journal, "WAIT_S", 0.0)
    player.parts.crash_recovery.start()
    player.hold_time()
    player.wait(1)
    path = player.session.journal.path
    size = path.stat().st_size
    player.wait(30)
    assert path.stat().st_size == size
    player.session.paused = False
    player.wait(30)
    assert path.stat().st_size > size


def pass_time(player, seconds):
    """Let so many seconds pass in a few long frames."""
    for _ in range(4 * seconds):
        player.frame(elapsed_ns=250_000_000)


def test_a_journal_comes_back_with_all_that_was_done_when_there_is_room_again(player, monkeypatch):
    player.parts.crash_recovery.start()
    player.settle()
    player.click(player.pixel(20, 20))

    def full(*_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(journal.os, "write", full)
        player.click(player.pixel(50, 30))
        pass_time(player, 12)
        lost = player.session.lost_journal
        assert player.session.journal is None and list(folder_of("journals").iterdir()) == [lost]
    player.click(player.pixel(80, 40))
    pass_time(player, 12)
    assert player.session.journal is not None and not lost.exists()
    path, digest = player.session.journal.path, player.world.digest()
    player.parts.close()
    assert load_replay(path).digest == digest and len(load_replay(path).entries) >= 3


@pytest.mark.parametrize("close", [(pygame.QUIT, {}), (pygame.KEYDOWN, {"key": pygame.K_q, "mod": pygame.KMOD_LCTRL})])
def test_a_closed_window_can_be_gone_on_with_where_it_was(player, close):
    kind, how = close
    player.parts.crash_recovery.start()
    player.click(player.pixel(20, 20))
    player.wait(7)
    at, cells = player.session.now, as_new(player.world)
    player.frame(pygame.event.Event(kind, unicode="", **how), elapsed_ns=0)
    player.parts.close()
    assert not player.parts.running
    again = Player()
    again.parts.crash_recovery.start()
    again.settle()
    again.key(pygame.K_RETURN)
    again.settle()
    assert again.session.now == at and as_new(again.world) == cells


def test_a_window_in_which_nothing_was_done_leaves_nothing_to_go_on_with(player):
    player.parts.crash_recovery.start()
    player.wait(5)
    player.parts.close()
    assert journal.left_over() is None


def test_the_rule_of_the_start_is_no_act_of_the_player():
    app = App(Window((900, 700)), load_scene("hourglass"), p=0.3)
    app.parts.crash_recovery.start()
    app.parts.close()
    assert journal.left_over() is None


def test_what_is_discarded_brings_up_no_older_session(player):
    for _ in range(2):
        player = Player()
        player.parts.crash_recovery.start()
        player.click(player.pixel(20, 20))
        player.parts.close()
    player = Player()
    player.parts.crash_recovery.start()
    player.settle()
    player.key(pygame.K_DELETE)
    player.settle()
    assert journal.left_over() is None


def test_a_file_that_is_read_when_the_window_closes_is_not_played_any_more(player):
    player.parts.crash_recovery.start()
    player.settle()
    before = player.session
    path = asset("replays", f"{demos()[0]}.sandglass")
    player.frame(pygame.event.Event(pygame.DROPFILE, file=str(path)), pygame.event.Event(pygame.QUIT))
    player.parts.close()
    assert player.session is before and next(journal.unfinished(), None) is None


# --- pictures and recordings ---


def test_a_picture_of_the_window_is_as_large_as_the_window(player):
    player.key(pygame.K_F12)
    player.settle()
    with Image.open(the_file("pictures")) as image:
        assert image.size == player.parts.window.size and len(image.convert("RGB").getcolors(1 << 20)) > 10


def test_a_picture_of_the_sand_has_cells_of_whole_pixels(glass):
    glass.hold_time()
    glass.key(pygame.K_F12, mod=SHIFT)
    glass.settle()
    height, width = glass.world.shape
    with Image.open(the_file("pictures")) as image:
        scale = image.width // width
        assert image.size == (width * scale, height * scale)
        assert image.width < 4096


@pytest.mark.parametrize("name", ["hourglass", "marbles"])
def test_a_picture_of_the_sand_is_the_same_however_few_rows_are_drawn_at_a_time(monkeypatch, name):
    world = load_scene(name).world(1)
    how = world, 3, NIGHT, "glass"
    whole = np.asarray(recorder.image_of_sand(*how))
    pixels = np.zeros(whole.shape[:2], np.uint32)
    Painter(View(world.shape, 0, 0, *pixels.shape[::-1]), *how[2:]).draw(world, pixels)
    assert (whole == np.stack([pixels >> shift & 255 for shift in (16, 8, 0)], axis=-1)).all()
    monkeypatch.setattr(recorder, "BAND", 7 * pixels.shape[1])
    assert (np.asarray(recorder.image_of_sand(*how)) == whole).all()


def test_a_picture_of_the_sand_takes_little_more_memory_than_itself():
    side = 4096
    world = World.from_cells(np.zeros((side, side), bool), np.zeros((side, side), bool))
    tracemalloc.start()
    recorder.image_of_sand(world, 1, NIGHT, "stone")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2 * side * side


def test_a_recording_shows_what_followed(glass):
    glass.key(pygame.K_g)
    glass.wait(60)
    assert "G stops it" in glass.parts.recorder.said
    glass.key(pygame.K_g)
    glass.settle()
    with Image.open(the_file("pictures")) as image:
        assert image.width % glass.world.shape[1] == 0 and 20 <= image.n_frames <= 30
        total_ms = 0
        for number in range(image.n_frames):
            image.seek(number)
            total_ms += image.info["duration"]
        assert total_ms == pytest.approx(1040, abs=80)


def test_a_recording_and_the_past_recorded_at_one_moment_are_two_files(glass):
    glass.wait(10)
    for mod in (0, SHIFT, 0):
        glass.key(pygame.K_g, mod=mod)
    glass.settle()
    assert len(list(folder_of("pictures").iterdir())) == 2


def test_the_last_frame_of_the_past_recorded_is_the_sand_now(glass):
    glass.wait(30)
    glass.drag(glass.pixel(30, 40), glass.pixel(60, 60))
    glass.wait(30)
    glass.hold_time()
    glass.key(pygame.K_g, mod=SHIFT)
    glass.settle()
    scene = glass.session.scene
    film = Film(scene.shape, scene.cell, glass.parts.display.colours, scene.made_of)
    wanted = np.frombuffer(film.colours, np.uint8).reshape(-1, 3)[enlarged(film.frame(glass.world), film.zoom)]
    with Image.open(the_file("pictures")) as image:
        assert image.n_frames > 20
        image.seek(image.n_frames - 1)
        assert (np.asarray(image.convert("RGB")) == wanted).all()


def test_no_frame_waits_for_the_writer(glass, monkeypatch):
    free, written = threading.Event(), []
    monkeypatch.setattr(recorder.FilmFile, "add", lambda self, pixels, ms: written.append(free.wait(60)))
    glass.key(pygame.K_g)
    for _ in range(40):
        glass.frame(elapsed_ns=40_000_000)
    assert not written
    free.set()
    glass.parts.recorder.stop()
    glass.settle()
    assert len(written) > 30 and all(written)


def test_a_recording_says_how_large_it_is(glass):
    glass.key(pygame.K_g)
    glass.wait(30)
    glass.parts.recorder.toggle()
    glass.settle()
    path = the_file("pictures")
    assert recorder.spelled(path.stat().st_size) in glass.parts.notices.text
    glass.key(pygame.K_g)
    sizes = []
    for _ in range(30):
        glass.wait(3)
        pygame.time.wait(1)
        sizes += [int(size) for size in re.findall(r"(\d+) kB", glass.parts.recorder.said)]
    assert sizes == sorted(sizes) and sizes[-1] > sizes[0]


def test_a_recording_that_the_disk_cannot_follow_ends_with_all_its_frames(glass, monkeypatch):
    free, written = threading.Event(), []
    monkeypatch.setattr(recorder, "MOST_WAITING", 20)
    monkeypatch.setattr(recorder.FilmFile, "add", lambda self, pixels, ms: written.append(free.wait(60)))
    glass.key(pygame.K_g)
    for _ in range(40):
        glass.frame(elapsed_ns=40_000_000)
    assert not glass.parts.recorder.going_on and "too slow" in glass.parts.notices.text
    free.set()
    glass.settle()
    assert len(written) == 21


def test_a_recording_that_cannot_be_written_costs_a_line_and_keeps_no_window_open(glass, own_folder):
    own_folder.write_text("a file where the folder should be")
    glass.key(pygame.K_g)
    glass.settle()
    glass.wait(150)
    assert "cannot make the folder" in glass.parts.notices.text and not glass.parts.recorder.said
    closing = threading.Thread(target=glass.parts.close, daemon=True)
    closing.start()
    closing.join(10)
    assert not closing.is_alive()


def test_a_recording_ends_by_itself(glass, monkeypatch):
    monkeypatch.setattr(recorder, "LONGEST_S", 1.0)
    glass.key(pygame.K_g)
    glass.wait(90)
    assert not glass.parts.recorder.going_on
    glass.settle()
    assert "Recorded as" in glass.parts.notices.text


def test_a_film_lasts_as_long_as_its_frames_however_short_they_are(tmp_path):
    film = FilmFile(numbered(tmp_path / "film.gif"), GifEncoder(bytes(768)))
    for number in range(60):
        film.add(np.full((4, 4), number, np.uint8), 1000 / 60)
    with Image.open(film.close()) as image:
        frames = [image.seek(number) or image.info["duration"] for number in range(image.n_frames)]
    assert len(frames) == 60 and sum(frames) == pytest.approx(1000, abs=10)


def test_a_still_picture_is_written_once(player):
    player.hold_time()
    player.key(pygame.K_g)
    for _ in range(20):
        player.frame(elapsed_ns=40_000_000)
    player.key(pygame.K_g)
    player.settle()
    with Image.open(the_file("pictures")) as image:
        assert image.n_frames == 1


def test_a_held_key_records_once(player):
    for _ in range(4):
        player.press(pygame.K_g)
    assert player.parts.recorder.going_on


def test_the_pointer_is_heard_in_the_frame_in_which_a_replay_opens(player):
    before = player.session
    player.parts.files.play_demo(demos()[0])
    while player.parts.background.busy:
        player.frame(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=(300, 300), button=1), elapsed_ns=0)
    assert player.session is not before


def test_a_session_whose_journal_had_to_stop_is_offered_with_what_it_holds(player, monkeypatch):
    begun = Journal.begin(player.session.scene, 0)
    begun.note(Entry(0, UNDO))
    with monkeypatch.context() as full:
        full.setattr(journal.os, "write", lambda handle, line: (_ for _ in ()).throw(OSError(28, "full")))
        with pytest.raises(journal.JournalError):
            begun.note(Entry(1, UNDO))
    asked = []
    monkeypatch.setattr(player.parts.dialog, "ask", lambda title, text, answers: asked.append(text))
    player.parts.crash_recovery.start()
    player.settle()
    assert "Acts that it holds: 1; nothing later." in asked[0] and "Nothing in it is lost" not in asked[0]
