"""The panel: what can be chosen and turned, top to bottom."""

from dataclasses import replace

import pygame

from game.play import appearance, outlook, toolbox
from game.play.files import demos
from game.play.glass_fold import GlassFold
from game.play.timer_fold import TimerFold
from game.world import knob
from game.world.action import SetRule
from game.world.rule import SCHEDULES, Rule
from game.world.scene import scene_names

PAPER_P = (0.25, 0.5, 0.75, 1.0)  # the four values of the paper
WIDTH = 300  # pixels at scale 1
NARROWEST = 240  # at scale 1: all words of the controls still fit
FAST = "Fast"  # the button that is held

BLOCKS = {  # what each probability decides: corners a b c d before and after
    "topple_left": (".o.#", "..o#"),
    "topple_right": ("o.#.", "..#o"),
    "fall_pair": ("oo..", "..oo"),
    "fall_low_left": ("o..#", "..o#"),
    "fall_low_right": (".o#.", "..#o"),
    "fall_full_left": ("o#.#", ".#o#"),
    "fall_full_right": ("#o#.", "#.#o"),
}
SCHEDULE_TIP = (
    "The order in which partitions into blocks take turns. Margolus: two partitions, piles grow one side first. "
    "Paper: four, grains alternate sides. Balanced: the same four reordered, grains fall evenly and twice as fast."
)
SEVEN_TIP = "How likely sand moves, for each thing that can happen in a block of 2×2 cells"


