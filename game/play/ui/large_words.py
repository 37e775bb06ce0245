"""Large words: letters to be read across a room, each sign drawn alone, so that numbers do not jump as they change."""

from game.play.ui import theme as look

WIDEST = "8"  # of the digits
NUMBER = "0123456789"


def width(theme, text, size):
    """Return the width in pixels of a line of text in which all digits are equally wide."""
    return sum(theme.width(_as_wide(sign), size) for sign in text)


def fitting_size(theme, lines, room):
    """Return the largest size, in pixels at scale 1, in which lines of text fit one above another in room (w, h)."""
    high = room[1] / len(lines)
    size = max(1, int(high / theme.line_height(look.BODY) * look.BODY))
    widest = max(width(theme, line, size) for line in lines)
    return size if widest <= room[0] else max(1, int(size * room[0] / widest))


def large_words(surface, theme, rect, text, size, colour, align):
    """Write one line in the middle height of the rect, at its left (0), middle (0.5) or right (1)."""
    x, y, wide, high = rect
    left = x + round((wide - width(theme, text, size)) * align)
    for sign in text:
        sprite, room = theme.words(sign, size, colour), theme.width(_as_wide(sign), size)
        surface.blit(sprite, (left + (room - sprite.get_width()) // 2, y + (high - sprite.get_height()) // 2))
        left += room


def _as_wide(sign):
    return WIDEST if sign in NUMBER else sign
