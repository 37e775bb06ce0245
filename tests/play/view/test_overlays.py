"""What lies over the sand: soft at its edges however often it is drawn, and gone without a trace."""

import pygame
import pytest

from game.play.view.dialog import Answer
from tests.play.player import Player


def notice(parts, _now_s):
    parts.notices.say("A line that is to be read over the sand")


def question(parts, _now_s):
    parts.dialog.ask(
        "A title", "And words.", [Answer("Yes", None, pygame.K_y, "Y"), Answer("No", None, pygame.K_n, "N")]
    )


def badge(parts, _now_s):
    parts.camera.zoom(2)


def legend(parts, _now_s):
    parts.forecasting.toggle()


def glow(parts, now_s):
    parts.settings["reduced_motion"] = True  # so that it stands still
    parts.glow.start(now_s)


def two_at_once(parts, now_s):
    badge(parts, now_s)
    notice(parts, now_s)


def sand_of(player):
    """Return the pixels of the sand's part of the window."""
    area = player.parts.display.layout.sand
    return pygame.surfarray.array2d(player.parts.window.surface)[: area.width, : area.height]


def check(player, show):
    """Draw many frames of `show`, first while sand moves, then while only an outline passes; then draw it all anew."""
    player.parts.notices.say("")  # no hint comes in between
    player.hold_time()
    show(player.parts, player.now_s)
    for number in range(60):
        player.session.paused = number > 20
        player.pointer = 20 + 9 * number, 300 - 4 * number
        player.frame()
    player.pointer = None
    player.parts.forecasting.update = lambda now_s: None  # no other answer comes between the two pictures
    player.wait(2)
    assert any(each.shown for each in player.parts.overlays)
    often = sand_of(player)
    player.parts.display.stage.refresh()
    player.wait(0)
    assert (often == sand_of(player)).all()


@pytest.mark.parametrize("show", [notice, question, badge, legend, glow, two_at_once])
def test_what_is_drawn_often_looks_as_if_it_were_drawn_once(glass, show):
    try:
        check(glass, show)
    finally:
        glass.parts.close()


@pytest.mark.parametrize("show", [notice, question])
def test_so_it_does_over_three_worlds(show):
    player = Player("hourglass", (1100, 700))
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    player.wait(1)
    check(player, show)
    player.parts.close()
    pygame.display.quit()


def test_a_still_picture_with_something_over_it_is_not_drawn_again(glass):
    glass.hold_time()
    notice(glass.parts, glass.now_s)
    glass.wait(20)
    assert glass.parts.notices.shown and not any(glass.frame() for _ in range(10))


def test_a_notice_goes_when_what_it_says_holds_no_more(player):
    parts = player.parts
    player.key(pygame.K_h, mod=pygame.KMOD_LSHIFT)
    assert "three schedules" in parts.notices.text
    player.wait(5)
    assert "three schedules" in parts.notices.text
    player.key(pygame.K_ESCAPE)
    player.wait(2)
    assert "three schedules" not in (parts.notices.text or "")
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
