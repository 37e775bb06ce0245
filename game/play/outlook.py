"""The outlook: the panel's part for what can be seen of the sand besides itself."""

from game.world import knob


def show(ui, toy):
    """Show the switches of the forecast, and obey them."""
    forecasting = toy.forecasting
    ui.heading("Outlook")
    tip = "How likely sand is in each cell some iterations from now, from many runs of the world as it is  (H)"
    if ui.toggle("Forecast", forecasting.shown, tip=tip) != forecasting.shown:
        forecasting.toggle()
    if forecasting.shown:
        forecasting.ahead = ui.slider("Ahead", knob.AHEAD, forecasting.ahead, log=True, tip="Iterations from now")
