"""The cells of a scene as C."""

import numpy as np

from game.export.c_text import listed, plain

MOST_RUNS = 2**18  # some 2 MB of text


def scene_parts(cells, materials, words):
    """Return {name in the template: C} of (H, W) uint8 codes; words: what they are, in a sentence.

    Raises ValueError for cells that are too many runs.
    """
    flat = cells.ravel()
    starts = np.flatnonzero(np.append(True, flat[1:] != flat[:-1]))
    if len(starts) > MOST_RUNS:
        raise ValueError(f"found {len(starts):,} runs of cells, wanted at most {MOST_RUNS:,}")
    lengths = np.diff(np.append(starts, len(flat)))
    return {
        "scene_width": cells.shape[1],
        "scene_height": cells.shape[0],
        "scene_words": plain(words),
        "runs": listed(map(str, (lengths * materials + flat[starts]).tolist())),
    }
