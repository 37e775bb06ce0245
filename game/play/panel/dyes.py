"""The dyes: the swatches under the tools, from which the brush takes the colour of its sand."""

from game.play.ui.swatches import swatches
from game.world.looks.themes import GRAIN
from game.world.sand.sand_colours import COLOURS, DYES


def show(ui, toy):
    """Show a swatch for each colour and one for the rainbow, and obey what was done to them."""
    brush, theme = toy.brush, ui.theme.colours
    plain = [swatch(theme, number) for number in range(len(COLOURS))]
    fields = [*((colour,) for colour in plain), tuple(plain)]
    tips = [*(f"Sand in {name}; it paints over sand of other colours, too  (,)" for name in COLOURS)]
    tips.append("Sand in stripes of all colours, which change as time goes on  (,)")
    chosen = DYES[swatches(ui, "Colour", fields, DYES.index(brush.colour), tips)]
    if chosen != brush.colour:
        brush.dip(chosen)


def swatch(colours, number):
    """Return the RGB of the sand of a colour in a theme's Colours."""
    return tuple(map(round, colours.mean_of(number, GRAIN)))
