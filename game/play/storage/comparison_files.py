"""The files of a comparison: a picture of each world as it is shown, and one table of what was measured in all."""

import io

from game.play.storage.recorder import image_of
from game.world.files.paths import save_new
from game.world.sessions.measurements import csv

KIND = "measures"


class ComparisonFiles:
    """Saves beside the frames."""

    def __init__(self, sessions, display, plots, background, notices):
        self._sessions, self._display, self._plots = sessions, display, plots
        self._background, self._notices = background, notices

    def save(self):
        """Save what is shown of each world, with its title, and what the plots have measured."""
        name, surface = self._sessions.now.scene.name, self._display.window.surface
        framed = self._display.sand_view.framed
        pictures = {title: surface.subsurface(rect.clip(surface.get_rect())).copy() for title, rect in framed.items()}
        columns, rows = self._plots.compared_table()

        def work():
            for title, picture in pictures.items():
                file = io.BytesIO()
                image_of(picture).save(file, "PNG")
                save_new(KIND, f"{name} {title}", ".png", file.getvalue())
            return save_new(KIND, f"{name} compared", ".csv", csv(columns, rows))

        said = f"with {len(pictures)} pictures beside it"
        self._background.do(work, lambda path: self._notices.say(f"Saved as {path}, {said}"), writes=True)
