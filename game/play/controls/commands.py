"""The commands: what a player can tell the toy by a key or a button of the panel."""

import time

from game.play.controls import tilt as lean
from game.play.controls.brush import SIZES
from game.play.timer.timer import RUNNING
from game.world.sand import parameters
from game.world.sand.duration import spell_left
from game.world.sessions.action import Clear, Load, SetRule
from game.world.sessions.comparison import Comparison, present
from game.world.sessions.session import SEEK_NS

TWICE_S = 3.0  # within which Esc has to come again to quit; as long as the notice of it is read
FASTER = 2**0.5  # what one press of + does to the speed


class Commands:
    """One method for each command, named as in the table of `keys`."""

    def __init__(self, toy):
        self.toy = toy
        self._warned_s = -TWICE_S  # when the player was told how to quit

    # --- time ---

    def pause(self):
        """Hold time, or let it go on."""
        self.toy.sessions.now.paused = not self.toy.sessions.now.paused

    def step(self):
        """Run one iteration and hold time."""
        self.toy.sessions.now.paused = True
        if self.toy.sessions.ready():
            self.toy.sessions.now.step()

    def faster(self):
        """Speed time up by half."""
        self._change_speed(FASTER)

    def slower(self):
        """Slow time down by a third."""
        self._change_speed(1 / FASTER)

    def settle(self):
        """Run until nothing can move any more."""
        self.toy.ahead.settle()

    def await_flow(self):
        """Run until a grain next passes the neck."""
        self.toy.ahead.await_flow()

    def toggle_timer(self):
        """Start the timer, or stop it."""
        timer = self.toy.timer
        if timer.state == RUNNING:
            self.toy.notices.say(f"The timer was stopped with {spell_left(timer.left_s)} left.")
            timer.stop()
        else:
            timer.start()
            self.toy.panel.timer.open = True

    def undo(self):
        """Take back the last act; where a session has none left, go back to the one it was opened over.

        Only a key pressed anew does that, not one held.
        """
        toy = self.toy
        if toy.sessions.now.undo(toy.undo_goes_back, SEEK_NS):
            return
        if toy.hearing.repeats or not toy.sessions.leave():
            toy.notices.say("There is nothing to take back.")

    def redo(self):
        """Bring back what was undone last, or the future that was left."""
        toy = self.toy
        if not toy.sessions.now.redo(toy.undo_goes_back, SEEK_NS):
            toy.notices.say("There is nothing to bring back.")

    # --- sand ---

    def flip(self):
        """Turn the glass over: at once in the lattice, and in half a second on the screen."""
        if self.toy.turn_over():
            self.toy.timer.turned()

    def turn(self, quarters):
        """Turn the table by quarters, clockwise."""
        self.toy.turn_over(int(quarters))

    def tilt(self, way):
        """Lean the table a step to the left (-1) or to the right (1)."""
        act = lean.tilted(self.toy.sessions.now.rule, int(way))
        if act is None:
            self.toy.notices.say("At p = 0 no grain topples, to whichever side the table leans.")
        else:
            self.toy.sessions.do(act)
            self.toy.notices.say(lean.told(act.rule.bias))

    def restart(self):
        """Start the scene again, with the friction and at the speed that are set."""
        toy, rule, speed = self.toy, self.toy.sessions.now.rule, self.toy.timer.own_speed
        if toy.sessions.do(Load(toy.sessions.now.scene, toy.sessions.now.seed)):
            toy.sessions.do(SetRule(rule), join=True)
            toy.sessions.now.clock.speed = speed

    def clear(self):
        """Take all sand away."""
        self.toy.sessions.do(Clear())

    # --- brush ---

    def material(self, name):
        """Paint with sand, with walls, or with nothing from now on."""
        self.toy.brush.material = name

    def tool(self, name):
        """Take a tool in hand; rectangles and ellipses filled."""
        self.toy.brush.choose(name)
        self.toy.brush.edge_only = False

    def edge(self, name):
        """Take the tool of that name in hand, to draw outlines only."""
        self.toy.brush.choose(name)
        self.toy.brush.edge_only = True

    def size(self, number):
        """Give the brush the size that belongs to a number key."""
        self.toy.brush.diameter = SIZES[int(number) - 1]

    def toggle_cursor(self):
        """Let the arrows move a cursor over the cells, or no longer."""
        self.toy.cursor.toggle()

    def next_colour(self, steps):
        """Paint with sand of the colour so many swatches further on."""
        self.toy.brush.next_colour(int(steps))

    def next_shape(self):
        """Give the brush its next shape."""
        self.toy.brush.next_shape()

    def smaller_brush(self):
        """Shrink the brush."""
        self.toy.brush.resize(-1)

    def larger_brush(self):
        """Grow the brush."""
        self.toy.brush.resize(1)

    # --- view ---

    def show_all(self):
        """Show the whole lattice."""
        self.toy.camera.fit()

    def zoom(self, levels):
        """Show cells larger, or smaller."""
        self.toy.camera.zoom(int(levels))

    def look(self, right, down):
        """Show what lies beside the cells in sight."""
        self.toy.camera.pan(int(right), int(down))

    def toggle_blocks(self):
        """Show what each block can do in the coming iteration, or hide it."""
        self.toy.blocks.toggle()

    # --- files ---

    def save(self):
        """Save the scene as it is now."""
        if self.toy.sessions.ready():
            self.toy.files.save()

    def show_scenes(self):
        """Show the shipped scenes, or close their page."""
        self.toy.gallery.toggle(0)

    def open_scenes(self):
        """Show the saved scenes, or close their list."""
        self.toy.gallery.toggle(1)

    def shoot_window(self):
        """Take a picture of the window."""
        self.toy.recorder.shoot_window()

    def shoot_sand(self):
        """Take a picture of the sand alone, its cells whole pixels wide."""
        self.toy.recorder.shoot_sand()

    def record(self):
        """Record what follows, or end the recording."""
        self.toy.recorder.toggle()

    def record_past(self):
        """Record the last ten seconds."""
        self.toy.recorder.record_past()

    # --- window ---

    def toggle_panel(self):
        """Hide or show the panel."""
        self.toy.display.panel_shown = not self.toy.display.panel_shown
        self.toy.display.lay_out_anew()

    def toggle_forecast(self):
        """Show where the sand will be, or no longer."""
        self.toy.forecasting.toggle()

    def toggle_plots(self):
        """Show the plots of what the sand does, or no longer."""
        self.toy.plots.toggle()

    def save_measures(self):
        """Save what the plots have measured."""
        self.toy.plots.save()

    def toggle_sound(self):
        """Let the sand be heard, or not."""
        self.toy.hiss.toggle()

    def compare(self):
        """Show this world under all three schedules, from now on; again, go back to it as it was."""
        toy = self.toy
        if isinstance(toy.sessions.now, Comparison):
            toy.sessions.leave()
        elif toy.sessions.ready():
            session = Comparison(present(toy.sessions.now), toy.sessions.now.seed)
            session.paused, session.clock.speed = toy.sessions.now.paused, toy.timer.own_speed
            toy.journals.begin(session, [])
            toy.sessions.open(session, keep=True)
            words = "The same sand under three schedules. Shift+H or Esc goes back."
            toy.notices.say(words, holds=lambda: toy.sessions.now is session)

    def toggle_fullscreen(self):
        """Fill the screen, or go back."""
        self.toy.let_go()
        self.toy.window.toggle_fullscreen()
        self.toy.display.lay_out_anew()

    def toggle_help(self):
        """Open or close the page of keys."""
        self.toy.help.toggle()

    def escape(self):
        """Let go of what is being drawn, or close what is open; with nothing open quit, if it is said twice."""
        toy = self.toy
        closing = (
            (toy.brush.painting, toy.brush.let_go),
            (toy.help.shown, self.toggle_help),
            (toy.cursor.on, self.toggle_cursor),
            (toy.plots.shown, self.toggle_plots),
            (toy.forecasting.shown, self.toggle_forecast),
            (isinstance(toy.sessions.now, Comparison), self.compare),
            (toy.window.fullscreen, self.toggle_fullscreen),
            (time.monotonic() - self._warned_s > TWICE_S, self._warn_of_end),
        )
        next((close for is_open, close in closing if is_open), self._quit)()

    def _warn_of_end(self):
        self._warned_s = time.monotonic()
        self.toy.notices.say("Esc once more quits.", holds=lambda: time.monotonic() - self._warned_s <= TWICE_S)

    def _quit(self):
        self.toy.running = False

    def _change_speed(self, factor):
        clock = self.toy.sessions.now.clock
        clock.speed = min(max(clock.speed * factor, parameters.SPEED.low), parameters.SPEED.high)
