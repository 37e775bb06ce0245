"""Stamps: pieces of worlds as pictures in a folder of the player's, and on the clipboard."""

from functools import partial
from types import SimpleNamespace

from game.play.storage.clipboard import picture_there
from game.world.files.paths import save_named
from game.world.sand.clock import Clock
from game.world.sand.parameters import CELL, SPEED
from game.world.scenes.picture_file import Photo, open_picture, picture_bytes
from game.world.scenes.scene import Scene


class Stamps:
    """Keeps what was copied, and takes what was kept in hand."""

    def __init__(self, brush, photo_import, name_card, background, notices):
        self._brush, self._photo_import, self._name_card = brush, photo_import, name_card
        self._background, self._notices = background, notices

    def keep(self):
        """Ask for a name for the stamp that was copied, and keep it under that."""
        copied = self._brush.selection.copied
        self._name_card.ask("Keep as a stamp", "Stamp", partial(self._keep, copied))

    def take(self, path):
        """Take the stamp in a file in hand: a kept one, a saved scene, or any picture."""
        self._background.do(partial(open_picture, path), self._take)

    def take_picture(self):
        """Take the picture on the clipboard in hand, as a picture that is opened becomes materials."""
        self._background.do(picture_there, self._take)

    def _keep(self, copied, name):
        def work():
            return save_named("stamps", name or "Stamp", ".png", stamp_bytes(*copied))

        self._background.do(work, lambda path: self._notices.say(f"Kept as {path}"), writes=True)

    def _take(self, found):
        if isinstance(found, Photo):
            self._photo_import.show(found, self._hold)
        else:
            self._hold(found.scene)

    def _hold(self, scene):
        self._brush.selection.hold(scene)
        self._brush.choose("stamp")
        self._notices.say(f"{scene.name} is in your hand: each click puts it down. Esc lets go of it.")


def stamp_bytes(stamp, rule, made_of):
    """Return a PNG of a Stamp that was cut out of a world of a rule with such walls."""
    cells = {"cells": stamp.cells, "colours": stamp.colours, "fixtures": stamp.fixtures}
    scene = Scene("stamp", "Stamp", "", rule=rule, speed=SPEED.default, cell=CELL.default, made_of=made_of, **cells)
    return picture_bytes(SimpleNamespace(world=scene.world(), scene=scene, rule=rule, seed=0, clock=Clock(scene.speed)))
