"""Photo import: shows a photo as the sand that it would become, with a threshold to adjust."""

import numpy as np
import pygame

from game.play.ui.card import Card
from game.world.looks import painter
from game.world.looks.themes import substances_of
from game.world.looks.view import View
from game.world.scenes.picture_file import THRESHOLD

WIDTH = 360  # pixels at scale 1
TOP = 16
PICTURE_HEIGHT = 220
ANSWERS = {pygame.K_RETURN: True, pygame.K_KP_ENTER: True, pygame.K_ESCAPE: False}  # whether the photo is used


class PhotoImport:
    """The card with the photo that is being looked at, if any."""

    def __init__(self, sessions, display):
        self._sessions, self._display = sessions, display
        self._card = self._photo = self._found = None
        self._threshold, self._in_colours = THRESHOLD.default, True

    @property
    def shown(self):
        """Whether a photo is being looked at."""
        return self._card is not None

    @property
    def ui(self):
        """The controls."""
        return self._card.ui

    def let_go(self):
        """Let go of the control that is held."""
        if self.shown:
            self.ui.let_go()

    def show(self, photo):
        """Open the card with a Photo."""
        self._photo, self._threshold, self._in_colours = photo, THRESHOLD.default, True
        self._found = photo.picture(self._threshold, self._in_colours)
        self._card = Card(self._display.theme, WIDTH)
        self._display.refresh()

    def handle_events(self, events, now_s, mouse_pos):
        """Adjust the threshold, use the photo or cancel; return the events that are not the card's."""
        rest = self._card.lay_out(self._display, self._display.theme.px(TOP), events, now_s, mouse_pos)
        ui = self.ui
        ui.heading(f"{self._photo.path.name} as sand")
        self._room = ui.place(self._display.theme.px(PICTURE_HEIGHT), self._display.theme.px(8))
        threshold = ui.slider("Threshold", THRESHOLD, self._threshold, tip=None)
        in_colours = ui.toggle("In colours", self._in_colours, tip="Gives each grain the nearest sand colour")
        if (threshold, in_colours) != (self._threshold, self._in_colours):
            self._threshold, self._in_colours = threshold, in_colours
            self._found = self._photo.picture(threshold, in_colours)
        ui.row(2)
        used, cancelled = ui.button("Use", key="Enter"), ui.button("Cancel", key="Esc")
        keys = [event.key for event in rest if event.type == pygame.KEYDOWN and event.key in ANSWERS]
        if used or cancelled or keys:
            self._answer(used or (not cancelled and ANSWERS[keys[0]]))
        return [event for event in rest if not (event.type == pygame.KEYDOWN and event.key in ANSWERS)]

    def draw(self, surface, theme, area):
        """Draw the card with the photo as it would be; return the rects that it covers."""
        covered = self._card.draw(surface, theme)
        room = self._room.move(self._card.rect.topleft)
        sprite = _sprite(self._found.scene, room.size, theme.colours)
        surface.blit(sprite, sprite.get_rect(center=room.center))
        return covered

    def _answer(self, used):
        """Use the photo, or close the card without."""
        if used:
            self._sessions.slowly(f"Opening {self._photo.path.name} …", self._use)
        else:
            self._close()

    def _use(self):
        """Open the photo and close the card, unless the sand cannot give way to it yet."""
        if self.shown and self._sessions.open_scene(self._found.scene, self._found.seed):
            self._close()

    def _close(self):
        self._card = None
        self._display.refresh()


def _sprite(scene, size, colours):
    """Return the scene's cells as a surface that fits `size`."""
    world = scene.world()
    view = View.fit(scene.shape, 0, 0, *size)
    pixels = np.zeros((view.top * 2 + view.height, view.left * 2 + view.width), np.uint32)
    painter.Painter(view, colours, scene.made_of, substances=substances_of(scene.rule.definition.materials)).draw(
        world, pixels
    )
    part = np.ascontiguousarray(pixels[view.top : view.top + view.height, view.left : view.left + view.width])
    rgb = part.view(np.uint8).reshape(*part.shape, 4)[..., 2::-1]
    return pygame.image.frombuffer(rgb.tobytes(), part.shape[::-1], "RGB")
