"""Part 1, exact: ensembles of the kernels against the Markov chain of the rule."""

TITLE = "1. Exact"


def run(study):
    """Yield the rows of this part."""
    yield from ()
