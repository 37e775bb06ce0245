"""Narrower passes: made for the materials that are together where most of the work is, beside what goes on.

A pass of a large rule is mostly gates for materials that are not there. So `dispatch` counts which sets of materials
runs of words hold, and where their gates have cost about as much time as making a pass for such a set takes, one is
made, in a process beside this one. The cells are the same with any passes.
"""

from contextlib import suppress
from threading import Thread
from typing import NamedTuple

import numpy as np

from game.core.compiler.beside import Call, giving_way, run_beside
from game.core.compiler.dispatch import MOST, NOTHING, RUN, cheapest, eventful

LEAST_GATES = 250  # of a rule for which looking at the materials pays
GATE_S = 0.4e-9  # what a gate costs on one vector of words, about
MADE_S, MADE_GATE_S = 0.01, 0.2e-3  # what it may have cost before a pass is made, and for each of its gates
ASKED = 4  # a look at what was counted for so many times that the passes are asked for
WEIGHED = 128  # sets that are weighed against each other, those with most work


class Known(NamedTuple):
    """The passes of a rule so far."""

    made: tuple  # of made passes; the first knows all codes
    sets: tuple  # the codes that each one knows, as bits of a number
    numbers: np.ndarray  # (2**codes,) uint8: which one to call for a set of codes, see `dispatch.cheapest`


class NarrowPasses:
    """The passes of one rule, and what the dispatch counts of its runs."""

    def __init__(self, table, whole, make, kept):
        """whole: the made pass for all codes, with its `gates`, `lanes` and machine `code`.

        make(codes) makes one for some codes, and keeps it; it can be pickled. kept(codes) returns what was kept so, or
        None.
        """
        self._codes, self._make, self._kept, self._eventful = table.codes, Call(make), kept, eventful(table)
        self.tally = np.zeros(2**table.codes, np.uint32)
        self.known = None  # replaced when there is one more
        self._know((whole,), (2**table.codes - 1,))
        self._asked, self._thread = 0, None  # the one that waits for the process that makes a pass
        self._tried = []  # sets of codes, as bits of numbers, for which a pass was made or could not be

    def look(self):
        """Have a narrower pass made if one has paid by now; of many calls, few do more than count."""
        self._asked += 1
        if self._asked % ASKED or (self._thread and self._thread.is_alive()):
            return
        best = self._best()
        if best:
            self._tried.append(best)
            codes = tuple(code for code in range(self._codes) if best >> code & 1)
            self._thread = Thread(target=self._narrow_beside, args=[codes], daemon=True)
            self._thread.start()

    def wait(self):
        """Wait for the pass that is being made, if one is."""
        if self._thread:
            self._thread.join()

    def _narrow_beside(self, codes):
        """Take the pass for some codes if it was kept, or have a process make it; if none can the whole one goes on."""
        if not self._take(codes):
            with suppress(OSError):
                run_beside(self._make, codes)
                self._take(codes)

    def _take(self, codes):
        """Know the pass for some codes that was kept; return whether one was."""
        with giving_way():
            kept = self._kept(codes)
            self._add(codes, kept)
        return kept is not None

    def _add(self, codes, new):
        """Know the pass for some codes, if it could be made: code that disagrees with its table is not kept."""
        made, sets, _ = self.known
        number = sum(1 << code for code in codes)
        if new and number not in sets and len(made) < MOST:
            self._know((*made, new), (*sets, number))

    def _know(self, made, sets):
        self.known = Known(made, sets, cheapest(sets, [each.gates for each in made], self._eventful))

    def _best(self):
        """Return the set for which a pass would have saved the most time, 0 if that is less than making it takes."""
        made, _, numbers = self.known
        sets = np.flatnonzero((self.tally > 0) & (numbers != NOTHING))
        costs = np.array([each.gates for each in made])[numbers[sets]]
        most = np.argsort(self.tally[sets] * (costs - self._guessed(sets)).clip(0))[-WEIGHED:]
        sets, costs = sets[most], costs[most]
        guessed = self._guessed(sets)
        within = sets & ~sets[:, None] == 0  # by candidate: which of the sets it would do for
        saved = (within * self.tally[sets] * (costs - guessed[:, None]).clip(0)).sum(axis=1)
        paid = saved * GATE_S * RUN / made[0].lanes - MADE_S - MADE_GATE_S * guessed
        paid[np.isin(sets, self._tried)] = 0
        return int(sets[paid.argmax()]) if len(made) < MOST and paid.max(initial=0) > 0 else 0

    def _guessed(self, sets):
        """Return about how many gates passes for sets of codes have: those for pairs of materials are the most."""
        return self.known.made[0].gates * (np.bitwise_count(sets) / self._codes) ** 2
