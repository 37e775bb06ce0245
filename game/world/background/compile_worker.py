"""Compiles kernels in a process on another core, while the toy compiles others or already plays.

A thread would not do: compiling holds the interpreter's lock, so frames would be late while it lasts.
"""

import multiprocessing
import os
import signal
import sys
import threading
from contextlib import contextmanager
from multiprocessing import resource_tracker
from multiprocessing.connection import wait

from game.core import jit
from game.world.background import kernel_warmup


class CompileWorker:
    """Runs `compile_all(tell, *needs)` in a process of its own; it sends a word through `tell` after each step."""

    def __init__(self, compile_all, *needs):
        context = multiprocessing.get_context("spawn")
        self._hear, tell = context.Pipe(duplex=False)
        self._process = context.Process(target=_work_for_parent, args=(compile_all, tell, *needs), daemon=True)
        with _without_interrupts():
            self._process.start()
        self._closed = False
        tell.close()

    def beside(self, steps):
        """Return the worker's `steps` so that each waits until the worker has compiled it, and then only loads it."""
        return [(what, lambda act=act: self._wait() and act()) for what, act in steps]

    def close(self):
        """End the process; whoever waits for it goes on."""
        self._closed = True
        self._process.terminate()

    def _wait(self):
        """Wait until one more step is done, or the process has ended; in that case the waiting side compiles it."""
        try:
            self._hear.recv()
        except (EOFError, OSError):
            self._process.join()
        return not self._closed


@contextmanager
def _without_interrupts():
    """Let processes that are started meanwhile never hear Ctrl+C, which a terminal gives to all of them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # which would let them be heard again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work_for_parent(work, *arguments):
    """Call `work(*arguments)` as long as the process that wants it is alive."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    work(*arguments)


def _end_with_parent():
    wait([multiprocessing.parent_process().sentinel])
    os._exit(1)


class StepThread:
    """Does steps in a thread of its own. While it is at one the interpreter must not end: the compiler would crash."""

    def __init__(self, steps):
        self.steps, self.done = steps, 0
        self._stopped = False
        self._thread = threading.Thread(target=self._work, daemon=True)
        self._thread.start()

    def wait(self, timeout_s):
        """Wait for the end, but not longer than that; return whether it has come."""
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    def stop(self):
        """Leave the steps that have not begun, and do not wait for the one that has."""
        self._stopped = True

    def _work(self):
        for _, act in self.steps:
            if self._stopped:
                return
            act()
            self.done += 1


def steps_to_play(rule, walls, cell=1, coloured=False, fixtures=()):
    """Return the steps (what, act) to do before the first frame, those after it, and the CompileWorker or None.

    `kernel_warmup` says what they are. While the cache is new, a worker compiles all but the kernels that move sand.
    """
    own, later = kernel_warmup.moving_steps(rule, coloured, fixtures), kernel_warmup.later_steps(rule)
    drawing, worker = kernel_warmup.drawing_steps(rule, walls, cell), None
    if jit.NEW and not getattr(sys, "frozen", False):
        worker = CompileWorker(_compile, rule, walls, cell)
        drawing, later = worker.beside(drawing), worker.beside(later)
    return own + drawing, later, worker


def _compile(tell, rule, walls, cell):
    for what, act in (*kernel_warmup.drawing_steps(rule, walls, cell), *kernel_warmup.later_steps(rule)):
        act()
        tell.send(what)
