"""The timer's part of the panel: which time, how much of it is left, and how exact its end was."""

from game.play.timer import OFF, RUNNING
from game.world.duration import spell, spell_left
from game.world.knob import TIMER, Knob
from game.world.maker import glass_for, scene_of

PRESETS = 1, 3, 5, 10, 25  # minutes
MINUTES = Knob("minutes", TIMER.default / 60, 0.25, 120, "minutes", TIMER.meaning)


class TimerFold:
    """The rows, which can be folded away."""

    def __init__(self):
        self.open = False

    def lay_out(self, ui, toy):
        """Show the rows and obey what was done to them."""
        timer = toy.timer
        self.open = ui.fold("Timer", self.open, tip="An hourglass that runs out on time")
        if not self.open:
            return
        minutes = round(timer.wanted_s / 60, 2)  # as it is shown; seconds that were given as such stay exact
        now = PRESETS.index(minutes) if minutes in PRESETS else -1
        tip = "Minutes until the last grain falls, by the wall clock"
        chosen = ui.segmented("Minutes", tuple(map(str, PRESETS)), now, tip=tip)
        wanted = float(PRESETS[chosen]) if chosen != now else minutes
        wanted = ui.slider("Any time", MINUTES, wanted, log=True, tip=tip)
        if wanted != minutes:
            timer.set(60 * wanted)
        ui.row(2)
        label = "Stop" if timer.state == RUNNING else "Start"
        if ui.button(label, key="T", name="Timer start", tip="Starts the timer, or stops it"):
            toy.commands.toggle_timer()
        if ui.button("A glass for it", tip=f"Puts a glass that suits {spell(timer.wanted_s)} in place of this scene"):
            toy.open_scene(scene_of(glass_for(timer.wanted_s)), toy.session.seed)
        tip = "A soft sound when the last grain has fallen"
        toy.settings["chime"] = ui.toggle("Chime at the end", toy.settings["chime"], tip=tip)
        words = _told(timer)
        if words:
            ui.text(words)


def _told(timer):
    """Return what there is to say of a timer, or ""."""
    if timer.state == OFF:
        return ""
    if timer.state != RUNNING:
        return f"{timer.said} F turns the glass over and starts again."
    pace = timer.iterations_per_second
    return f"{spell_left(timer.left_s)} left" + (f", {pace:,.0f} iterations a second" if pace else "")
