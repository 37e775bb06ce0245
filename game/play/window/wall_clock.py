"""The wall clock: seconds that go on while the computer sleeps."""

import time

# On Linux nobody can set this clock, and it counts time asleep. Elsewhere only the time of day surely does.
if hasattr(time, "CLOCK_BOOTTIME"):

    def wall_clock():
        """Return seconds since the computer was started, those asleep included."""
        return time.clock_gettime(time.CLOCK_BOOTTIME)

else:
    wall_clock = time.time
