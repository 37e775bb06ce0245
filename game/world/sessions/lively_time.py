"""Lively time: a line of a session measured by the iterations in which anything moved; rest counts for nothing."""

import numpy as np

from game.world.sand import parameters


class LivelyTime:
    """Where the rests of a timeline's present line are, kept from frame to frame."""

    def __init__(self):
        self._known = None  # the last act and the number of rests that were known
        self._nows, self._lively = self._measured([], None)

    def follow(self, timeline):
        """Take in what was done, and what came to rest, since the last call."""
        known = timeline.history.line, timeline.rests
        if known == self._known:
            return
        acts = [*reversed(timeline.history.after(timeline.history.root))]
        before = [timeline.history.root, *acts]
        rests = [
            (one.rest_from, other.at) for one, other in zip(before, acts, strict=False) if one.rest_from is not None
        ]
        self._nows, self._lively = self._measured(rests, before[-1].rest_from)
        self._known = known

    def up_to(self, nows):
        """Return how many iterations up to one, or to each of an array, were lively: float64."""
        return np.interp(nows, self._nows, self._lively)

    def now_at(self, lively):
        """Return the iteration up to which so many were lively: after a rest, if there are several."""
        return round(float(np.interp(lively, self._lively, self._nows)))

    @staticmethod
    def _measured(rests, last):
        """Return iterations and how many of those before each were lively; between them both rise evenly.

        rests: (first iteration, iteration of the act that ended it). last: where the present rest begins, or None.
        """
        nows, lively = [0], [0]
        for start, end in rests:
            if start < end:
                lively += [lively[-1] + start - nows[-1]] * 2
                nows += [start, end]
        end = parameters.MOMENT.high if last is None else last
        return np.array([*nows, end], float), np.array([*lively, lively[-1] + end - nows[-1]], float)
