"""The panel: what can be chosen and turned, top to bottom; first what a newcomer reaches for, last what is set once."""

from game.play.panel.tabs import Tabs

NEAR = 12  # pixels at scale 1 that a section may be scrolled past its top and still counts as the one that is shown


class Panel:
    """The column of sections beside the sand, under tabs that lead to them."""

    def __init__(self, ui, display):
        self.ui, self._display = ui, display
        self._tabs = {}  # {name: its sections}
        self._tops = [0]  # where those of each tab begin in the column, as laid out last
        self.tabs = Tabs(())

    def hold(self, tabs):
        """Show sections, each by its `lay_out(ui)`, from top to bottom: {name of a tab: its sections}."""
        self._tabs, self.tabs = tabs, Tabs(tuple(tabs))

    def lay_out(self, events, now_s, mouse_pos):
        """Show the controls, do what they were told, and return the events that the panel leaves to others."""
        ui = self.ui
        ui.theme = self._display.theme
        column = self.tabs.place(ui.theme, self._display.layout.panel)
        events, pressed = self.tabs.handle_events(events, mouse_pos)
        if pressed is not None:
            self._show(pressed)
        rest = ui.begin(column, events, now_s, mouse_pos)
        self._tops = []
        for sections in self._tabs.values():
            self._tops.append(ui.bottom if self._tops else 0)
            for section in sections:
                section.lay_out(ui)
        ui.skip(max(0, self._tops[-1] + column.height - ui.bottom))  # so that the last one can come to the top
        return rest

    @property
    def shown(self):
        """The number of the tab whose section is at the top."""
        offset = self.ui.focus.scroll.offset + self._display.theme.px(NEAR)
        return max(number for number, top in enumerate(self._tops) if top <= offset)

    def turn(self, tabs):
        """Show the section so many tabs further on, and give the keyboard to its first control."""
        number = (self.shown + tabs) % len(self._tops)
        self._show(number)
        self.ui.focus.take(self._tops[number])

    def drawing(self):
        """Return (rect, strokes) of the tabs."""
        return self.tabs.rect, self.tabs.drawing(self.shown)

    def _show(self, number):
        self.ui.focus.leave()
        self.ui.focus.scroll.to(self._tops[number])
