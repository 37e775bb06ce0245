"""The commands: what a player can tell the window by a key or a button of the panel."""

from typing import NamedTuple

from game.play.controls.piece_commands import PieceCommands
from game.play.controls.sand_commands import SandCommands
from game.play.controls.time_commands import TimeCommands
from game.play.controls.view_commands import ViewCommands


class FileCommands:
    """The keys and buttons of scenes, pictures and recordings."""

    def __init__(self, sessions, files, gallery, recorder, plots, comparison_files, canvas_card):
        self._sessions, self._files, self._gallery = sessions, files, gallery
        self._recorder, self._plots, self._comparison_files = recorder, plots, comparison_files
        self._canvas_card = canvas_card

    def save(self):
        """Save the scene as it is now."""
        if self._sessions.ready():
            self._files.save()

    def new_canvas(self):
        """Ask what an empty canvas is to be like."""
        self._canvas_card.ask_new()

    def resize_canvas(self):
        """Ask how large the canvas is to become."""
        self._canvas_card.ask_size()

    def save_replay(self):
        """Save the session as a replay."""
        self._files.save_replay()

    def open_shipped(self, name):
        """Put a shipped scene in place of this one."""
        self._files.open_shipped(name)

    def save_measures(self):
        """Save what the plots have measured, of worlds side by side with a picture of each."""
        if len(self._sessions.now.sessions) > 1:
            self._comparison_files.save()
        else:
            self._plots.save()

    def show_scenes(self):
        """Show the shipped scenes, or close their page."""
        self._gallery.toggle(0)

    def open_scenes(self):
        """Show the saved scenes, or close their page."""
        self._gallery.toggle(1)

    def open_stamps(self):
        """Show the stamps that were kept, or close their page."""
        self._gallery.toggle(2)

    def shoot_window(self):
        """Take a picture of the window."""
        self._recorder.shoot_window()

    def shoot_sand(self):
        """Take a picture of the sand alone, its cells whole pixels wide."""
        self._recorder.shoot_sand()

    def copy_sand(self):
        """Put a picture of the sand on the clipboard."""
        self._recorder.copy_sand()

    def record(self):
        """Record what follows, or end the recording."""
        self._recorder.toggle()

    def record_past(self):
        """Record the last ten seconds."""
        self._recorder.record_past()


class Commands(NamedTuple):
    """All commands, in five groups. The keymap names each by its group and method: `time.pause`, `sand.turn 1`."""

    time: TimeCommands
    sand: SandCommands
    view: ViewCommands
    files: FileCommands
    piece: PieceCommands

    def give(self, command):
        """Carry out a command as the keymap names it, with what it is given."""
        name, *given = command.split()
        group, method = name.split(".")
        getattr(getattr(self, group), method)(*given)
