"""The strokes a panel is drawn with.

A drawing is a list of tuples (stroke, rect, ...): a value, so that two frames can be compared before either is drawn.
Each stroke takes (surface, theme, rect moved to its place, ...). A colour is a role that the theme knows, or RGB.
"""

from game.play.ui import theme as look

CHEVRON_DOWN = ((0, 0.22), (0.14, 0.22), (0.5, 0.58), (0.86, 0.22), (1, 0.22), (1, 0.34), (0.5, 0.82), (0, 0.34))
CHEVRON_RIGHT = tuple((y, x) for x, y in CHEVRON_DOWN)
ARROW = ((0, 0.42), (0.55, 0.42), (0.55, 0.15), (1, 0.5), (0.55, 0.85), (0.55, 0.58), (0, 0.58))


def draw(surface, theme, strokes, shift=(0, 0)):
    """Draw those strokes that, moved by `shift`, show inside the surface's clip."""
    dx, dy = shift
    clip = surface.get_clip()
    top, bottom = clip.top - dy, clip.bottom - dy
    for stroke, (x, y, width, height), *how in strokes:
        if y < bottom and y + height > top:
            stroke(surface, theme, (x + dx, y + dy, width, height), *how)


def fill(surface, theme, rect, colour):
    """Fill a rectangle."""
    surface.fill(theme.rgb(colour), rect)


def box(surface, theme, rect, colour, radius):
    """Fill a rectangle with round corners."""
    x, y, width, height = rect
    radius = min(radius, width // 2, height // 2)
    surface.fill(theme.rgb(colour), (x + radius, y, width - 2 * radius, height))
    surface.fill(theme.rgb(colour), (x, y + radius, radius, height - 2 * radius))
    surface.fill(theme.rgb(colour), (x + width - radius, y + radius, radius, height - 2 * radius))
    _blit_corners(surface, theme, rect, colour, radius, 0)


def ring(surface, theme, rect, colour, radius, stroke):
    """Outline a rectangle with round corners, inside its edge."""
    x, y, width, height = rect
    radius = min(radius, width // 2, height // 2)
    for top in (y, y + height - stroke):
        surface.fill(theme.rgb(colour), (x + radius, top, width - 2 * radius, stroke))
    for left in (x, x + width - stroke):
        surface.fill(theme.rgb(colour), (left, y + radius, stroke, height - 2 * radius))
    _blit_corners(surface, theme, rect, colour, radius, stroke)


def _blit_corners(surface, theme, rect, colour, radius, stroke):
    if radius < 1:
        return
    x, y, width, height = rect
    right, bottom = x + width - radius, y + height - radius
    places = (x, y), (right, y), (right, bottom), (x, bottom)
    for corner, place in zip(theme.corners(radius, colour, stroke), places, strict=True):
        surface.blit(corner, place)


def disc(surface, theme, rect, colour):
    """Fill the circle that just fits the square `rect`."""
    surface.blit(theme.disc(rect[2], colour), rect[:2])


def polygon(surface, theme, rect, points, colour):
    """Fill a polygon whose points are fractions of the rect."""
    surface.blit(theme.polygon(rect[2:], points, colour), rect[:2])


def words(surface, theme, rect, text, size, colour, align):
    """Write one line in the middle height of the rect, at its left (0), middle (0.5) or right (1); cut it to fit."""
    x, y, width, height = rect
    sprite = theme.words(theme.fitted(text, size, width), size, colour)
    surface.blit(sprite, (x + round((width - sprite.get_width()) * align), y + (height - sprite.get_height()) // 2))


def cells(surface, theme, rect, rows):
    """Draw rows of cells, 2×2 of which fill the rect, in its middle; a cell is the tuple of colours of its stripes."""
    x, y, width, height = rect
    gap = theme.px(1)
    side = (width - 3 * gap) // 2
    wide, high = (len(each) * (side + gap) + gap for each in (rows[0], rows))
    x, y = x + (width - wide) // 2, y + (height - high) // 2
    surface.fill(theme.rgb(look.EDGE), (x, y, wide, high))
    for down, row in enumerate(rows):
        for right, stripes in enumerate(row):
            left, top = x + gap + right * (side + gap), y + gap + down * (side + gap)
            for number, colour in enumerate(stripes):
                first, end = (side * each // len(stripes) for each in (number, number + 1))
                surface.fill(theme.rgb(colour), (left + first, top, end - first, side))
