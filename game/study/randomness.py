"""Part 1, randomness."""


def run(study):
    yield from ()
