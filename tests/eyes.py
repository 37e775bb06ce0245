"""What eyes make of colours: how far apart two look, how well words can be read, and what colour-blind eyes see.

Sources: sRGB, IEC 61966-2-1; CIEDE2000, Sharma, Wu & Dalal 2005; contrast, WCAG 2.2; colour blindness, the matrices for
full severity of Machado, Oliveira & Fernandes, "A Physiologically-based Model for Simulation of Color Vision
Deficiency", 2009, applied to linear light.
"""

import math

import numpy as np

SIGHTS = {
    "usual": np.eye(3),
    "protanopia": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deuteranopia": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
}
RARE_SIGHTS = {
    "tritanopia": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
TO_XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
WHITE = TO_XYZ.sum(axis=1)


def light(rgb):
    """Return RGB in 0 … 255 as linear light in 0 … 1."""
    share = np.asarray(rgb, float) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def contrast(one, other):
    """Return the contrast of two colours, 1 … 21."""
    bright, dark = sorted((float(TO_XYZ[1] @ light(rgb)) for rgb in (one, other)), reverse=True)
    return (bright + 0.05) / (dark + 0.05)


def lab(rgb, sight="usual"):
    """Return CIE L*a*b* of RGB in 0 … 255 as an eye of that sight sees it."""
    seen = TO_XYZ @ np.clip((SIGHTS | RARE_SIGHTS)[sight] @ light(rgb), 0, 1) / WHITE
    x, y, z = np.where(seen > (6 / 29) ** 3, np.cbrt(seen), seen / (3 * (6 / 29) ** 2) + 4 / 29)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def difference(one, other):
    """Return CIEDE2000 of two colours in L*a*b*."""
    (l1, a1, b1), (l2, a2, b2) = one, other
    mean_c = (math.hypot(a1, b1) + math.hypot(a2, b2)) / 2
    g = 1 + 0.5 * (1 - math.sqrt(mean_c**7 / (mean_c**7 + 25**7)))
    c1, c2 = math.hypot(g * a1, b1), math.hypot(g * a2, b2)
    h1, h2 = (math.degrees(math.atan2(b, g * a)) % 360 for a, b in ((a1, b1), (a2, b2)))
    turn = (h2 - h1 + 180) % 360 - 180 if c1 * c2 else 0.0
    far = abs(h2 - h1) > 180
    h = ((h1 + h2 + (360 if far else 0)) / 2) % 360 if c1 * c2 else h1 + h2
    dl, dc, dh = l2 - l1, c2 - c1, 2 * math.sqrt(c1 * c2) * math.sin(math.radians(turn / 2))
    l50, c = (l1 + l2) / 2 - 50, (c1 + c2) / 2
    t = 1 + sum(k * math.cos(math.radians(n * h + at)) for k, n, at in T_TERMS)
    sl = 1 + 0.015 * l50**2 / math.sqrt(20 + l50**2)
    sc, sh = 1 + 0.045 * c, 1 + 0.015 * c * t
    turned = math.radians(60 * math.exp(-(((h - 275) / 25) ** 2)))
    rt = -2 * math.sqrt(c**7 / (c**7 + 25**7)) * math.sin(turned)
    return math.sqrt((dl / sl) ** 2 + (dc / sc) ** 2 + (dh / sh) ** 2 + rt * dc / sc * dh / sh)


T_TERMS = (-0.17, 1, -30), (0.24, 2, 0), (0.32, 3, 6), (-0.20, 4, -63)
