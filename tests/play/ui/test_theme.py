"""A theme keeps what it has drawn, and gives it back when it is let go."""

import gc
import weakref

from game.play.ui import theme as look
from game.world.looks.themes import NIGHT


def test_a_theme_that_is_no_longer_used_gives_its_text_back_at_once():
    gc.collect()
    gc.disable()
    try:
        seen = []
        for number in range(look.MOST_KEPT + 3):
            theme = look.theme_of(1.01 + number / 16, NIGHT)  # that no window of another test holds
            theme.lines("Words that are broken where they must", look.BODY, theme.px(60))
            seen.append((weakref.ref(theme), weakref.ref(theme.words("Words", look.BODY, look.TEXT))))
        kept = [theme() is not None and text() is not None for theme, text in seen]
        assert kept == [False] * 3 + [True] * look.MOST_KEPT
    finally:
        gc.enable()


def test_what_was_drawn_once_is_not_drawn_again():
    theme = look.Theme(1.0)
    assert theme.words("Sand", look.BODY, look.TEXT) is theme.words("Sand", look.BODY, look.TEXT)
    assert theme.disc(9, look.TEXT) is theme.disc(9, look.TEXT)
