"""The portrait: an hourglass that runs out and is turned over, for ever, as a GIF. The README shows it first.

`python -m game.play.trials.readme_gif OUT.gif` makes the same file again, byte for byte; no window is needed.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

from game.play.storage.films.film_file import FilmFile
from game.play.storage.films.gif import GifEncoder
from game.play.view.turn_animation import TURN_S, TurnAnimation
from game.world.files.atomic import FileError
from game.world.looks.motion_samples import MotionSamples
from game.world.looks.painter import Painter
from game.world.looks.themes import AIR, NIGHT, rgb
from game.world.looks.view import View
from game.world.sand.advance import advance
from game.world.scenes.scene import load_scene

SCENE = "hourglass"
CELL = 2  # pixels
MARGIN = 4  # pixels around the lattice
FRAME_MS = 50
ITERATIONS = 80  # in a frame: the sand of a minute in a few seconds
SINGLY = 4  # of them are run one by one, so that the stream is their mean
REST_MS = 600  # before the glass is turned


def frames():
    """Yield (pixels, milliseconds) of one round: from a glass just turned over to the next; pixels: 0xRRGGBB."""
    scene = load_scene(SCENE)
    world = scene.world()
    _run_out(world, scene.rule)
    world.flip()
    sand_view = PictureStage(scene)
    while not world.activity.settled:
        for iterations in (ITERATIONS - SINGLY, *[1] * SINGLY):
            advance(world, scene.rule, iterations)
            sand_view.streams.note(world)
        yield sand_view.shown(world), FRAME_MS
    yield sand_view.shown(world), REST_MS
    for number in range(1, round(TURN_S * 1000 / FRAME_MS)):
        yield sand_view.turned(number * FRAME_MS / 1000), FRAME_MS


class PictureStage:
    """The frame that the glass stands in."""

    def __init__(self, scene):
        height, width = (CELL * side for side in scene.shape)
        side = height + 2 * MARGIN
        self.view = View(scene.shape, (side - width) // 2, MARGIN, width, height)
        self.streams = MotionSamples()
        self._painter = Painter(self.view, NIGHT, scene.made_of)
        self._air = np.uint32(rgb(*NIGHT.air[AIR].dark))
        self._pixels = np.full((side, side), self._air)

    def shown(self, world):
        """Return a frame of the world as it is."""
        self._painter.draw(world, self._pixels, streams=self.streams)
        left, top, right, bottom = self.view.seen
        for edge in (left, right - CELL):  # the lattice's border is none of the glass's
            self._pixels[top:bottom, edge : edge + CELL] = self._air
        for edge in (top, bottom - CELL):
            self._pixels[edge : edge + CELL, left:right] = self._air
        return self._pixels.copy()

    def turned(self, after_s):
        """Return a frame of the picture on its way round."""
        pixels, side = self._pixels.copy(), len(self._pixels)
        TurnAnimation(self._pixels, 0.0).draw(pixels, self._air, (0, 0, side, side), after_s)
        return pixels


def _run_out(world, rule):
    while not world.activity.settled:
        advance(world, rule, ITERATIONS)


def make(path):
    """Write the portrait to a GIF; raise FileError where that fails."""
    film = list(frames())
    colours = np.unique(np.concatenate([np.unique(pixels) for pixels, _ in film]))
    palette = np.stack([colours >> 16 & 255, colours >> 8 & 255, colours & 255], axis=-1).astype(np.uint8)
    gif = FilmFile(lambda number: path, GifEncoder(palette.tobytes()))
    for pixels, ms in film:
        gif.add(np.searchsorted(colours, pixels).astype(np.uint8), ms)
    gif.close(replace=True)
    return len(film), len(colours)


def main():
    """Make the portrait that the command line asks for."""
    parser = argparse.ArgumentParser(prog="python -m game.play.trials.readme_gif", description=__doc__.splitlines()[0])
    parser.add_argument("out", type=Path, metavar="OUT.gif")
    try:
        print("{} frames in {} colours".format(*make(parser.parse_args().out)))
    except FileError as error:
        sys.exit(f"sandglass: {error}")


if __name__ == "__main__":
    main()
