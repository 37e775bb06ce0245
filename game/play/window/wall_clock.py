"""The wall clock: seconds that go on while the computer sleeps, as those on a wall do."""

import time

# Linux counts the time asleep in a clock that nobody can set. Elsewhere the time of day is the one that surely does.
if hasattr(time, "CLOCK_BOOTTIME"):

    def wall_clock():
        """Return seconds since the computer was started, those asleep included."""
        return time.clock_gettime(time.CLOCK_BOOTTIME)

else:
    wall_clock = time.time
