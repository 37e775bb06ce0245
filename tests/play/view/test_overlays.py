"""What lies over the sand: soft at its edges however often it is drawn, and gone without a trace."""

from itertools import product

import pygame
import pytest

from game.play.view.dialog import Answer
from tests.play.player import Player
from tests.sweeps import sweep


def question(parts, _now_s):
    parts.dialog.ask(
        "A title", "And words.", [Answer("Yes", None, pygame.K_y, "Y"), Answer("No", None, pygame.K_n, "N")]
    )


def glow(parts, now_s):
    parts.settings["reduced_motion"] = True  # so that it stands still
    parts.glow.start(now_s)


def two_at_once(parts, now_s):
    glow(parts, now_s)
    question(parts, now_s)


def sand_of(player):
    """Return the pixels of the sand's part of the window."""
    area = player.parts.display.layout.sand
    return pygame.surfarray.array2d(player.parts.window.surface)[: area.width, : area.height]


def check(player, show):
    """Draw many frames of `show`, first while sand moves, then while only an outline passes; then draw it all anew."""
    player.hold_time()
    show(player.parts, player.now_s)
    for number in range(60):
        player.session.paused = number > 20
        player.pointer = 20 + 9 * number, 300 - 4 * number
        player.frame()
    player.pointer = None
    player.wait(2)
    assert any(each.shown for each in player.parts.overlays)
    often = sand_of(player)
    player.parts.display.sand_view.refresh()
    player.wait(0)
    assert (often == sand_of(player)).all()


@pytest.mark.parametrize("show", [question, glow, two_at_once])
def test_what_is_drawn_often_looks_as_if_it_were_drawn_once(glass, show):
    try:
        check(glass, show)
    finally:
        glass.parts.close()


@pytest.mark.parametrize("show", [question])
def test_so_it_does_over_three_worlds(show):
    player = Player("hourglass", (1100, 700))
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    player.wait(1)
    check(player, show)
    player.parts.close()
    pygame.display.quit()


def test_a_still_picture_with_something_over_it_is_not_drawn_again(glass):
    glass.hold_time()
    question(glass.parts, glass.now_s)
    glass.wait(60)
    assert glass.parts.dialog.shown and not any(glass.frame() for _ in range(10))


def everything(player):
    """Show a message, legend, plots and figures at once."""
    player.key(pygame.K_h, "h")
    player.key(pygame.K_l, "l")
    player.parts.stats_card.toggle()
    player.wait(20)
    player.parts.notices.say("A line that is long enough to be broken where a window is as small as this one may be")
    player.wait(2)


@sweep("size", [(640, 480), (1280, 720)], keep=[(640, 480)])
@sweep(("scale", "zoomed"), product([0.75, 1, 2, 3], [0, 4]), keep=[(0.75, 0), (2, 4)])
def test_nothing_that_tells_of_the_sand_lies_over_it(glass, size, scale, zoomed):
    glass.parts.settings.override("ui_scale", scale)
    pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    glass.frame(pygame.event.Event(pygame.WINDOWSIZECHANGED, x=size[0], y=size[1]))
    everything(glass)
    glass.parts.camera.zoom(zoomed)
    glass.hold_time()
    glass.parts.forecasting.update = lambda now_s: None  # no other answer comes between the two pictures
    glass.wait(2)
    left, top, right, bottom = glass.parts.display.sand_view.view.seen
    lattice = pygame.Rect(left, top, right - left, bottom - top)
    with_all = pygame.surfarray.array2d(glass.parts.window.surface.subsurface(lattice))
    glass.parts.display.sand_view.refresh()
    glass.parts.window.surface.fill((9, 9, 9))
    glass.parts.renderer.forget()
    glass.frame(elapsed_ns=0)
    layout = glass.parts.display.layout
    assert set(layout.cards) == {"legend", "figures"} and glass.parts.notices.line
    drawn = [layout.bar, layout.status_line, *layout.cards.values(), *([layout.plots] if layout.plots else [])]
    assert lattice.collidelist(drawn) < 0 and lattice.size > (0, 0)
    assert (with_all == pygame.surfarray.array2d(glass.parts.window.surface.subsurface(lattice))).all()


@pytest.fixture
def screen(monkeypatch):
    """Return a function that gives what a screen shows which is brought up to date only as pygame is told to."""
    seen = []

    def flip():
        seen[:] = [pygame.display.get_surface().copy()]

    def update(rects):
        for rect in rects:
            seen[0].blit(pygame.display.get_surface(), rect, rect)

    monkeypatch.setattr(pygame.display, "flip", flip)
    monkeypatch.setattr(pygame.display, "update", update)
    return lambda: pygame.surfarray.array2d(seen[0])


@sweep("size", [(1280, 720), (1366, 768), (1920, 1080)], keep=[(1366, 768)])
def test_nothing_of_what_was_shown_stays_on_the_screen(screen, size):
    player = Player("paper", size)
    player.key(pygame.K_9, "9")
    player.pointer = 500, 300
    player.wait(3)
    shift_h, forecast, plots = (pygame.K_h, "H", pygame.KMOD_SHIFT), (pygame.K_h, "h"), (pygame.K_l, "l")
    for key in (
        shift_h,
        forecast,
        plots,
        (pygame.K_p, "p"),
        shift_h,
        plots,
        forecast,
        (pygame.K_F1,),
        (pygame.K_F1,),
        (pygame.K_p, "p"),
    ):
        player.key(*key)
        player.pointer = player.pointer[0] + 37, player.pointer[1] - 11
        player.wait(2)
        assert (screen() == pygame.surfarray.array2d(pygame.display.get_surface())).all(), key
    player.parts.close()
    pygame.display.quit()


def test_a_line_goes_with_what_it_is_about(player):
    parts = player.parts
    parts.notices.say("The timer was stopped.")
    player.wait(2)
    parts.sessions.load("paper")
    player.wait(1)
    assert parts.notices.text is None
    parts.notices.say("The same, of another session.")
    player.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    player.wait(1)
    assert "The same sand with" in parts.notices.text


def test_trouble_is_told_whatever_is_shown_meanwhile(player):
    player.parts.notices.say("It cannot be.", trouble=True)
    player.parts.sessions.load("paper")
    player.wait(2)
    assert player.parts.notices.text == "It cannot be."


def test_a_notice_goes_when_what_it_says_holds_no_more(player):
    parts = player.parts
    player.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    assert "The same sand with" in parts.notices.text
    player.wait(5)
    assert "The same sand with" in parts.notices.text
    player.key(pygame.K_ESCAPE)
    player.wait(2)
    assert "The same sand with" not in (parts.notices.text or "")
    player.key(pygame.K_b)
    assert "Zoom in" in parts.notices.text
    player.key(pygame.K_b)
    player.wait(2)
    assert "Zoom in" not in (parts.notices.text or "")


def test_a_line_of_trouble_is_read_before_the_next_takes_its_place(player):
    player.hold_time()
    player.parts.notices.say("It cannot be.", trouble=True)
    for text in ("Saved.", "Saved again."):
        player.parts.notices.say(text)
    seen = []
    for _ in range(400):
        player.frame(elapsed_ns=100_000_000)
        if player.parts.notices.text not in seen:
            seen.append(player.parts.notices.text)
    assert seen[:3] == ["It cannot be.", "Saved.", "Saved again."]
