"""The plan: how much is measured. Sizes are (width, height) in cells or pixels."""

from dataclasses import dataclass

FULL_HD, FOUR_K, LARGEST = (1920, 1080), (3840, 2160), (16384, 16384)


@dataclass(frozen=True)
class FrameCase:
    """A scene to play in a window; `size` None is the scene's own lattice, `window` None its own window."""

    scene: str
    size: tuple | None
    window: tuple | None
    iterations: int  # in each frame
    goal: bool = False
    smooth: bool = True  # falling sand is drawn as the mean of a cycle
    shown: tuple = ()  # what is seen besides the sand, as game.play.trials.frame_timing names it
    p: float | None = None  # None: the scene's own
    cell: float | None = None  # pixels; None: the whole lattice is seen


@dataclass(frozen=True)
class BenchPlan:
    """What to measure and how often."""

    rounds: int
    sample_ms: float  # the least a sample lasts: shorter acts are repeated
    batch: int  # iterations from the world's start in each sample
    peer_batch: int  # the same beside peers, which are slow
    checked: int  # iterations compared with the twin, at most
    paper_sizes: tuple
    peer_sizes: tuple
    scene_size: tuple
    glass_sizes: tuple
    scale_sizes: tuple
    headers: tuple  # compilers of the exported header, where they are there
    rule_size: tuple  # of the lattices on which rules of several materials are held against peers, …
    rule_scale_sizes: tuple  # … and of those that tell the time of a cell
    frame_cases: tuple
    frames: int
    starts: int  # warm starts
    cold: bool  # whether to start without compiled kernels, too

    @property
    def sample_ns(self):
        """The least a sample lasts, in nanoseconds."""
        return round(self.sample_ms * 1e6)


PAPER_SIZES = ((640, 480), (800, 600), FULL_HD, (2560, 1440), FOUR_K)
GOAL_FRAMES = (
    FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True),
    FrameCase("fullhd", FOUR_K, FOUR_K, 8, goal=True),
)
FULL = BenchPlan(
    rounds=9,
    sample_ms=4,
    batch=100,
    peer_batch=20,
    checked=100,
    paper_sizes=PAPER_SIZES,
    peer_sizes=((61, 61), (240, 180), FULL_HD, FOUR_K),
    scene_size=FOUR_K,
    glass_sizes=((61, 61), (240, 180), FULL_HD, FOUR_K, LARGEST),
    scale_sizes=((61, 61), (240, 180), (640, 480), FULL_HD, FOUR_K, (4096, 4096), (7680, 4320), LARGEST),
    headers=("gcc", "clang"),
    rule_size=FULL_HD,
    rule_scale_sizes=((61, 61), (240, 180), FULL_HD, FOUR_K),
    frame_cases=(
        FrameCase("hourglass", None, None, 16),
        FrameCase("paper", None, None, 16),
        FrameCase("hourglass", FULL_HD, FULL_HD, 16),
        *GOAL_FRAMES,
        FrameCase("fullhd", FULL_HD, FULL_HD, 16, smooth=False),
        FrameCase("hourglass", FOUR_K, FOUR_K, 8),
        *(FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True, cell=cell) for cell in (1, 4, 32)),
        *(FrameCase("hourglass", LARGEST, FULL_HD, 1, goal=True, cell=cell) for cell in (None, 0.25, 1)),
        FrameCase("paper", None, None, 1, shown=("forecast",), p=0.5),
        FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True, shown=("forecast",)),
        FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True, shown=("plots",)),
        FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True, shown=("forecast", "plots")),
        FrameCase("hourglass", None, FULL_HD, 16, goal=True, shown=("compare",)),
        FrameCase("fullhd", FULL_HD, FULL_HD, 16, goal=True, shown=("forecast", "plots", "compare")),
        FrameCase("rainbow", FULL_HD, FULL_HD, 16, goal=True),
        FrameCase("rainbow", FULL_HD, FULL_HD, 16, goal=True, shown=("forecast", "plots", "compare")),
    ),
    frames=300,
    starts=5,
    cold=True,
)
QUICK = BenchPlan(
    rounds=5,
    sample_ms=2,
    batch=100,
    peer_batch=4,
    checked=8,
    paper_sizes=PAPER_SIZES,
    peer_sizes=((240, 180), FULL_HD),
    scene_size=FULL_HD,
    glass_sizes=((61, 61), (240, 180), FULL_HD),
    scale_sizes=((61, 61), (240, 180), FULL_HD, FOUR_K),
    headers=("gcc",),
    rule_size=FULL_HD,
    rule_scale_sizes=((240, 180), FULL_HD),
    frame_cases=GOAL_FRAMES,
    frames=100,
    starts=2,
    cold=False,
)
