"""The picture: time per iteration against cells, on logarithmic axes. Only this part of the bench needs matplotlib."""

from matplotlib.figure import Figure

from game.study.bench.materials import SAND
from game.study.report.report import Picture

GROUND, FRAME, TEXT, DIM = "#181512", "#3a342d", "#e8dfd2", "#a89d8e"
SIZE_INCHES = (9.0, 5.6)
FRAME_BUDGET_MS = 16.0
LINES = (  # label, colour, marker
    ("paper", "the paper's table", "#c9bfb0", "s"),
    ("numpy", "numpy blocks", "#7f9bb0", "o"),
    ("byte_loop", "numba byte loop", "#6fae9b", "o"),
    ("cpp", "C++ -O3 byte loop", "#a98bb8", "o"),
    ("ours", "Sandglass", "#f5b942", "o"),
    ("xor", "memory: one xor pass", "#e06c4f", None),
)


def curves(tables):
    """Return {key of LINES: [(cells, milliseconds)]} from the rows of each table."""
    found = {key: [] for key, *_ in LINES}
    found["paper"] = [(row["cells"], row["paper_ms"]) for row in tables["paper"] if row["paper_ms"]]
    for row in tables["peers"]:
        if "p = 1" in row["world"] and row["key"] in found and row["key"] != "ours":
            found[row["key"]].append((row["cells"], row["time"].median / 1e6))
    for row in [row for row in tables["scale"] if row["rule"] == SAND]:
        found["ours"].append((row["cells"], row["time"].median / 1e6))
        found["xor"].append((row["cells"], row["xor"].median / 1e6))
    return found


def draw(tables):
    """Return the Picture of the curves; tables: the rows of each table, by its name."""
    figure = Figure(figsize=SIZE_INCHES, facecolor=GROUND, layout="constrained")
    axes = figure.add_subplot(facecolor=GROUND)
    found = curves(tables)
    for key, label, colour, marker in LINES:
        points = sorted(found[key])
        if points:
            style = {"linewidth": 2.4 if key == "ours" else 1.4, "linestyle": "--" if key == "xor" else "-"}
            axes.plot(*zip(*points, strict=True), color=colour, marker=marker, markersize=5, label=label, **style)
    axes.axhline(FRAME_BUDGET_MS, color=DIM, linewidth=0.8, linestyle=":")
    axes.annotate("one frame, 16 ms", (0.01, FRAME_BUDGET_MS), xycoords=("axes fraction", "data"), xytext=(0, 4),
                  textcoords="offset points", color=DIM, fontsize=9)  # fmt: skip
    _dress(axes)
    return Picture("speed", figure, "Milliseconds per iteration against cells: the paper, peers, Sandglass, memory")


def _dress(axes):
    axes.set(xscale="log", yscale="log", xlabel="cells", ylabel="milliseconds per iteration, one thread")
    axes.set_title("Time of an iteration against cells, all of them in motion", color=TEXT, loc="left", fontsize=12)
    axes.grid(color=FRAME, linewidth=0.6)
    axes.tick_params(colors=DIM, which="both")
    axes.xaxis.label.set_color(DIM)
    axes.yaxis.label.set_color(DIM)
    for spine in axes.spines.values():
        spine.set_color(FRAME)
    axes.legend(frameon=False, labelcolor=TEXT, fontsize=9, loc="lower right")
