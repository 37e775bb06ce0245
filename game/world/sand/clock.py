"""The clock: turns the time of uneven frames into whole iterations, without losing or adding any."""

NS_PER_S = 10**9
STALL_NS = NS_PER_S // 4  # a longer gap (a dragged window, a sleeping laptop) counts as this: no jump follows
_PARTS = 1000  # speeds are kept in thousandths of an iteration per second, so that the sums are whole numbers


class Clock:
    """Turns elapsed time into iterations that are due, at `speed` iterations per second."""

    def __init__(self, speed):
        self.speed = speed
        self._credit = 0  # what is left of an iteration, in 1 / (_PARTS · NS_PER_S)

    def due(self, elapsed_ns):
        """Return how many iterations fell due in `elapsed_ns` nanoseconds (int) since the last call.

        Time that runs backwards counts as none, time past STALL_NS as STALL_NS.
        """
        elapsed_ns = min(max(elapsed_ns, 0), STALL_NS)
        self._credit += elapsed_ns * round(self.speed * _PARTS)
        iterations, self._credit = divmod(self._credit, _PARTS * NS_PER_S)
        return iterations
