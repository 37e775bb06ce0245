"""Kernels are ready before the first frame."""

import subprocess
import sys

import numpy as np
import pytest

from game import Rule, World, advance, load_rule
from game.core import jit, step
from game.core.compiler.beside import run_beside
from game.world.background import kernel_warmup

SCRIPT = """
from game import headless
from game.core import step
from game.core.draw import cells
from game.core.loops.kernel import Kernel
from game.core.paint import primitives, strokes
from game.world.looks.painter import Painter
from game.world.scenes.scene import load_scene
from game.world.sessions.session import Session

rooms = strokes, primitives, cells, step
kernels = [each for room in rooms for each in vars(room).values() if isinstance(each, Kernel)]
assert len(kernels) > 3
count = lambda: sum(len(each.signatures) for each in kernels)

playing = set()  # the scenes that have begun their first frame

def watch(kind, name):
    work = getattr(kind, name)

    def watched(*told, **more):
        if kind is Session:
            playing.add(scene)
        before = count()
        done = work(*told, **more)
        assert count() == before or scene not in playing, (scene, name)
        return done

    setattr(kind, name, watched)

watch(Session, "frame")
watch(Session, "do")
watch(Painter, "draw")
for scene in ("fountain", "rainbow"):
    headless.run(load_scene(scene), 8)
assert len(playing) == 2
"""


def test_no_kernel_is_compiled_inside_a_frame():
    subprocess.run([sys.executable, "-c", SCRIPT], check=True, timeout=600)


def run_urgently(act, is_urgent):
    assert is_urgent, "the first frame waits for it"
    run_beside(act, is_urgent=True)


def not_again(*_):
    pytest.fail("it is compiled again")


not_again.__name__ = jit._compile_by_numba.__name__


def test_the_stepping_is_compiled_by_another_process_and_found_by_this_one(tmp_path, monkeypatch):
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / jit.folder().name)
    monkeypatch.setattr(kernel_warmup, "run_beside", run_urgently)
    kernel_warmup.make_stepping_beside()
    monkeypatch.setattr(kernel_warmup, "run_beside", lambda *_, **__: pytest.fail("it is made already"))
    kernel_warmup.make_stepping_beside()
    stepping = jit.numba_kernel(step.advance_bands.function)
    monkeypatch.setattr(jit, "_compile_by_numba", not_again)
    monkeypatch.setattr(step, "advance_bands", stepping)
    advance(World.from_cells(*np.zeros((2, 66, 2), bool)), Rule.with_p(0.5), 1)


@pytest.mark.parametrize("rule", kernel_warmup.KINDS.values())
def test_sand_is_moved_last_when_the_stepping_has_had_most_time(rule):
    (what, _) = kernel_warmup.steps(rule, "stone")[-1]
    assert kernel_warmup.KINDS[what] is rule


def test_where_no_other_process_can_be_the_stepping_is_left_to_this_one(tmp_path, monkeypatch):
    monkeypatch.setattr(jit, "_FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(sys, "executable", "")
    kernel_warmup.make_stepping_beside()
    assert not jit.is_kept(step.advance_bands)


@pytest.mark.parametrize("cell", [1 / 1000, 1 / 17, 0.4, 1, 20])
def test_drawing_is_made_ready_however_small_cells_are(cell):
    for _, act in kernel_warmup.drawing_steps(Rule(), "stone", cell):
        act()


@pytest.mark.parametrize("rule", [Rule(), Rule.with_p(0.5), Rule(*[0.5] * 7), load_rule("alchemy")])
def test_every_kind_of_sand_is_made_ready_plain_and_in_colours(rule):
    names = [what for what, _ in (*kernel_warmup.moving_steps(rule), *kernel_warmup.later_steps(rule))]
    for kind in kernel_warmup.KINDS:
        coloured = [what for what in names if what == f"{kind} of colours"] or names.count(kind) > 1
        assert coloured and (kind in names or not rule.codes.is_sand)
