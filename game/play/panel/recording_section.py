"""The panel's section of recording: films, replays, and how much of the past is kept at hand."""

from game.play.storage.files import demos
from game.play.storage.films import formats
from game.world.sand import parameters


class RecordingSection:
    """The rows, which can be folded away."""

    def __init__(self, sessions, recorder, files, settings, time_commands):
        self._sessions, self._recorder, self._files, self._time = sessions, recorder, files, time_commands
        self._settings, self._formats = settings, formats.names()
        self._demos = demos()
        self._open = False

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        self._open = ui.fold(
            "Recording and past", self._open, tip="What undo does, films, replays, and the memory for the past"
        )
        if not self._open:
            return
        sessions, recorder = self._sessions, self._recorder
        tip = "Undo returns to the moment before the action, instead of keeping the time"
        self._time.undo_goes_back = ui.toggle("Undo goes back in time", self._time.undo_goes_back, tip=tip)
        ui.row(2)
        label = "End recording" if recorder.going_on else "Record"
        if ui.button(label, key="G", name="Record", tip="Records what follows as a film, until you end it"):
            recorder.toggle()
        if ui.button("Last 10 s", key="Shift+G", tip="Saves the last ten seconds as a film"):
            recorder.record_past()
        self._lay_out_format(ui)
        tip = "Puts a picture of the sand on the clipboard, to be pasted elsewhere"
        if ui.button("Copy the picture", key="Ctrl+Shift+C", tip=tip):
            recorder.copy_sand()
        tip = "Saves all that you did in this session, to be played again on any machine"
        if ui.button("Save as replay", key="Ctrl+Shift+S", tip=tip):
            self._files.save_replay()
        self._lay_out_demos(ui)
        if sessions.can_leave and ui.button("Back to my sand", tip="Leaves this replay and returns to your own sand"):
            sessions.leave()
        tip = "Memory for snapshots of the past. With less of it, going back takes longer; the sand is the same"
        memory = ui.slider("Memory", parameters.MEMORY, int(sessions.now.memory_mb), log=True, tip=tip, spell=_spell)
        if memory != sessions.now.memory_mb:
            sessions.now.limit_memory(round(memory))

    def _lay_out_format(self, ui):
        """Show which format the next recording has; one that cannot be written here is the usual one."""
        names = self._formats
        now = names.index(self._settings["recording"]) if self._settings["recording"] in names else 0
        tip = "GIF plays everywhere; WebP is smaller, and not every messenger plays it; MP4 needs ffmpeg"
        labels = {"gif": "GIF", "webp": "WebP", "mp4": "MP4"}
        chosen = ui.segmented("Format", tuple(labels[name] for name in names), now, tip=tip)
        if chosen != now:
            self._settings["recording"] = names[chosen]

    def _lay_out_demos(self, ui):
        titles = ("Play a replay …", *(name.replace("-", " ").capitalize() for name in self._demos))
        chosen = ui.choice("Demo", titles, 0, tip="Plays a recorded session; yours waits behind it")
        if chosen:
            self._files.play_demo(self._demos[chosen - 1])


def _spell(megabytes):
    """Return an amount of memory with its unit."""
    return f"{megabytes} MB" if megabytes < 1024 else f"{megabytes / 1024:.4g} GB"
