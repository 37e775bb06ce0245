"""Seams: the spare word at the end of each row of a plane of even columns, while an iteration with odd x runs."""

import numpy as np

from game.core.jit import gate

_ONE = np.uint64(1)


@gate
def open_seam(planes, seam, words):
    """Give a row's last word its right-hand neighbours; seam: its place, `words` after the row's first."""
    planes[seam] = planes[seam - words] >> _ONE


@gate
def close_seam(planes, seam, words):
    """Take what the iteration made of a seam back into the row's first word; column 0 belonged to no block."""
    planes[seam - words] = (planes[seam] << _ONE) | (planes[seam - words] & _ONE)


@gate
def open_seams(planes, start, rows, stride):
    """Open the seams of the `rows` rows from `start`, in a plane of even columns."""
    words = np.uint64(stride - 1)
    for row in range(rows):
        open_seam(planes, start + np.uint64(row * stride) + words, words)


@gate
def close_seams(planes, start, rows, stride):
    """Close the seams of the `rows` rows from `start`, in a plane of even columns."""
    words = np.uint64(stride - 1)
    for row in range(rows):
        close_seam(planes, start + np.uint64(row * stride) + words, words)
