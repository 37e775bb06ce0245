"""The controls of how the window looks: theme, smooth streams, reduced motion. What is chosen is a setting."""


def show(ui, settings):
    """Show the controls."""
    themes = settings.rows["theme"].options
    names = tuple(name.replace("-", " ").capitalize() for name in themes)
    tip = "Colours of the window and the sand; the sand moves the same"
    settings["theme"] = themes[ui.choice("Theme", names, themes.index(settings["theme"]), tip=tip)]
    tip = "Shows falling sand as the mean of all that happens within a frame; the sand moves the same"
    settings["smooth_streams"] = ui.toggle("Smooth streams", settings["smooth_streams"], tip=tip)
    tip = "Turns the glass over at once, and leaves out glows and fades"
    settings["reduced_motion"] = ui.toggle("Reduced motion", settings["reduced_motion"], tip=tip)
