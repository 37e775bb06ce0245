"""What frames took and what came of it, as means over a moment, so that they can be read."""

import time
from typing import NamedTuple

from game.world.sessions.session import BUDGET_NS

REFRESH_S = 0.25
FRAME_NS = 10**9 / 60  # from one frame to the next
FULL = BUDGET_NS / FRAME_NS  # of all time, what the sand and the window may take


class FrameTime(NamedTuple):
    """What one frame took, in ns by the wall and of this thread's own work, and its iterations."""

    work_ns: int
    own_ns: int  # without the time in which the machine did something else
    stepping_ns: int  # the part of it that moved sand
    due: int  # iterations that were wanted
    done: int


class Reading(NamedTuple):
    """The means over one moment."""

    seconds: float  # how long it was
    frames_per_second: float
    frame_ms: float  # of work
    done: float  # iterations per second that were run
    due: float  # … and that were wanted
    full: bool  # the iterations that were wanted are more work than there is time for

    @property
    def late(self):
        """Whether iterations were left out only because frames came late: the machine was busy elsewhere."""
        return self.done < self.due and not self.full


class FrameStats:
    """Gathers frames into readings, each with the books of the grains at that moment."""

    def __init__(self):
        self.frame_ns = 0  # of work, in the latest frame
        self.reading = None  # the latest
        self.account, self.grains = None, ()  # the books, and the grains of each colour that were counted
        self._frames, self._since_s = [], None

    def count(self, frame, session, now_s):
        """Take in the FrameTime of a frame of `session` at time now_s."""
        self.frame_ns = frame.work_ns
        self._frames.append(frame)
        self._since_s = now_s if self._since_s is None else self._since_s
        if now_s - self._since_s >= REFRESH_S:
            self.reading = read(self._frames, now_s - self._since_s)
            self.grains = session.world.amounts
            self.account = session.account.met(self.grains)
            self._frames, self._since_s = [], now_s


def read(frames, seconds):
    """Return the Reading of FrameTimes that were shown within so many seconds."""
    work_ns, own_ns, stepping_ns, due, done = (sum(column) for column in zip(*frames, strict=True))
    # a frame that comes late has more due than it can hold, and yet all of it may be little work
    needed_ns = own_ns - stepping_ns + stepping_ns * due / max(done, 1)
    full = done < due and needed_ns > FULL * seconds * 1e9
    return Reading(seconds, len(frames) / seconds, work_ns / len(frames) / 1e6, done / seconds, due / seconds, full)


def own_ns():
    """Return the nanoseconds that this thread has worked."""
    return time.thread_time_ns()
