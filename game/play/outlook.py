"""The outlook: the panel's part for what can be seen of the sand besides itself."""

from dataclasses import replace

from game.world import knob


def show(ui, toy):
    """Show the switches of the forecast and the plots, and obey them."""
    forecasting, plots = toy.forecasting, toy.plots
    ui.heading("Outlook")
    tip = "How likely sand is in each cell some iterations from now, from many runs of the world as it is  (H)"
    if ui.toggle("Forecast", forecasting.shown, tip=tip) != forecasting.shown:
        forecasting.toggle()
    if forecasting.shown:
        forecasting.ahead = ui.slider("Ahead", knob.AHEAD, forecasting.ahead, log=True, tip="Iterations from now")
    tip = "Flow and filling at a row, the pile below it, frame times, and the audit of the grains  (L)"
    if ui.toggle("Plots", plots.shown, tip=tip) != plots.shown:
        toy.commands.toggle_plots()
    if plots.shown:
        height = toy.session.world.shape[0]
        tip = "The row that parts above from below: the neck of a glass, else the middle, unless you set it"
        row = ui.slider("At row", replace(knob.ROW, high=height), plots.measured_row, default=plots.own_row, tip=tip)
        if row != plots.measured_row:
            plots.measured_row = row
        if ui.button(
            "Save as CSV", key="Shift+L", tip="Saves what was measured since the plots were opened, with a header"
        ):
            plots.save()
