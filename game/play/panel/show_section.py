"""The panel's section of what is shown besides the sand: forecast, plots and figures."""

from dataclasses import replace

from game.play.controls.tools.ruler import TOOL
from game.world.sand import parameters


class ShowSection:
    """The switches, and what only an instrument that is shown needs."""

    def __init__(self, sessions, brush, forecasting, plots, stats_card, commands):
        self._sessions, self._brush = sessions, brush
        self._forecasting, self._plots = forecasting, plots
        self._stats_card, self._commands = stats_card, commands

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        ui.heading("Measure")
        self._lay_out_forecast(ui)
        self._lay_out_plots(ui)
        ruled = self._brush.tool == TOOL
        tip = "Measures angle and distance between two places: drag from one to the other  (Shift+M)"
        if ui.toggle("Ruler", ruled, tip=tip) != ruled:
            self._brush.choose("brush" if ruled else TOOL)
        tip = (
            "Shows frame times, the iteration, the account of all cells and memory; so does pointing at the line below"
        )
        if ui.toggle("Figures", self._stats_card.kept, tip=tip) != self._stats_card.kept:
            self._stats_card.toggle()

    def _lay_out_forecast(self, ui):
        forecasting = self._forecasting
        tip = "How likely each cell is to hold a material some iterations from now, from many runs  (H)"
        if ui.toggle("Forecast", forecasting.shown, tip=tip) != forecasting.shown:
            self._commands.toggle_forecast()
        if forecasting.shown:
            names = forecasting.materials
            if len(names) > 1:
                labels, now = [name.capitalize() for name in names], names.index(forecasting.of)
                forecasting.of = names[
                    ui.choice("Of", labels, now, tip="Which material is forecast", name="Forecast of")
                ]
            forecasting.ahead = ui.slider(
                "Ahead", parameters.AHEAD, forecasting.ahead, log=True, tip="How many iterations from now"
            )

    def _lay_out_plots(self, ui):
        plots = self._plots
        tip = "What the sand does: flow and pile, or how much there is of each material, and the account of it all  (L)"
        if ui.toggle("Plots", plots.shown, tip=tip) != plots.shown:
            plots.toggle()
        if plots.shown and self._sessions.now.rule.codes.is_sand:
            height = self._sessions.now.world.shape[0]
            tip = "The row at which flow is measured: the neck of the glass, or else the middle, unless you move it"
            row = ui.slider(
                "At row",
                replace(parameters.ROW, high=height),
                plots.measured_row,
                default=plots.own_row,
                tip=tip,
                spell="{:,}".format,
            )
            if row != plots.measured_row:
                plots.measured_row = row
        tip = "Saves what was measured since the plots were opened"
        if plots.shown and ui.button("Save as CSV", key="Shift+L", tip=tip):
            plots.save()
