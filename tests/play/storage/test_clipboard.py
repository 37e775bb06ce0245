"""The clipboard: pictures go there and come from there, and a system without one costs a line and nothing else."""

import io
import shutil
import subprocess

import numpy as np
import pygame
import pytest
from PIL import Image, ImageGrab

from game.play.storage import clipboard
from game.world.sand.stamp import cut_out

CTRL_SHIFT = pygame.KMOD_LCTRL | pygame.KMOD_LSHIFT


@pytest.fixture
def still(player):
    player.hold_time()
    return player


@pytest.fixture
def board(monkeypatch):
    """Return a list in which the pictures are that were put on a clipboard in memory."""
    pictures = []

    def run(command, stdin, **how):
        pictures.append(Image.open(io.BytesIO(stdin.read())))

    monkeypatch.setattr(shutil, "which", lambda program: program)
    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(ImageGrab, "grabclipboard", lambda: pictures[-1] if pictures else None)
    return pictures


def test_a_picture_of_the_sand_goes_to_the_clipboard_and_comes_back_as_sand(still, board):
    still.drag(still.pixel(30, 20), still.pixel(80, 40))
    sand = still.world.sand
    still.unfold("Recording and past")
    still.click(still.parts_of("Copy the picture")[0].center)
    still.settle()
    still.key(pygame.K_c, mod=CTRL_SHIFT)
    still.settle()
    assert len(board) == 2
    assert board[0].size[0] % 120 == 0 and "clipboard" in still.parts.notices.text
    board.append(Image.fromarray(sand * np.uint8(255)))
    still.key(pygame.K_v, mod=CTRL_SHIFT)
    still.settle()
    assert still.parts.photo_import.shown
    still.key(pygame.K_RETURN)
    still.frame()
    stamp = still.parts.brush.selection.copied.stamp
    assert still.parts.brush.tool == "stamp" and (stamp.cells == 1).sum() == sand.sum()
    still.key(pygame.K_c)
    still.click(still.pixel(60, 45))
    assert (cut_out(still.world, (0, 0, 120, 90)).cells == 1).sum() == sand.sum()
    assert still.session.account.balanced(still.world)


def test_a_picture_is_pasted_by_the_mouse_alone(still, board):
    board.append(Image.new("RGB", (20, 10), "white"))
    still.click(still.parts_of("Tool")[11].center)
    still.click(still.parts_of("Paste a picture")[0].center)
    still.settle()
    still.frame()
    still.click(still.parts.photo_import.ui.rects["Use"].center)
    still.frame()
    still.click(still.pixel(60, 45))
    assert still.world.grains == 200


def test_an_empty_clipboard_costs_a_line(still, board):
    still.key(pygame.K_v, mod=CTRL_SHIFT)
    still.settle()
    assert still.parts.notices.text.startswith("clipboard: found no picture")


@pytest.mark.parametrize("trouble", [OSError("gone"), subprocess.TimeoutExpired("xclip", 1), None])
def test_a_system_without_a_clipboard_costs_a_line_and_no_sand(still, monkeypatch, trouble):
    def fail(*_, **__):
        raise trouble

    monkeypatch.setattr(shutil, "which", lambda program: program if trouble else None)
    monkeypatch.setattr(subprocess, "run", fail)
    monkeypatch.setattr(ImageGrab, "grabclipboard", lambda: (_ for _ in ()).throw(NotImplementedError("no program")))
    before = still.world.digest()
    for code in (pygame.K_c, pygame.K_v):
        still.parts.notices.say("")
        still.key(code, mod=CTRL_SHIFT)
        still.settle()
        still.wait(2)
    assert still.world.digest() == before and still.parts.running


@pytest.mark.parametrize(
    "platform, wayland, program",
    [
        ("darwin", "", "osascript"),
        ("win32", "", "powershell"),
        ("linux", "wayland-0", "wl-copy"),
        ("linux", "", "xclip"),
    ],
)
def test_each_system_has_its_program(monkeypatch, board, platform, wayland, program):
    commands = []
    monkeypatch.setattr(clipboard.sys, "platform", platform)
    monkeypatch.setenv("WAYLAND_DISPLAY", wayland)
    monkeypatch.setattr(subprocess, "run", lambda command, **how: commands.append(command))
    clipboard.put_picture(b"")
    assert commands[0][0] == program
