"""Drawing: one look for all pictures of the study, and lattices in the colours of the toy. It needs no display."""

from matplotlib import rc_context
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.figure import Figure

LOOK = {
    "font.size": 9,
    "axes.grid": True,
    "grid.color": "#e4ded4",
    "axes.edgecolor": "#8a7f70",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": "cycler(color=['#b5761f', '#2f6f8f', '#7a4b8c', '#4f8a4b', '#a33d3d'])",
}
GROUND, GLASS, SAND, PALE = "#221c17", "#75675a", "#f0b34a", "#fff1cf"
SHADES = LinearSegmentedColormap.from_list("sand", (GROUND, "#6b3f1d", "#c8792a", SAND, PALE))
CELLS = ListedColormap((GROUND, GLASS, SAND))


def figure(rows=1, columns=1, width=6.4, height=4.0):
    """Return (figure, axes): a matplotlib Figure of width x height inches and its axes, an array if more than one."""
    with rc_context(LOOK):
        made = Figure(figsize=(width, height), layout="constrained")
        return made, made.subplots(rows, columns)


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
