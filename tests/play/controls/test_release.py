"""Laws of letting go: what is held does not stay held when nobody hears the button or the key come up."""

import pygame

from tests.play.player import Player
from tests.sweeps import sweep


def pressed_at(player, pos, button=1):
    """Press a button there; return what releases it."""
    player.button(pygame.MOUSEBUTTONDOWN, pos, button)
    return lambda: player.button(pygame.MOUSEBUTTONUP, pos, button)


def brush(player):
    return pressed_at(player, player.pixel(100, 60))


def lattice(player):
    player.parts.camera.zoom(4)
    return pressed_at(player, player.parts.display.sand_view.area.center, button=2)


def time_bar(player):
    return pressed_at(player, player.parts.time_bar.track.center)


def fast(player):
    return pressed_at(player, player.control("Fast"))


def slider(player):
    return pressed_at(player, player.control("p"))


def forward_key(player):
    player.press(pygame.K_RIGHT)


def backward_key(player):
    player.press(pygame.K_BACKSPACE)


BUTTONS = brush, lattice, time_bar, fast, slider
KEYS = forward_key, backward_key


def holds(player):
    """Return whether anything is held."""
    parts, control = player.parts, player.parts.panel.ui.focus.held
    return any(
        (
            parts.brush.painting,
            parts.camera.busy,
            parts.time_bar.held,
            parts.fast_forward.held,
            parts.rewind.held,
            control,
        )
    )


def lose_focus(player):
    player.frame(pygame.event.Event(pygame.WINDOWFOCUSLOST))


@sweep("hold", BUTTONS, keep=[brush, slider])
@sweep("key", [pygame.K_F1, pygame.K_F2, pygame.K_p], keep=[pygame.K_F1])
def test_what_a_button_holds_is_let_go_of_when_a_page_opens_or_the_panel_goes(glass, key, hold):
    glass.wait(20)
    let_go = hold(glass)
    assert holds(glass)
    glass.key(key)
    let_go()
    glass.key(key)
    assert not holds(glass)
    view, grains, rule, now = (
        glass.parts.display.sand_view.view,
        glass.world.grains,
        glass.session.rule,
        glass.session.now,
    )
    glass.move((200, 200))
    glass.wait(10)
    assert (glass.parts.display.sand_view.view, glass.world.grains, glass.session.rule) == (view, grains, rule)
    assert 0 < glass.session.now - now < 100
    glass.click(glass.control("Pause"))
    assert glass.session.paused


@sweep("hold", [*BUTTONS, *KEYS], keep=[lattice, time_bar, forward_key])
def test_what_is_held_is_let_go_of_when_the_window_loses_the_focus(glass, hold):
    glass.wait(20)
    hold(glass)
    assert holds(glass)
    lose_focus(glass)
    glass.wait(0)
    assert not holds(glass)
    glass.click(glass.control("Pause"))
    assert glass.session.paused


def test_a_key_that_came_up_elsewhere_is_heard_again(glass):
    glass.press(pygame.K_k, "k")
    assert glass.parts.cursor.on
    lose_focus(glass)
    glass.press(pygame.K_k, "k")
    assert not glass.parts.cursor.on


def test_a_stroke_cut_off_in_one_pane_does_not_bind_the_next_to_it():
    player = Player("hourglass", (1100, 700))
    player.hold_time()
    player.key(pygame.K_h, "H", pygame.KMOD_SHIFT)
    player.wait(1)
    x, y = player.pixel(60, 190)
    left = min(pane.x for pane in player.parts.display.sand_view.panes) - player.parts.display.sand_view.area.x
    player.button(pygame.MOUSEBUTTONDOWN, (x + left, y))
    lose_focus(player)
    player.key(pygame.K_c, "c")
    player.click((x, y))
    assert player.world.sand[190, 60]
    player.parts.close()
    pygame.display.quit()
