"""The background: work that takes longer than a frame is done in threads, and its outcome heard between two frames."""

import queue
import threading
from functools import partial

from game.world.files.atomic import FileError

EXPECTED = FileError, OSError


class Background:
    """Threads at work, and what they have to say."""

    def __init__(self, sorry):
        """`sorry` is called with what to say of work that failed as work with files, or for want of memory, does."""
        self._sorry = sorry
        self._outcomes = queue.SimpleQueue()
        self._threads = []

    @property
    def busy(self):
        """Whether any work is not done, or its outcome not heard."""
        return any(thread.is_alive() for thread in self._threads) or not self._outcomes.empty()

    def do(self, work, then=None, otherwise=None):
        """Call `work()` in a thread, and then(its result), or otherwise() if it failed, at the next `update` after it."""

        def run():
            act = otherwise
            try:
                result = work()
                act = then and partial(then, result)
            except EXPECTED as error:
                self._outcomes.put(partial(self._sorry, error))
            except MemoryError:
                self._outcomes.put(partial(self._sorry, "There is not enough memory for that."))
            finally:
                if act:
                    self._outcomes.put(act)

        thread = threading.Thread(target=run, daemon=True)
        self._threads = [*(each for each in self._threads if each.is_alive()), thread]
        thread.start()

    def update(self):
        """Act on the outcomes so far."""
        while not self._outcomes.empty():
            self._outcomes.get()()

    def finish(self):
        """Wait for what is being written; nothing comes of it any more, for what would hear of it is gone."""
        for thread in self._threads:
            thread.join()
        self._outcomes = queue.SimpleQueue()
