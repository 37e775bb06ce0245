"""Photo import: shows a photo as the sand that it would become, with a threshold and materials to choose."""

from typing import NamedTuple

import pygame

from game.play.ui.card import Card
from game.play.view.scene_picture import sprite_of
from game.world.sand.material_codes import WALL_NAME
from game.world.scenes.picture_file import THRESHOLD, PhotoFilling

PICTURE_HEIGHT = 220


class _Choice(NamedTuple):
    """What the photo is to become, as `Photo.picture` takes it."""

    threshold: float
    in_colours: bool
    filling: PhotoFilling | None  # under a rule of other materials than sand


class PhotoImport(Card):
    """The card with the photo that is being looked at, if any."""

    def __init__(self, sessions, display):
        super().__init__(display)
        self._sessions = sessions
        self._photo = self._found = self._choice = None
        self._on_use = None  # called with the Scene that the photo has become, in place of opening it

    def show(self, photo, on_use=None):
        """Open the card with a Photo; on_use(scene) is called with what it has become, else that is opened."""
        self._on_use = on_use
        rule = self._sessions.now.rule
        self._photo, filling = photo, None
        if not rule.codes.is_sand:
            filling = PhotoFilling(rule, rule.codes.usual, WALL_NAME)
        self._choice = _Choice(photo.threshold, True, filling)
        self._found = photo.picture(*self._choice)
        self._open()

    def handle_events(self, events, now_s, mouse_pos):
        """Adjust the threshold, use the photo or cancel; return the events that are not the card's."""
        rest = self._lay_out(events, now_s, mouse_pos)
        ui = self.ui
        filling = self._choice.filling
        ui.heading(f"{self._photo.path.name} as {'materials' if filling else 'sand'}")
        room = ui.place(self._display.theme.px(PICTURE_HEIGHT), self._display.theme.px(8))
        choice = self._chosen(ui)
        if choice != self._choice:
            self._choice, self._found = choice, self._photo.picture(*choice)
        ui.stroke(_picture, room, self._found.scene)
        used, rest = self._answer_row("Use", rest)
        if used is not None:
            self._answer(used)
        return rest

    def _chosen(self, ui):
        """Return the choice as the controls have it."""
        threshold, in_colours, filling = self._choice
        default = self._photo.threshold
        threshold = ui.slider("Threshold", THRESHOLD, threshold, default=default, tip=None)
        if not filling:
            in_colours = ui.toggle("In colours", in_colours, tip="Gives each grain the nearest sand colour")
            return _Choice(threshold, in_colours, filling)
        names = [each.name for each in filling.rule.definition.materials if each.form_of is None]
        words = [name.capitalize() for name in names]
        bright = names[ui.choice("Bright is", words, names.index(filling.bright))]
        between = names[ui.choice("Half as bright is", words, names.index(filling.between))]
        return _Choice(threshold, in_colours, filling._replace(bright=bright, between=between))

    def _answer(self, used):
        """Use the photo, or close the card without."""
        if used:
            self._sessions.slowly(f"Opening {self._photo.path.name} …", self._use)
        else:
            self._close()

    def _use(self):
        """Open the photo and close the card, unless the sand cannot give way to it yet."""
        if not self.shown:
            return
        if self._on_use:
            self._close()
            self._on_use(self._found.scene)
        elif self._sessions.open_scene(self._found.scene, self._found.seed):
            self._close()


def _picture(surface, theme, room, scene):
    """Draw a scene's cells in the middle of a room, as `draw_list` draws."""
    rect = pygame.Rect(room)
    sprite = sprite_of(scene, rect.size, theme.colours)
    surface.blit(sprite, sprite.get_rect(center=rect.center))
