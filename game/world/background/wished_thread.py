"""A thread that works on what was wished last: it begins with the first wish and ends when it is closed."""

import threading


class WishedThread:
    """What threads of wishes share: `_work` runs in the thread, `_drop` forgets what is wished."""

    name = ""  # of the thread

    def __init__(self):
        self._bell = threading.Condition()
        self._thread = None
        self._closed = False

    def _wake(self):
        """Wake the thread, which is begun if there is none; `_bell` is held meanwhile."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._work, name=self.name, daemon=True)
            self._thread.start()
        self._bell.notify()

    def close(self):
        """Drop everything and end the thread; a later wish begins another."""
        with self._bell:
            self._closed = True
            self._drop()
            self._bell.notify()
        if self._thread:
            self._thread.join()
        self._thread, self._closed = None, False
