"""Kernels are ready before the first frame."""

import subprocess
import sys

SCRIPT = """
from game import headless
from game.core import step
from game.core.draw import cells
from game.core.paint import primitives, strokes
from game.world.scenes.scene import load_scene

rooms = strokes, primitives, cells, step
kernels = [each for room in rooms for each in vars(room).values() if hasattr(each, "signatures")]
assert len(kernels) > 3
count = lambda: sum(len(each.signatures) for each in kernels)
frame = headless._frame

def watched(*told, **more):
    before = count()
    taken = frame(*told, **more)
    assert count() == before, name
    return taken

headless._frame = watched
for name in ("hourglass", "fountain", "rainbow"):
    headless.run(load_scene(name), 8)
"""


def test_no_kernel_is_compiled_inside_a_frame():
    subprocess.run([sys.executable, "-c", SCRIPT], check=True, timeout=600)
