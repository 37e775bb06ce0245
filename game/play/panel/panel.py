"""The panel: what can be chosen and turned, top to bottom; first what a newcomer reaches for, last what is set once."""


class Panel:
    """The column of sections beside the sand."""

    def __init__(self, ui, display):
        self.ui, self._display = ui, display
        self.sections = ()  # laid out from top to bottom, each by its `lay_out(ui)`

    def lay_out(self, events, now_s, mouse_pos):
        """Show the controls, do what they were told, and return the events that the panel leaves to others."""
        self.ui.theme = self._display.theme
        rest = self.ui.begin(self._display.layout.panel, events, now_s, mouse_pos)
        for section in self.sections:
            section.lay_out(self.ui)
        return rest
