"""The panel's section of the window: its sound, size and looks, and the stage. What is chosen is a setting."""

from game.play.controls.stage import LINES, P

LINE_TIPS = {
    "iteration": "How many iterations the world has run",
    "p": "How readily grains topple",
    "partition": "Which partition into blocks comes next",
    "clock": "What is left of the timer, or else the time of day",
}
SIZES = 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0


class WindowSection:
    """The switches of sound and looks."""

    def __init__(self, settings, hiss, stage, commands):
        self._settings, self._hiss, self._stage, self._commands = settings, hiss, stage, commands
        self._open = False  # the fold of the lines on the stage

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        ui.heading("View and sound")
        self._lay_out_sound(ui)
        ui.row(2)
        if ui.button("Full screen", key="F11", tip="Fills the screen, or returns to a window"):
            self._commands.toggle_fullscreen()
        if ui.button("Keys", key="F1", tip="Shows every key on one page"):
            self._commands.toggle_help()
        self._lay_out_stage(ui)
        self._lay_out_looks(ui)

    def _lay_out_sound(self, ui):
        settings = self._settings
        tip = "The sand hisses: the more of it moves, the louder  (M)"
        if ui.toggle("Sound", settings["sound"], tip=tip) != settings["sound"]:
            self._hiss.toggle()
        if settings["sound"]:
            tip = "How loud the sand is"
            settings["volume"] = ui.slider(
                "Volume", settings.rows["volume"], settings["volume"], tip=tip, spell="{:.0%}".format
            )

    def _lay_out_stage(self, ui):
        tip = "For a class: no panel, no small print, and what you choose in letters to be read across a room"
        label = "End the stage" if self._stage.on else "Stage"
        if ui.button(label, key="F5", tip=tip, name="Stage"):
            self._commands.toggle_stage()
        self._open = ui.fold("Lines on the stage", self._open, tip="What stands there in large letters")
        chosen = self._settings["stage_lines"]
        for name in LINES if self._open else ():
            label = name if name == P else name.capitalize()
            if ui.toggle(label, name in chosen, tip=LINE_TIPS[name], name=f"Stage {name}") != (name in chosen):
                self._settings["stage_lines"] = tuple(each for each in LINES if (each in chosen) != (each == name))

    def _lay_out_looks(self, ui):
        settings = self._settings
        themes = settings.rows["theme"].options
        names = tuple(name.replace("-", " ").capitalize() for name in themes)
        tip = "Colours of the window and the sand"
        settings["theme"] = themes[ui.choice("Theme", names, themes.index(settings["theme"]), tip=tip)]
        sizes = sorted({*SIZES, settings["ui_scale"]})
        tip = "Size of this panel and of all text, as far as there is room"
        words = tuple(f"{100 * size:.0f} %" for size in sizes)
        settings["ui_scale"] = sizes[ui.choice("Scale", words, sizes.index(settings["ui_scale"]), tip=tip)]
        tip = "Draws falling sand as the mean of what happens within a frame; the sand itself is the same"
        settings["smooth_streams"] = ui.toggle("Smooth streams", settings["smooth_streams"], tip=tip)
        tip = "Turns the glass over at once; no glows and fades"
        settings["reduced_motion"] = ui.toggle("Reduced motion", settings["reduced_motion"], tip=tip)
