"""The keeper of the settings: what changes in the window is saved a moment later, beside the frames."""

from functools import partial

SOON_S = 1.0  # a slider that is dragged is saved once, not at each step


class Keeper:
    """Watches the settings, and the values of the window that are remembered without being settings of anything."""

    def __init__(self, toy):
        self._toy = toy
        self._since_s = None  # since when something is to be saved
        self._saving = False
        self._size = toy.window.size
        settings = toy.settings
        toy.brush.diameter = settings["brush"]
        toy.sessions.now.limit_memory(settings["memory"])
        if settings.problem:
            toy.notices.say(settings.problem, trouble=True)

    def update(self, now_s):
        """Note what changed, and save it once it is a while ago."""
        toy, settings = self._toy, self._toy.settings
        settings["brush"], settings["memory"] = toy.brush.diameter, round(toy.sessions.now.memory_mb)
        if toy.window.size != self._size and not toy.window.fullscreen:
            self._size = settings["window_width"], settings["window_height"] = toy.window.size
        if not settings.unsaved:
            self._since_s = None
        elif self._since_s is None:
            self._since_s = now_s
        elif now_s - self._since_s >= SOON_S and not self._saving:
            self._since_s, self._saving = None, True
            toy.background.do(partial(self._save, settings.take_unsaved()))

    def close(self):
        """Save what is left, and what could not be saved before."""
        if self._toy.settings.unsaved or self._toy.settings.owed:
            self._toy.background.do(self._toy.settings.take_unsaved())

    def _save(self, save):
        try:
            save()
        finally:
            self._saving = False
