"""The controls of how the window looks: theme, size, smooth streams, reduced motion. What is chosen is a setting."""

SIZES = 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0


def show(ui, settings):
    """Show the controls."""
    themes = settings.rows["theme"].options
    names = tuple(name.replace("-", " ").capitalize() for name in themes)
    tip = "Colours of the window and the sand; the sand moves the same"
    settings["theme"] = themes[ui.choice("Theme", names, themes.index(settings["theme"]), tip=tip)]
    sizes = sorted({*SIZES, settings["ui_scale"]})
    tip = "Size of this panel and of all text, as far as the window has room for it; the sand gets what is left"
    words = tuple(f"{100 * size:.0f} %" for size in sizes)
    settings["ui_scale"] = sizes[ui.choice("Scale", words, sizes.index(settings["ui_scale"]), tip=tip)]
    tip = "Shows falling sand as the mean of all that happens within a frame; the sand moves the same"
    settings["smooth_streams"] = ui.toggle("Smooth streams", settings["smooth_streams"], tip=tip)
    tip = "Turns the glass over at once, and leaves out glows and fades"
    settings["reduced_motion"] = ui.toggle("Reduced motion", settings["reduced_motion"], tip=tip)
