"""The portrait that the README shows."""

from pathlib import Path

import numpy as np
from PIL import Image

from game.core.draw.looks import GRAIN, SURFACE
from game.play.trials import readme_gif
from game.world.looks.themes import NIGHT, palette

SHOWN = Path(__file__).parents[3] / "assets" / "pictures" / "portrait.gif"
LARGEST = 1_500_000  # bytes: what a reader should not have to wait for


def test_the_portrait_is_small_and_the_one_that_the_code_makes(tmp_path):
    readme_gif.make(tmp_path / "portrait.gif")
    with Image.open(tmp_path / "portrait.gif") as made, Image.open(SHOWN) as shown:
        assert made.n_frames == shown.n_frames
        for number in range(0, made.n_frames, 20):
            for each in (made, shown):
                each.seek(number)
            assert (np.asarray(made.convert("RGB")) == np.asarray(shown.convert("RGB"))).all()
    assert len(SHOWN.read_bytes()) < LARGEST


def test_the_glass_of_the_portrait_runs_out_and_is_turned_over():
    film = [pixels for pixels, _ in readme_gif.frames()]
    sand = [np.isin(pixels, palette(NIGHT)[GRAIN : SURFACE + 1]).nonzero()[0].mean() for pixels in film]
    middle = len(film[0]) / 2
    assert sand[0] < middle and max(sand) > 1.4 * middle, "it falls from the upper half to the lower"
    assert sand[-1] < sand[-8], "and is on its way up again"
