"""The window's glass: the first scene in cells that suit the window, poured anew when that grows.

Only while the player has not touched it: what somebody has made is never replaced.
"""

from game.world.scenes.fine_glass import fine_glass
from game.world.sessions.session import Session

REST_S = 0.3  # for which the window's size stays as it is before the glass follows it


class WindowGlass:
    """Watches the window while the session that began with a glass is as it was at the start."""

    def __init__(self, sessions, display, journals, brush, notices, is_busy):
        """`is_busy()` returns whether something goes on that another lattice would end."""
        self._sessions, self._display, self._journals = sessions, display, journals
        self._brush, self._notices, self._is_busy = brush, notices, is_busy
        self._base = self._session = None  # the scene in its own cells, and the session of it, while it is watched
        self._size, self._since_s = None, None  # of the window, and since when it has been so; None: it was seen to

    def follow(self, base, brush_too):
        """Watch the session that is played, of the scene `base` in fine cells; let the brush suit them, too."""
        self._base, self._session, self._size = base, self._sessions.now, self._display.window.size
        if brush_too:
            self._brush.diameter = round(self._brush.diameter * self._session.scene.shape[0] / base.shape[0])

    def update(self, now_s):
        """Pour the glass anew, if the window has grown and it is still untouched."""
        if self._base is None:
            return
        if not self._untouched():
            self._base = self._session = None
        elif self._size != self._display.window.size:
            self._size, self._since_s = self._display.window.size, now_s
        elif self._since_s is not None and now_s - self._since_s >= REST_S:
            self._since_s = None
            self._pour(fine_glass(self._base, self._display.room))

    def _untouched(self):
        session = self._sessions.now
        is_own = session is self._session and not self._sessions.can_leave
        return is_own and session.timeline.history.line.before is None and session.clock.speed == session.scene.speed

    def _pour(self, scene):
        if scene.shape[0] <= self._session.scene.shape[0] or self._session.paused or self._is_busy():
            return
        self._session = Session(scene, self._session.seed)
        self._journals.begin(self._session, [])
        self._sessions.open(self._session)
        self._notices.say("The window has grown: the glass is poured anew, in finer cells.")
