"""Figures: one look for all pictures of the study, drawn without a display."""

from matplotlib import rc_context
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


def figure(rows=1, columns=1, width=6.4, height=4.0):
    """Return (figure, axes): a matplotlib Figure of width x height inches and its axes, an array if more than one."""
    with rc_context(LOOK):
        made = Figure(figsize=(width, height), layout="constrained")
        return made, made.subplots(rows, columns)
