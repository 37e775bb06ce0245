"""The loop: kernels are ready before its first frame."""

import time

from game.play import loop
from game.world.files.settings import Settings
from game.world.scenes.scene import load_scene


def test_sand_moves_only_once_the_stepping_was_compiled_beside(monkeypatch):
    done = []
    acts = [(what, lambda what=what: done.append(what)) for what in ("drawn", "moved")]
    monkeypatch.setattr(loop, "make_stepping_beside", lambda: time.sleep(0.3) or done.append("compiled"))
    monkeypatch.setattr(loop, "steps", lambda *_: acts)
    monkeypatch.setattr("pygame.quit", lambda: None)  # other tests go on with their fonts
    monkeypatch.setattr(loop, "_make_ready", lambda window, theme, worker: not worker.wait(20))
    loop.play(load_scene("hourglass"), Settings())
    assert done == ["drawn", "compiled", "moved"]
