"""The page of a material: opened from its swatch, it says what the rule says, in every window."""

import pygame
import pytest

from tests.play.player import Player


@pytest.fixture
def player():
    """Return a player of the kitchen, with time held and water in hand."""
    player = Player("kitchen", size=(1280, 720))
    player.hold_time()
    player.parts.brush.material = "water"
    player.wait(1)
    yield player
    pygame.display.quit()


def press_swatch(player, name):
    player.parts_of("Paint")
    player.click(player.parts.panel.ui.parts("Paint")[player.parts.brush.materials.index(name)].center)


def test_the_swatch_in_hand_pressed_again_shows_what_it_does_and_esc_goes_back(player):
    press_swatch(player, "lava")
    assert not player.parts.material_page.shown and player.parts.brush.material == "lava"
    press_swatch(player, "lava")
    assert player.parts.material_page.shown
    player.key(pygame.K_ESCAPE)
    assert not player.parts.material_page.shown


@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize("size", [(640, 480), (1280, 720)])
def test_every_reaction_is_written_whole(player, size, scale):
    player.parts.settings.override("ui_scale", scale)
    player.resize(size)
    player.parts.material_page.toggle()
    words = " ".join(player.words().split())
    assert "With lava becomes stone and steam" in words and "water quenches lava" in words
    assert "0.8" in words and "It sinks in oil." in words


def test_what_is_turned_is_what_the_page_says(player):
    rule = player.session.rule
    player.session.timeline.moment.rule = rule.with_chances(dissolve=0.875)
    player.parts.material_page.toggle()
    assert "0.875" in player.words()


def turnable(player):
    """Return {what the open page says of it: the place of its handle's way} for all that can be turned there."""
    ui = player.parts.material_page._ui
    return {name: ui.parts(name)[0] for name in ui.focus.slots if name.startswith(("With ", "By itself "))}


def test_what_the_page_tells_is_turned_there_as_one_act(player):
    player.parts.brush.material = "plant"
    player.parts.material_page.toggle()
    player.wait(1)
    track = turnable(player)["With fire becomes two cells of fire"]
    player.drag(*((track.x + share * track.width // 8, track.centery) for share in (4, 6, 8)))
    player.settle()
    player.wait(2)
    assert player.session.rule.chances["kindle"] == 1.0 and "With fire becomes two cells of fire" in player.words()
    player.parts.commands.give("time.undo")
    assert player.session.rule.chances["kindle"] == 0.5


@pytest.mark.parametrize("scale", [1, 2])
def test_a_chance_is_read_whole_however_small_it_is(player, scale):
    player.parts.settings.override("ui_scale", scale)
    rule = player.session.rule.with_chances(freeze=0.00585, thaw=0.00001, grow=0.125)
    player.session.timeline.moment.rule = rule
    for name, figures in (("ice", ("0.00585", "0.00001")), ("plant", ("0.125",))):
        player.parts.brush.material = name
        player.parts.material_page.toggle()
        theme, found = player.parts.display.theme, {text: each for *each, text in map(_last, player.written())}
        for each in figures:
            rect, size = found[each]
            assert theme.width(each, size) <= rect.width
        player.parts.material_page.toggle()


def test_where_some_chances_have_no_slider_the_page_says_why(player):
    for name, some in (("lava", True), ("sand", False)):
        player.parts.brush.material = name
        player.parts.material_page.toggle()
        assert ("What has no slider is fixed" in " ".join(player.words().split())) == some
        player.parts.material_page.toggle()


def _last(written):
    rect, text, size = written
    return rect, size, text


def test_every_chance_of_what_changes_a_material_is_turned_on_the_page_of_one(player):
    count, chances = 0, player.session.rule.chances
    for name in player.parts.brush.materials[:-1]:
        player.parts.brush.material = name
        player.parts.material_page.toggle()
        player.wait(1)
        for handle in turnable(player).values():
            player.click((handle.right - 20, handle.centery))
            count += 1
        player.parts.material_page.toggle()
    player.settle()
    same = {name for name, chance in player.session.rule.chances.items() if chance == chances[name]}
    assert count > len(chances) and same == {"cling", "mix"}  # by which nothing becomes another


def test_the_page_is_no_higher_than_the_longest_and_stays_where_it_is_from_one_to_the_next(player):
    size = 1600, 1200
    player.resize(size)
    player.parts.material_page.toggle()
    rects, ends = set(), []
    for name in player.parts.brush.materials[:-1]:
        player.parts.brush.material = name
        player.wait(1)
        rects.add(tuple(player.parts.material_page._rect))
        ends.append(player.parts.material_page._ui.rects["Close"].bottom)
    (rect,) = rects
    assert 0 < pygame.Rect(rect).bottom - max(ends) < 30 and pygame.Rect(rect).height < 0.7 * size[1]


def test_the_sand_goes_back_to_what_it_was_when_the_page_is_closed(player):
    before = pygame.surfarray.array2d(player.parts.window.front).copy()
    player.parts.material_page.toggle()
    player.wait(2)
    assert (pygame.surfarray.array2d(player.parts.window.front) != before).any()
    player.parts.material_page.toggle()
    player.wait(2)
    assert (pygame.surfarray.array2d(player.parts.window.front) == before).all()
