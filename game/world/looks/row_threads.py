"""Rows of a picture drawn by several threads at once, where there are enough of them and processors for it."""

import os
from concurrent.futures import ThreadPoolExecutor, wait
from functools import lru_cache

THREADS = min(4, os.cpu_count() or 1)
LEAST_PIXELS = 2**17  # for each thread: to hand less over would take as long as to draw it


def draw_rows(draw, top, bottom, width):
    """Call `draw(number, first, last)` for numbered parts of the rows from `top` to before `bottom`, at once.

    Meanwhile `draw` should let go of the interpreter's lock.
    """
    parts = max(1, min(THREADS, (bottom - top) * width // LEAST_PIXELS))
    edges = [top + (bottom - top) * number // parts for number in range(parts + 1)]
    others = [_threads().submit(draw, number, *edges[number : number + 2]) for number in range(1, parts)]
    try:
        draw(0, *edges[:2])
    finally:
        wait(others)
    for other in others:
        other.result()


@lru_cache(maxsize=1)
def _threads():
    return ThreadPoolExecutor(max(1, THREADS - 1), "drawing")
