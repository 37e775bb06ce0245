"""Laws of the tabs: each brings its section to the top, whole, in small windows too, by mouse and by keyboard."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from tests.play.panel.test_panel import seen
from tests.play.player import words_of
from tests.sweeps import sweep

FIRST = {  # control of each tab's section
    **{"Scene": "Scene", "Tools": "Tool", "Rule": "Rule", "Time": "Speed", "More": "Timer", "Measure": "Forecast"},
    "View": "Sound",
}
LAST = {"Scene": "Open", "Tools": "Shape of the brush", "Rule": "All seven probabilities", "Time": "Run to rest"}
LAST |= {"More": "Recording and past", "Measure": "Figures", "View": "Reduced motion"}
WINDOWS = ((640, 480), 1), ((1280, 720), 1), ((1280, 720), 2), ((3840, 2160), 1.5)


def tab(player, name):
    """Return where the tab of that name is, and whether it is the chosen one."""
    rect, strokes = player.parts.panel.drawing()
    [place] = [pygame.Rect(place) for place, text, _ in words_of(strokes) if text == name]
    fills = [(pygame.Rect(place), how[0]) for stroke, place, *how in strokes if stroke is draw_list.fill]
    lines = [place for place, colour in fills if colour == look.ACCENT]
    assert rect.contains(place) and len(lines) == 1
    return place.center, place.contains(lines[0])


def shows(player, name):
    """Return whether a tab is the chosen one, and its section in sight from first to last control."""
    ui, layout = player.parts.panel.ui, player.parts.display.layout
    top = player.parts.panel.tabs.rect.bottom
    column = pygame.Rect(layout.panel.x, top, layout.panel.width, layout.panel.bottom - top)
    return tab(player, name)[1] and all(column.contains(ui.rects[each[name]]) for each in (FIRST, LAST))


@sweep(("size", "scale"), WINDOWS, keep=WINDOWS[:1])
def test_a_press_on_a_tab_brings_its_section_into_sight_as_a_whole(glass, size, scale):
    seen(glass, size, scale)
    for name in (*FIRST, *reversed(FIRST)):
        glass.click(tab(glass, name)[0])
        glass.frame()
        assert shows(glass, name), name


@sweep(("size", "scale"), WINDOWS, keep=WINDOWS[:1])
def test_ctrl_and_the_page_keys_go_round_the_sections_and_work_their_first_control(glass, size, scale):
    ui = seen(glass, size, scale)
    for code, names in ((pygame.K_PAGEDOWN, [*FIRST][1:] + [*FIRST][:1]), (pygame.K_PAGEUP, reversed(FIRST))):
        for name in names:
            glass.key(code, mod=pygame.KMOD_LCTRL)
            glass.frame()
            assert ui.focus.name == FIRST[name] and ui.focus.by_keyboard and shows(glass, name)


def test_the_page_keys_bring_back_a_panel_that_is_hidden(glass):
    seen(glass, (640, 480), 1)
    glass.key(pygame.K_p)
    glass.key(pygame.K_PAGEDOWN, mod=pygame.KMOD_LCTRL)
    assert glass.parts.display.panel_shown


def test_the_tab_follows_what_is_scrolled_to(glass):
    ui = seen(glass, (640, 480), 1)
    assert tab(glass, "Scene")[1]
    glass.control("Speed")
    ui.focus.scroll.to(ui.focus.slots["Speed"].rect.top)
    glass.frame()
    assert tab(glass, "Time")[1] and not tab(glass, "Scene")[1]


def test_what_is_done_over_the_tabs_does_nothing_to_brush_and_sand(glass):
    seen(glass, (640, 480), 1)
    glass.hold_time()
    size, grains = glass.parts.brush.diameter, glass.world.grains
    glass.move(tab(glass, "Rule")[0])
    glass.frame(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=3, precise_y=3.0, flipped=False))
    glass.drag(tab(glass, "Rule")[0], button=3)
    assert (glass.parts.brush.diameter, glass.world.grains) == (size, grains) and tab(glass, "Scene")[1]


def test_tabs_stand_in_one_row_where_their_words_fit_and_never_over_each_other(glass):
    for size, scale in (*WINDOWS, ((500, 400), 1), ((320, 240), 1)):
        seen(glass, size, scale)
        rect, strokes = glass.parts.panel.drawing()
        places = [pygame.Rect(place) for place, *_ in words_of(strokes)]
        assert all(place.collidelist(places[number + 1 :]) < 0 for number, place in enumerate(places))
        assert rect.width == glass.parts.display.layout.panel.width
        assert size[0] < 640 or len({place.y for place in places}) == 1
