"""The outlook: the panel's part for what can be seen of the sand besides itself."""

from dataclasses import replace

from game.world.sand import parameters
from game.world.sessions.comparison import Comparison


def show(ui, toy):
    """Show the switches of the forecast, the plots and the figures, and obey them."""
    forecasting, plots = toy.forecasting, toy.plots
    ui.heading("Outlook")
    tip = "How likely sand is in each cell some iterations from now, from many runs of the world as it is  (H)"
    if ui.toggle("Forecast", forecasting.shown, tip=tip) != forecasting.shown:
        forecasting.toggle()
    if forecasting.shown:
        forecasting.ahead = ui.slider("Ahead", parameters.AHEAD, forecasting.ahead, log=True, tip="Iterations from now")
    comparing = isinstance(toy.sessions.now, Comparison)
    tip = "The sand as it is under Margolus, Paper and Balanced; what is done to one is done to all"
    if ui.button("Back to one schedule" if comparing else "Three schedules", key="Shift+H", name="Compare", tip=tip):
        toy.commands.sand.compare()
    if comparing:
        ui.text(
            "Each world keeps its own schedule. Replays, saving, plots and forecast follow the bright title.",
            dim=True,
        )
    tip = "Flow and filling at a row, the pile below it, frame times, and the audit of the grains  (L)"
    if ui.toggle("Plots", plots.shown, tip=tip) != plots.shown:
        toy.commands.view.toggle_plots()
    if plots.shown:
        height = toy.sessions.now.world.shape[0]
        tip = "The row that parts above from below: the neck of a glass, else the middle, unless you set it"
        row = ui.slider(
            "At row", replace(parameters.ROW, high=height), plots.measured_row, default=plots.own_row, tip=tip
        )
        if row != plots.measured_row:
            plots.measured_row = row
        if ui.button(
            "Save as CSV", key="Shift+L", tip="Saves what was measured since the plots were opened, with a header"
        ):
            plots.save()
    tip = "Frames, iterations, the books of the grains and memory; so does pointing at the line under the sand"
    if ui.toggle("Figures", toy.stats_card.kept, tip=tip) != toy.stats_card.kept:
        toy.stats_card.toggle()
