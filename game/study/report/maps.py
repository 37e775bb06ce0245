"""Maps: pictures of lattices, in the colours of the toy."""

from matplotlib.colors import LinearSegmentedColormap, ListedColormap

from game.study.report.drawing import figure

GROUND, GLASS, SAND, PALE = "#221c17", "#75675a", "#f0b34a", "#fff1cf"
SHADES = LinearSegmentedColormap.from_list("sand", (GROUND, "#6b3f1d", "#c8792a", SAND, PALE))
CELLS = ListedColormap((GROUND, GLASS, SAND))


def lattices(views, walls, columns):
    """Return a figure of (title, (H, W) bool sand) views side by side."""
    made, axes = _panels(views, columns)
    for (title, sand), each in zip(views, axes, strict=True):
        each.imshow(walls + 2 * sand, cmap=CELLS, vmin=0, vmax=2, interpolation="nearest")
        each.set_title(title)
    return made


def densities(views, walls, columns, label):
    """Return a figure of (title, (H, W) density) views side by side, with one colour bar."""
    made, axes = _panels(views, columns)
    for (title, density), each in zip(views, axes, strict=True):
        drawn = each.imshow(density, cmap=SHADES, vmin=0, vmax=1, interpolation="nearest")
        each.imshow(walls, cmap=ListedColormap(("#00000000", GLASS)), interpolation="nearest")
        each.set_title(title)
    bar = made.colorbar(drawn, ax=axes, shrink=0.9, aspect=25, pad=0.02)
    bar.set_label(label)
    bar.outline.set_visible(False)
    return made


def _panels(views, columns):
    rows = -(-len(views) // columns)
    made, axes = figure(rows, columns, width=2.35 * columns + 0.6, height=2.55 * rows)
    for each in axes.flat:
        each.set_axis_off()
    return made, list(axes.flat)
