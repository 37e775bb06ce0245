"""The colours of heat: read by anyone."""

import numpy as np
import pytest

from game.core.draw.heatmap import ALWAYS, NEVER, SOLID
from game.world.looks.heatmap_colours import cover, scale
from game.world.looks.painter import rgb

# Viénot, Brettel & Mollon, "Digital video colourmaps for checking the legibility of displays by dichromats", 1999.
EYES = {
    "common": np.eye(3),
    "protanope": [[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1.0]],
    "deuteranope": [[0.29275, 0.70725, 0.0], [0.29275, 0.70725, 0.0], [-0.02234, 0.02234, 1.0]],
}


def lightness(colours, eye):
    """Return CIE L* of (N, 3) sRGB colours as an eye sees them."""
    share = colours / 255
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    luminance = np.clip(linear @ np.transpose(EYES[eye]), 0, None) @ [0.2126, 0.7152, 0.0722]
    return np.where(luminance > 0.008856, 116 * np.cbrt(luminance) - 16, 903.3 * luminance)


@pytest.mark.parametrize("stale", [False, True])
@pytest.mark.parametrize("eye", EYES)
def test_more_is_lighter_by_even_steps_to_every_eye(eye, stale):
    steps = np.diff(lightness(scale(stale)[: ALWAYS + 1 : 8].astype(float), eye))
    assert steps.min() > 0.5 * steps.mean() and steps.max() < 1.7 * steps.mean()


def test_a_stale_scale_has_no_hue_and_the_other_has():
    assert np.ptp(scale(True), axis=1).max() <= 1 and np.ptp(scale()[60:200], axis=1).min() > 40


@pytest.mark.parametrize("stale", [False, True])
def test_walls_stay_as_they_are_and_no_colour_overflows(stale):
    kept, laid = cover(rgb, stale)
    assert kept[SOLID] == 256 and laid[SOLID] == laid[NEVER] == 0
    for byte in (0, 8, 16):
        assert ((255 * kept >> np.uint32(8)) + (laid >> np.uint32(byte) & np.uint32(255)) <= 255).all()
