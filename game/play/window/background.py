"""The background: runs work that takes longer than a frame in threads, and its callbacks between two frames."""

import queue
import threading
from contextlib import suppress
from functools import partial

import pygame

from game.world.files.atomic import FileError

EXPECTED = FileError, OSError


class Background:
    """Threads at work, and the callbacks that wait for the next frame."""

    def __init__(self, report):
        """`report(error)` is called where work failed on a file or for lack of memory."""
        self._report = report
        self._callbacks = queue.SimpleQueue()
        self._threads, self._writers = [], []

    @property
    def busy(self):
        """Whether any work goes on, or a callback waits."""
        return any(thread.is_alive() for thread in self._threads) or not self._callbacks.empty()

    def do(self, work, then=None, otherwise=None, writes=False):
        """Call `work()` in a thread; at the next `update` call then(its result), or otherwise() if it failed.

        `writes`: it writes a file, and so is waited for at the end.
        """

        def run():
            callback = otherwise
            try:
                result = work()
                callback = then and partial(then, result)
            except EXPECTED as error:
                self._callbacks.put(partial(self._report, error))
            except MemoryError:
                self._callbacks.put(partial(self._report, "Not enough memory for that."))
            finally:
                if callback:
                    self._callbacks.put(callback)
                with suppress(pygame.error):  # no window is open
                    pygame.event.post(pygame.event.Event(pygame.USEREVENT))  # the next frame may wait for an event

        thread = threading.Thread(target=run, daemon=True)
        self._threads = [*(each for each in self._threads if each.is_alive()), thread]
        if writes:
            self._writers = [*(each for each in self._writers if each.is_alive()), thread]
        thread.start()

    def update(self):
        """Call the callbacks of all work that is done."""
        while not self._callbacks.empty():
            self._callbacks.get()()

    def finish(self):
        """Wait for what writes, leave the rest alone, and drop all callbacks: those they would tell are gone."""
        for thread in self._writers:
            thread.join()
        self._callbacks = queue.SimpleQueue()
