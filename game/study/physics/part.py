"""Part 6, sand as physics: what the model gets right about real sand, and what it does not."""

from game.study.physics import flow, piles
from game.study.physics.claims import claim_table
from game.study.physics.kinds import KINDS, ROLLING
from game.study.report.report import Finding

TITLE = "6. Sand as physics"
CONCLUSION = (
    "Right: sand is conserved and heaps into cones with straight flanks, and at p ≥ 0.75 a glass runs out at a rate "
    "that does not depend on how much is left. Not right: at p ≤ 0.5 the flow dwindles with the sand above; the slope "
    "is close to 45° for every p, because the lattice sets it and p only says how long it takes to get there (cells "
    "drawn 1.5 times as wide as high would show 33°); grains fall at one speed instead of faster and faster; and once "
    "the plug above a neck has fallen, the flow does not depend on the neck's width, because only the free surface "
    "moves: a wide neck empties a glass hardly sooner than one of two cells. There is no jamming, no inertia and no "
    "pressure. Grains that roll on until they stop mend the slope, which the chance to stop then sets, and a flow that "
    "does not dwindle; what they do in the air and at a neck is as before."
)


def run(study):
    """Yield the rows, tables and pictures of this part."""
    rows = []
    for item in _items(study):
        if isinstance(item, Finding):
            rows.append(item)
        yield item
    yield claim_table(rows)
    yield CONCLUSION


def _items(study):
    for kind in KINDS:
        yield from flow.necks(study, kind)
    yield from flow.heights(study, flow.of_sand() | flow.of_rolling_sand(ROLLING.rule))
    yield from flow.drains(study)
    yield from piles.slopes_of_sand(study)
    yield from piles.slopes_of_rolling_sand(study, ROLLING.rule)
    for kind in KINDS:
        yield piles.free_fall(kind)
