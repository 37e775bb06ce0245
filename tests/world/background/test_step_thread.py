"""Steps beside the frames are done in turn, or left."""

import time

from game.world.background.step_thread import StepThread


def test_a_stopped_worker_ends_the_step_it_is_at_and_begins_no_other():
    seen = []
    worker = StepThread([("a step", lambda: (time.sleep(0.1), seen.append(1)))] * 3)
    time.sleep(0.02)
    worker.stop()
    assert worker.wait(9) and seen == [1]
