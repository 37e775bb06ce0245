"""Part 5, hard cases: what could break a long run, a border or a clock."""

TITLE = "5. Hard cases"


def run(study):
    """Yield the rows of this part."""
    yield from ()
