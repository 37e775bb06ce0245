"""The companion: a process that compiles kernels on another core, while the toy compiles others or already plays.

A thread would not do: compiling holds the interpreter's lock, so that frames come late for as long as it lasts.
"""

import multiprocessing
import sys

from game.core import jit
from game.world import prepare


class Companion:
    """Runs `compile_all(tell, *needs)` in a process of its own; it sends something through `tell` after each step."""

    def __init__(self, compile_all, *needs):
        context = multiprocessing.get_context("spawn")
        self._hear, tell = context.Pipe(duplex=False)
        self._process = context.Process(target=compile_all, args=(tell, *needs), daemon=True)
        self._process.start()
        tell.close()

    def beside(self, steps):
        """Return `steps`, the companion's, so that each first waits until it is compiled, and then only loads it."""
        return [(what, lambda act=act: (self._wait(), act())) for what, act in steps]

    def _wait(self):
        """Wait until one more step is done, or the companion has ended: then who waited compiles for itself."""
        try:
            self._hear.recv()
        except (EOFError, OSError):
            self._process.join()


def steps_to_play(rule, walls, dense=False, coloured=False):
    """Return the steps (what, act) to do before the first frame, and those after it; `prepare` says what they are.

    While the cache is new, a companion compiles what comes after the kernels that move sand.
    """
    own, later = prepare.moving_steps(rule, coloured), prepare.later_steps(rule)
    drawing = prepare.drawing_steps(walls, dense, coloured)
    if jit.NEW and not getattr(sys, "frozen", False):
        companion = Companion(_compile, rule, walls, dense, coloured)
        drawing, later = companion.beside(drawing), companion.beside(later)
    return own + drawing, later


def _compile(tell, rule, walls, dense, coloured):
    for what, act in (*prepare.drawing_steps(walls, dense, coloured), *prepare.later_steps(rule)):
        act()
        tell.send(what)
