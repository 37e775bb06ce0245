"""The panel's section of the timer: which time, how much of it is left, and how exact its end was."""

import math
from dataclasses import replace

from game.play.timer.timer import OFF, RUNNING
from game.world.sand.duration import spell, spell_left, spell_short
from game.world.sand.parameters import TIMER
from game.world.scenes.hourglass_maker import scene_for

PRESETS = 1, 3, 5, 10, 25  # minutes
LONGEST_S = 7200  # of the slider; --timer takes more
SECONDS = replace(TIMER, high=LONGEST_S, whole=True)
# up to so many seconds, the slider goes in such steps
STEPS_S = (20, 1), (60, 5), (300, 15), (1800, 30), (math.inf, 60)


class TimerSection:
    """The rows, which can be folded away; a timer that is started unfolds them."""

    def __init__(self, timer, sessions, settings, commands):
        self._timer, self._sessions, self._settings, self._commands = timer, sessions, settings, commands
        self._open = self._was_running = False

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        running = self._timer.state == RUNNING
        self._open = self._open or (running and not self._was_running)
        self._was_running = running
        self._open = ui.fold("Timer", self._open, tip="Makes the glass run out exactly on time")
        if self._open:
            self._lay_out_time(ui)
            self._lay_out_buttons(ui)

    def _lay_out_time(self, ui):
        """Show which time is wanted."""
        before = self._timer.wanted_s
        now = PRESETS.index(before / 60) if before / 60 in PRESETS else -1
        tip = "Minutes until the last grain passes the neck"
        chosen = ui.segmented("Minutes", tuple(map(str, PRESETS)), now, tip=tip)
        wanted_s = 60 * PRESETS[chosen] if chosen != now else before
        tip = "Time until the last grain passes the neck: from a second to two hours"
        turned_s = ui.slider("Any time", SECONDS, wanted_s, log=True, tip=tip, spell=spell_short)
        if turned_s != wanted_s:
            wanted_s = _even(wanted_s, turned_s, by_hand=ui.focus.held is not None)
        if wanted_s != before:
            self._timer.set(wanted_s)

    def _lay_out_buttons(self, ui):
        """Show what can be done with the timer, and what there is to say of it."""
        timer = self._timer
        ui.row(2)
        label = "Stop" if timer.state == RUNNING else "Start"
        if ui.button(label, key="T", name="Timer start", tip="Starts or stops the timer"):
            self._commands.toggle_timer()
        if ui.button("A glass for it", tip=f"Replaces this scene with a glass made for {spell(timer.wanted_s)}"):
            glass = self._sessions.suited(scene_for(timer.wanted_s))
            self._sessions.open_scene(glass, self._sessions.now.seed)
        tip = "Rings a soft bell when the time is up"
        self._settings["chime"] = ui.toggle("Chime at the end", self._settings["chime"], tip=tip)
        words = _told(timer)
        if words:
            ui.text(words)


def _even(before_s, turned_s, by_hand):
    """Return the time that a person would say: in even steps, the next one on the way where a key asked for it."""
    step_s = next(step_s for most_s, step_s in STEPS_S if max(before_s, turned_s) <= most_s)
    rounded = round if by_hand else math.ceil if turned_s > before_s else math.floor
    return min(max(rounded(turned_s / step_s) * step_s, SECONDS.low), SECONDS.high)


def _told(timer):
    """Return what there is to say of a timer, or ""."""
    if timer.state == OFF:
        return ""
    if timer.state != RUNNING:
        return f"{timer.said} F turns the glass over and starts again."
    pace = timer.iterations_per_second
    return f"{spell_left(timer.left_s)} left" + (f", {pace:,.0f} iterations a second" if pace else "")
