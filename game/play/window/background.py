"""The background: runs work that takes longer than a frame in threads, and its callbacks between two frames."""

import queue
import threading
from functools import partial

from game.world.files.atomic import FileError

EXPECTED = FileError, OSError


class Background:
    """Threads at work, and the callbacks that wait for the next frame."""

    def __init__(self, report):
        """`report(error)` is called where work failed on a file or for lack of memory."""
        self._report = report
        self._callbacks = queue.SimpleQueue()
        self._threads = []

    @property
    def busy(self):
        """Whether any work goes on, or a callback waits."""
        return any(thread.is_alive() for thread in self._threads) or not self._callbacks.empty()

    def do(self, work, then=None, otherwise=None):
        """Call `work()` in a thread; at the next `update` call then(its result), or otherwise() if it failed."""

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

        thread = threading.Thread(target=run, daemon=True)
        self._threads = [*(each for each in self._threads if each.is_alive()), thread]
        thread.start()

    def update(self):
        """Call the callbacks of all work that is done."""
        while not self._callbacks.empty():
            self._callbacks.get()()

    def finish(self):
        """Wait for all work, and drop its callbacks: those they would tell are gone."""
        for thread in self._threads:
            thread.join()
        self._callbacks = queue.SimpleQueue()