class Panel:
    """The column of controls, and the few values that only it remembers."""

    def __init__(self, ui):
        self.ui = ui
        self.all_seven = False  # whether the fold with all probabilities is open
        self.past_open = False  # whether the fold of the past is open
        self.timer, self.glass = TimerFold(), GlassFold()
        self._turning = False  # a slider is being dragged, and what it sets is one act
        self._rule = None  # the rule that _p and _bias stand for
        self._p = self._bias = 0.0
        self._scenes = scene_names()
        self._demos = demos()

    def lay_out(self, rect, events, now_s, mouse_pos, toy):
        """Show the controls, obey what was done to them, and return the events that the panel leaves to others."""
        rest = self.ui.begin(rect, events, now_s, mouse_pos)
        self._scene(toy)
        self._friction(toy)
        self._time(toy)
        self._past(toy)
        toolbox.show(self.ui, toy)
        outlook.show(self.ui, toy)
        self._window(toy)
        return rest

    def _scene(self, toy):
        ui, scene = self.ui, toy.session.scene
        names = self._scenes if scene.name in self._scenes else (*self._scenes, scene.name)
        titles = [toy.title_of(name) for name in names]
        now = names.index(scene.name)
        chosen = ui.choice("Scene", titles, now, tip="Puts the sand and walls of another scene in place of these")
        if chosen != now:
            toy.load(names[chosen])
        if scene.notice:
            ui.text(scene.notice, dim=True)
        if ui.button("Gallery", key="F2", tip="All scenes at once, running, with a sentence on each"):
            toy.commands.show_scenes()

    def _friction(self, toy):
        ui, rule, scene = self.ui, toy.session.rule, toy.session.scene
        ui.heading("Friction")
        if rule is not self._rule:
            self._rule, self._p, self._bias = rule, rule.p, rule.bias
        tip = "How readily grains topple. Less is more friction: tall, thin piles."
        p = ui.slider("p", knob.P, self._p, default=scene.rule.p, marks=PAPER_P, tip=tip)
        tip = "Leans the toppling: below 0 to the left, above 0 to the right."
        bias = ui.slider("Bias", knob.BIAS, self._bias, default=scene.rule.bias, marks=(0.0,), tip=tip)
        names = list(SCHEDULES)
        now = names.index(rule.schedule)
        schedule = names[ui.choice("Schedule", [name.capitalize() for name in names], now, tip=SCHEDULE_TIP)]
        changed = rule
        if (p, bias) != (self._p, self._bias):
            topples = Rule.with_p(p, bias=bias)
            changed = replace(rule, topple_left=topples.topple_left, topple_right=topples.topple_right)
            self._p, self._bias = p, bias
            self._rule = changed
        if schedule != rule.schedule:
            changed = self._rule = replace(changed, schedule=schedule)
        changed = self._seven(changed, scene.rule)
        held = ui.focus.held is not None
        if changed is not rule:
            toy.do(SetRule(changed), join=self._turning)
        self._turning = held and (self._turning or changed is not rule)

    def _seven(self, rule, scene_rule):
        self.all_seven = self.ui.fold("All seven probabilities", self.all_seven, tip=SEVEN_TIP)
        if not self.all_seven:
            return rule
        for each in knob.PROBABILITIES:
            before, after = BLOCKS[each.name]
            words = each.name.replace("_", " ").capitalize()
            value = getattr(rule, each.name)
            tip = f"How often {each.meaning}."
            turned = self.ui.slider_with_picture(
                words, each, value, before, after, default=getattr(scene_rule, each.name), tip=tip
            )
            if turned != value:
                rule = replace(rule, **{each.name: turned})
        return rule

    def _time(self, toy):
        ui, session = self.ui, toy.session
        ui.heading("Time")
        tip = "How fast the sand runs, in iterations per second"
        session.clock.speed = ui.slider(
            "Speed", knob.SPEED, session.clock.speed, default=session.scene.speed, log=True, tip=tip
        )
        ui.row(2)
        if ui.button(
            "Go on" if session.paused else "Pause",
            key="Space",
            name="Pause",
            tip="Holds the sand where it is, and lets it go on",
        ):
            toy.commands.pause()
        if ui.button("Step", key=".", tip="Lets the sand move by one iteration"):
            toy.commands.step()
        ui.row(3)
        ui.button(FAST, key="Right", tip="Hold it: time goes as fast as the frames can hold")
        toy.ahead.hold(ui.focus.held == FAST)
        if ui.button("Settle", key="End", tip="Runs until nothing can move any more"):
            toy.commands.settle()
        if ui.button("Flow", key="Shift+Right", tip="Runs until a grain next passes the neck"):
            toy.commands.await_flow()
        ui.row(2)
        if ui.button("Flip", key="F", tip="Turns the glass over"):
            toy.commands.flip()
        if ui.button("Restart", key="R", tip="Starts the scene again"):
            toy.commands.restart()
        self.timer.lay_out(ui, toy)
        self.glass.lay_out(ui, toy)

    def _past(self, toy):
        """What can be done to time that has passed; undo, save and open are always in sight."""
        ui, commands = self.ui, toy.commands
        ui.row(2)
        if ui.button("Undo", key="Ctrl+Z", tip="Takes back the last act; the sand is as it would have been without"):
            commands.undo()
        if ui.button("Redo", key="Ctrl+Y", tip="Brings back what was undone, or the future that was left"):
            commands.redo()
        ui.row(2)
        if ui.button("Save", key="Ctrl+S", tip="Saves sand, walls and settings as one picture"):
            commands.save()
        if ui.button("Open", key="Ctrl+O", tip="Shows the saved scenes; the one opened replaces this sand"):
            commands.open_scenes()
        self.past_open = ui.fold("Past", self.past_open, tip="Undo, recording, replays, memory")
        if self.past_open:
            self._past_in_full(toy)

    def _past_in_full(self, toy):
        ui, commands, session = self.ui, toy.commands, toy.session
        tip = "Undo also goes back to the moment before the act, instead of leaving the time as it is"
        toy.undo_goes_back = ui.toggle("Undo goes back in time", toy.undo_goes_back, tip=tip)
        ui.row(2)
        label = "End recording" if toy.recorder.going_on else "Record"
        if ui.button(label, key="G", name="Record", tip="Records what follows as a GIF"):
            commands.record()
        if ui.button("Last 10 s", key="Shift+G", tip="Records the last ten seconds as a GIF; the sand goes on"):
            commands.record_past()
        self._demo(toy)
        if toy.can_leave_session and ui.button("Back to my sand", tip="Leaves this replay"):
            toy.leave_session()
        tip = "MB for snapshots of the past; with less of them time runs back more slowly, the sand is the same"
        memory = ui.slider("Memory", knob.MEMORY, int(session.timeline.memory_mb), log=True, tip=tip)
        if memory != session.timeline.memory_mb:
            session.timeline.memory_mb = round(memory)

    def _demo(self, toy):
        titles = ("Play a replay …", *(name.replace("-", " ").capitalize() for name in self._demos))
        chosen = self.ui.choice("Demo", titles, 0, tip="A recorded session; yours waits behind it")
        if chosen:
            toy.files.play_demo(self._demos[chosen - 1])

    def _window(self, toy):
        ui = self.ui
        ui.heading("Window")
        toy.hiss.show(ui)
        ui.row(2)
        if ui.button("Full screen", key="F11", tip="Fills the screen, or goes back to the window"):
            toy.commands.toggle_fullscreen()
        if ui.button("Keys", key="F1", tip="Every key on one page"):
            toy.commands.toggle_help()
        appearance.show(ui, toy.settings)


def fitting_scale(ui_scale, window_width):
    """Return the UI scale, smaller than wanted where the narrowest panel would take more than half of the window."""
    return max(knob.UI_SCALE.low, min(ui_scale, window_width / (2 * NARROWEST)))


def area(theme, window_size):
    """Return the panel's rect in a window of that size."""
    wide = max(min(theme.px(WIDTH), window_size[0] * 9 // 20), theme.px(NARROWEST))
    return pygame.Rect(window_size[0] - wide, 0, wide, window_size[1])
