"""A step that a companion compiles is done here after it is done there, and in any case."""

import time

import pytest

from game.world.background.compile_worker import CompileWorker, StepThread


def note(tell, path):
    """Do two steps and leave a line of each in a file."""
    for word in ("one", "two"):
        time.sleep(0.05)
        with open(path, "a", encoding="utf-8") as file:
            file.write(f"{word}\n")
        tell.send(word)


def give_up(tell, path):
    """End before the first step is done."""


@pytest.mark.parametrize(("work", "there"), [(note, ["one", "one two"]), (give_up, ["", ""])])
def test_each_step_waits_for_the_companion_or_its_end(work, there, tmp_path):
    path = tmp_path / "steps"
    path.touch()
    seen = []
    companion = CompileWorker(work, path)
    for _, act in companion.beside([(word, lambda: seen.append(" ".join(path.read_text().split()))) for word in "ab"]):
        act()
    assert len(seen) == 2 and all(now.startswith(then) for now, then in zip(seen, there, strict=True))


def never(tell, path):
    """Send nothing, for longer than the test may take."""
    time.sleep(600)


def test_who_waits_for_a_companion_is_let_go_and_compiles_nothing(tmp_path):
    companion, seen = CompileWorker(never, tmp_path), []
    worker = StepThread(companion.beside([("a step", lambda: seen.append(1))] * 2))
    assert not worker.wait(0.05)
    companion.close()
    worker.stop()
    assert worker.wait(9) and not seen


def test_a_stopped_worker_ends_the_step_it_is_at_and_begins_no_other():
    seen = []
    worker = StepThread([("a step", lambda: (time.sleep(0.1), seen.append(1)))] * 3)
    time.sleep(0.02)
    worker.stop()
    assert worker.wait(9) and seen == [1]
