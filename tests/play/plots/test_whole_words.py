"""What the plots and cards beside the sand write is whole, and what they leave out they tell."""

from functools import partial

import pygame
import pytest

from game.play.forecast.legend import scale_card
from game.play.plots import audit_card
from game.play.plots.material_cards import amounts_card, books_card
from game.play.plots.reactions_card import reactions_card
from game.play.ui.theme import Theme
from game.world.rules.definition import Book
from game.world.sand.grain_account import GrainAccount
from tests.play.player import Player, words_of

NAMES = "water", "lava", "steam", "ice", "plant", "smoke", "salt", "brine"
SIZES = [(640, 480), (900, 600), (1280, 720)]


def cut(theme, written):
    """Return the texts that are wider than their places."""
    return [text for rect, text, size in written if theme.width(text, size) > rect[2]]


@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scene", ["kitchen", "hourglass"])
def test_no_word_and_no_figure_beside_the_sand_is_cut(scene, size, scale):
    player = Player(scene)
    player.parts.settings.override("ui_scale", scale)
    player.resize(size)
    player.session.clock.speed = 1500
    for command in ("view.toggle_plots", "sand.compare", "view.toggle_density"):
        player.parts.commands.give(command)
        player.wait(60)
        panel, theme = player.parts.display.layout.panel, player.parts.display.theme
        assert not cut(theme, [each for each in player.written() if not panel.contains(each[0])])
    pygame.display.quit()


def cards():
    """Return functions of theme and rect that draw a card with a row for each of NAMES."""
    codes, colours = {name: [number] for number, name in enumerate(NAMES)}, [(9, 9, 9)] * len(NAMES)
    amounts = (8,) * len(NAMES)
    books = [Book(name, frozenset(codes[name]), (), "") for name in NAMES]
    return (
        partial(amounts_card, samples=[(0, amounts)], names=codes, colours=colours),
        partial(reactions_card, nows=[0, 9], reactions={name: [0, 1] for name in NAMES}, speed=9),
        partial(books_card, account=GrainAccount(amounts, ()), amounts=amounts, books=books),
    )


@pytest.mark.parametrize("size", [(144, 100), (210, 86), (180, 132), (300, 600)])
@pytest.mark.parametrize("draw", cards(), ids=["amounts", "reactions", "books"])
def test_a_card_says_how_many_rows_it_has_no_room_for(draw, size):
    written = words_of(draw(Theme(), pygame.Rect(0, 0, *size)))
    texts = [text for _, text, _ in written]
    shown, said = len(set(NAMES) & set(texts)), f" of {len(NAMES)}" in " ".join(texts)
    assert not cut(Theme(), written) and shown and said == (shown < len(NAMES))
    assert not said or f"{shown} of {len(NAMES)}" in " ".join(texts)


def test_a_name_that_is_wider_than_its_card_goes_on_in_the_next_line():
    name = "water quenches lava and steam rises"
    written = words_of(reactions_card(Theme(), pygame.Rect(0, 0, 144, 100), [0, 9], {name: [0, 1]}, 9))
    assert not cut(Theme(), written) and set(name.split()) <= set(" ".join(text for _, text, _ in written).split())


def test_a_legend_breaks_its_lines_and_writes_its_title_whole():
    lines = ["Sand at iteration 10,102", "1,024 runs: ± 1.6 % at most"]
    written = words_of(scale_card(Theme(), pygame.Rect(0, 0, 148, 300), "Density at t = 1,647", lines))
    assert not cut(Theme(), written) and {"10,102", "most"} <= set(" ".join(text for _, text, _ in written).split())


def test_an_audit_that_has_no_room_for_all_its_sums_leaves_those_out_that_are_zero():
    account = GrainAccount((7, 0), (), poured_by_kind=(3, 0))
    for height, wanted in ((400, True), (100, False)):
        written = words_of(audit_card.card(Theme(), pygame.Rect(0, 0, 200, height), account, (10, 0), [(9, 9, 9)] * 2))
        texts = [text for _, text, _ in written]
        assert {"+ poured", "= now", "10"} <= set(texts) and ("+ painted" in texts) == wanted
