"""What is freed does not stay with the process."""

import subprocess
import sys

import pytest

HOLES = """
import threading
import numpy as np
from game.play.memory import give_back_freed, resident_mb
assert give_back_freed()
def work():  # as forecasts and planners do: large arrays that go, beside small ones that stay
    for number in range(40):
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
