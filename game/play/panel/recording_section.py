"""The past's part of the panel: recordings, replays, and how much of the past is kept at hand."""

from game.play.storage.files import demos
from game.world.sand import parameters


class PastFold:
    """The rows, which can be folded away."""

    def __init__(self):
        self.open = False
        self._demos = demos()

    def lay_out(self, ui, toy):
        """Show the rows and obey what was done to them."""
        self.open = ui.fold("Recording and past", self.open, tip="How undo works, recording, replays, memory")
        if not self.open:
            return
        commands = toy.commands
        tip = "Undo also goes back to the moment before the act, instead of leaving the time as it is"
        commands.time.undo_goes_back = ui.toggle("Undo goes back in time", commands.time.undo_goes_back, tip=tip)
        ui.row(2)
        label = "End recording" if toy.recorder.going_on else "Record"
        if ui.button(label, key="G", name="Record", tip="Records what follows as a GIF"):
            commands.files.record()
        if ui.button("Last 10 s", key="Shift+G", tip="Records the last ten seconds as a GIF; the sand goes on"):
            commands.files.record_past()
        self._demo(ui, toy)
        if toy.sessions.can_leave and ui.button("Back to my sand", tip="Leaves this replay"):
            toy.sessions.leave()
        tip = "MB for snapshots of the past; with less of them time runs back more slowly, the sand is the same"
        memory = ui.slider("Memory", parameters.MEMORY, int(toy.sessions.now.memory_mb), log=True, tip=tip)
        if memory != toy.sessions.now.memory_mb:
            toy.sessions.now.limit_memory(round(memory))

    def _demo(self, ui, toy):
        titles = ("Play a replay …", *(name.replace("-", " ").capitalize() for name in self._demos))
        chosen = ui.choice("Demo", titles, 0, tip="A recorded session; yours waits behind it")
        if chosen:
            toy.files.play_demo(self._demos[chosen - 1])
