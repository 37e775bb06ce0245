"""The settings saver: what changes in the window is saved a moment later, beside the frames."""

from functools import partial

DELAY_S = 1.0  # a slider that is dragged is saved once, not at each step


class SettingsSaver:
    """Watches the settings, and the brush, memory and window size that are remembered with them."""

    def __init__(self, settings, sessions, brush, window, background, notices):
        self._settings, self._sessions, self._brush, self._window = settings, sessions, brush, window
        self._background = background
        self._since_s = None  # since when something is unsaved
        self._saving = False
        self._size = window.size
        brush.diameter = settings["brush"]
        sessions.now.limit_memory(settings["memory"])
        if settings.problem:
            notices.say(settings.problem, trouble=True)

    def update(self, now_s):
        """Note what changed, and save it once it is a while ago."""
        settings, window = self._settings, self._window
        settings["brush"], settings["memory"] = self._brush.diameter, round(self._sessions.now.memory_mb)
        if window.size != self._size and not window.fullscreen:
            self._size = settings["window_width"], settings["window_height"] = window.size
        if not settings.unsaved:
            self._since_s = None
        elif self._since_s is None:
            self._since_s = now_s
        elif now_s - self._since_s >= DELAY_S and not self._saving:
            self._since_s, self._saving = None, True
            self._background.do(partial(self._save, settings.take_unsaved()), writes=True)

    def close(self):
        """Save what is left, and what could not be saved before."""
        if self._settings.unsaved or self._settings.owed:
            self._background.do(self._settings.take_unsaved(), writes=True)

    def _save(self, save):
        try:
            save()
        finally:
            self._saving = False
