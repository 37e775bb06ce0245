"""What is freed does not stay with the process; what lasts is not looked through again."""

import subprocess
import sys

import pytest

HOLES = """
import threading
import numpy as np
from game.play.window.allocator import return_freed_memory, resident_mb
assert return_freed_memory()
def work():  # as forecasts and planners do: large arrays that go, beside small ones that stay
    for number in range(12):
        large = [np.ones(rng.integers(2**18, 2**20)) for _ in range(4)]
        kept.append(np.ones(100))
rng, kept = np.random.default_rng(1), []
before = resident_mb()
threads = [threading.Thread(target=work) for _ in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(resident_mb() - before)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="other systems give back by themselves")
def test_large_arrays_of_many_threads_leave_no_holes_behind():
    said = subprocess.run([sys.executable, "-c", HOLES], capture_output=True, text=True, check=True)
    assert float(said.stdout) < 20


SMALL_ONES = """
import numpy as np
from game.play.storage.journals import Journals
from game.play.storage.open_sessions import Sessions
from game.play.view.notices import Notices
from game.play.window.allocator import return_freed_memory, resident_mb
from game.world.scenes.scene import load_scene
from game.world.sessions.session import Session

return_freed_memory()
sessions = Sessions(Session(load_scene("hourglass"), 0), Journals(print), Notices(lambda: None), lambda: None)
sessions.load("clocks")
mixed = [np.ones(size) for _ in range(1000) for size in (8000, 100)]  # 64 MB, as snapshots are, among what stays
del mixed[::2]
before = resident_mb()
sessions.load("ledges")
print(before - resident_mb())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="other systems give back by themselves")
def test_another_scene_leaves_no_holes_where_the_past_of_the_last_one_was():
    said = subprocess.run([sys.executable, "-c", SMALL_ONES], capture_output=True, text=True, check=True)
    assert float(said.stdout.split()[-1]) > 40


LASTING = """
import gc
import pygame
from game.play.loop import run
from game.world.background.step_thread import StepThread

class ShortGame:
    running = at_rest = hidden = True
    parts = window = property(lambda self: self)
    def frame(self, *_):
        self.running = False

pygame.display.init()
lasting = [[] for _ in range(300_000)]
ready = StepThread([])
assert ready.wait(10)
run(ShortGame(), ready)
assert len(gc.get_objects()) < 1000  # those that a full pass looks through
"""


def test_a_full_pass_of_the_garbage_collector_is_short_once_all_is_ready():
    subprocess.run([sys.executable, "-c", LASTING], check=True)


LEFT = """
import gc
import pygame
from game.play.window.allocator import freeze_objects
from game.world.sessions import timeline
from game.world.files.paths import asset
from game.world.sessions.snapshots import Snapshot
from tests.play.player import Player

pygame.font.init()
timeline.SPACING_NS, timeline.SHARE = 1, 0  # a snapshot wherever there may be one
player = Player("fountain")
freeze_objects()
for _ in range(50):
    player.session.timeline.run(50)
left = player.session.timeline.snapshots
assert len(left) >= 50
player.drop(sorted(asset("replays").glob("*.sandglass"))[0])
player.settle()
assert player.session.timeline.snapshots is not left
gc.collect()
kept = sum(isinstance(each, Snapshot) for each in gc.get_objects())
assert kept <= len(player.session.timeline.snapshots), kept
"""


def test_a_session_that_nobody_returns_to_leaves_no_snapshots():
    subprocess.run([sys.executable, "-c", LEFT], check=True)
