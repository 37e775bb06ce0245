"""Does steps beside the frames, each of which makes something ready that they will need."""

import threading

from game.core.compiler.beside import giving_way


class StepThread:
    """Does steps (what, act) in a thread of its own.

    While it is at one the interpreter must not end: the compiler would crash.
    """

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
        with giving_way():
            for _, act in self.steps:
                if self._stopped:
                    return
                act()
                self.done += 1
