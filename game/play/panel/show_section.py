"""The panel's section of what is shown besides the sand: forecast, comparison, plots and figures."""

from dataclasses import replace

from game.world.sand import parameters
from game.world.sessions.comparison import Comparison, by_friction, by_schedule, by_seed


class ShowSection:
    """The switches, and what only an instrument that is shown needs."""

    def __init__(self, sessions, forecasting, plots, stats_card, sand_commands):
        self._sessions, self._forecasting, self._plots = sessions, forecasting, plots
        self._stats_card, self._sand = stats_card, sand_commands

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        ui.heading("Measure and compare")
        self._lay_out_forecast(ui)
        self._lay_out_comparison(ui)
        self._lay_out_plots(ui)
        tip = (
            "Shows frame times, the iteration, the account of the grains and memory; so does pointing at the line below"
        )
        if ui.toggle("Figures", self._stats_card.kept, tip=tip) != self._stats_card.kept:
            self._stats_card.toggle()

    def _lay_out_forecast(self, ui):
        forecasting = self._forecasting
        tip = "How likely each cell is to hold a material some iterations from now, from many runs  (H)"
        if ui.toggle("Forecast", forecasting.shown, tip=tip) != forecasting.shown:
            forecasting.toggle()
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

    def _lay_out_comparison(self, ui):
        if isinstance(self._sessions.now, Comparison):
            if ui.button("Back to one world", key="Shift+H", name="Compare"):
                self._sand.compare()
            words = "Each keeps what its title says. Saving, replays, plots and the forecast follow the bright one."
            ui.text(words, dim=True)
            return
        tip = "Runs this sand under Margolus, Paper and Balanced at once; what you do to one is done to all"
        if ui.button("Three schedules", key="Shift+H", name="Compare", tip=tip):
            self._sand.compare(by_schedule)
        has_p = self._sessions.now.rule.leans
        ui.row(1 + has_p)
        if has_p and ui.button("Four p", name="Compare p", tip="Runs this sand with the four p of the paper at once"):
            self._sand.compare(by_friction)
        if ui.button("Seeds", name="Compare seeds", tip="Runs this world three times, each with other luck"):
            self._sand.compare(by_seed)

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
