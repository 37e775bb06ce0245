"""The page of a material: how it moves, what it becomes with others, and how likely that is, which can be turned."""

import pygame

from game.play.ui import draw_list
from game.play.ui import theme as look
from game.play.ui.card import draw_box
from game.play.ui.widgets import PAD, Ui
from game.play.view.chance_sliders import ChanceSliders, spelled
from game.play.view.swatches import striped, swatches_of
from game.world.rules.dials import dials_of
from game.world.rules.reactions import behaviour, reactions

WIDTH = 560  # pixels at scale 1
AROUND = 12
CELL_BOX = 25  # of a block in a picture
PICTURE = 78  # from the left edge to the words
CHANCE = 74  # at the right edge
ALONE = "Nothing changes it, and it changes nothing: it only moves."
STILL = "Nothing changes it, and it changes nothing."
NUMBERS = "How likely each is in a block of 2×2 cells where it can happen:"
FIXED = f"{NUMBERS[:-1]}. What has no slider is fixed in the rule's file:"


class MaterialPage:
    """The page, over the window while it is open. The sand goes on behind it."""

    fills_window = False

    def __init__(self, display, sessions, changes, brush):
        self._display, self._sessions, self._brush = display, sessions, brush
        self._sliders = ChanceSliders(sessions, changes)
        self.shown = False
        self._ui = None
        self._rect = pygame.Rect(0, 0, 0, 0)
        self._height = None, 0  # what the greatest height of a page is of, and the height
        self._drawn = False  # the box around the controls

    def toggle(self):
        """Open the page of the brush's material, or close it."""
        self.shown = not self.shown
        self._display.lay_out_anew()
        if self.shown:
            self._ui = Ui(self._display.theme)
            self._hear([], self._display.now_s, None)  # it may be drawn before it hears of anything

    def forget(self):
        """Draw everything next time."""
        self._drawn = False

    def handle_events(self, events, now_s, mouse_pos):
        """Take what is meant for the page; Esc and a click beside it close it."""
        if not self.shown:
            return events
        beside = [
            each for each in events if each.type == pygame.MOUSEBUTTONDOWN and not self._rect.collidepoint(each.pos)
        ]
        if beside or any(each.type == pygame.KEYDOWN and each.key == pygame.K_ESCAPE for each in events):
            self.toggle()
            return []
        rest = self._hear(events, now_s, mouse_pos)
        pointer = pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEWHEEL, pygame.MOUSEMOTION
        return [each for each in rest if each.type not in pointer]

    def _hear(self, events, now_s, mouse_pos):
        """Lay out the page with what it is told; return the events that it leaves to others."""
        self._ui.theme = self._display.theme
        self._place()
        rest = self._ui.begin(self._rect, events, now_s, mouse_pos)
        self._sliders.begin()
        closes = self._lay_out(self._ui, self._name)
        self._sliders.end(self._ui)
        if closes:
            self.toggle()
        return rest

    def draw(self, surface):
        """Draw the page where it looks different; return the rects that changed."""
        self._place()
        if not self._drawn:
            draw_box(surface, self._display.theme, self._rect)
            self._ui.invalidate()
        self._drawn = True
        return [self._rect] if self._ui.end(surface) else []

    def _place(self):
        """Stand in the middle of the window, as high as the page of any material needs to be."""
        px, size = self._display.theme.px, self._display.window.size
        wide = min(px(WIDTH), size[0] - 2 * px(AROUND))
        rect = pygame.Rect(0, 0, wide, min(self._tallest(wide), size[1] - 2 * px(AROUND)))
        rect.center = size[0] // 2, size[1] // 2
        if rect != self._rect:
            self._rect = rect
            self._display.lay_out_anew()

    def _tallest(self, wide):
        """Return the pixels that the page of the material with the most to say takes."""
        theme = self._display.theme
        looks = theme, wide, self._sessions.now.rule.definition.plain
        if self._height[0] != looks:
            ui, bottoms = Ui(theme), []
            for name in self._names:
                ui.begin(pygame.Rect(0, 0, wide, 0), [])
                self._lay_out(ui, name)
                bottoms.append(ui.bottom)
            self._height = looks, max(bottoms) + theme.px(PAD)
        return self._height[1]

    @property
    def _names(self):
        """The names of the materials that have a page."""
        return [name for name in self._brush.materials if name in self._sessions.now.rule.codes.told]

    @property
    def _name(self):
        """The name of the material whose page is open."""
        return self._brush.material if self._brush.material in self._names else self._names[0]

    def _lay_out(self, ui, name):
        """Show the materials, and what there is to say of that one; return whether the page is to be closed."""
        rule, names = self._sessions.now.rule, self._names
        told, swatches = rule.definition, swatches_of(ui.theme.colours, rule.definition.materials)
        ui.heading(f"What {name} does")
        colours = [swatches[rule.codes.told.index(each)] for each in names]
        labels, index = [each.capitalize() for each in names], names.index(name)
        tips = [f"Shows what {each} does, and paints with it" for each in names]
        chosen = ui.grid("Material", labels, index, 4, tips, colours)
        if chosen != index:
            self._brush.material = names[chosen]
        code = rule.codes.told.index(name)
        ui.text(behaviour(told, code), dim=True)
        found = [(each, _dial(told, each)) for each in reactions(rule, code)]
        if found:
            ui.text(NUMBERS if all(dial for _, dial in found) else FIXED, dim=True)
        for each, dial in found:
            if dial:
                self._sliders.show(ui, dial, _sentence(each.words), each.picture)
            else:
                _show(ui, each, swatches)
        if not found:
            ui.text(STILL if told.materials[code].kind == "solid" else ALONE)
        return ui.button("Close", key="Esc", tip="Goes back to the scene")


def _dial(definition, reaction):
    """Return the Dial of the chance of a reaction, or None if it cannot be turned."""
    dials = [dial for of_one in dials_of(definition.plain).values() for dial in of_one]
    mine = [dial for dial in dials if dial.event == reaction.event and "." not in dial.knob.name]
    return mine[0] if len(mine) == 1 else next((dial for dial in mine if dial.picture == reaction.picture), None)


def _sentence(words):
    return words[:1].upper() + words[1:]


def _show(ui, reaction, swatches):
    """Show a reaction that cannot be turned: its picture, its words and its name, and how likely it is."""
    px, width = ui.theme.px, ui.theme.width
    line, small = ui.theme.line_height(look.BODY), ui.theme.line_height(look.SMALL)
    lines = ui.theme.lines(_sentence(reaction.words), look.BODY, ui.width - px(PICTURE) - px(CHANCE))
    high = max(len(lines) * line + small, px(CELL_BOX))
    rect = ui.place(high + px(8), 0)
    before, after = striped(reaction.picture, swatches)
    box = pygame.Rect(rect.x, rect.y + (high - px(CELL_BOX)) // 2, px(CELL_BOX), px(CELL_BOX))
    ui.stroke(draw_list.cells, box, before)
    arrow = pygame.Rect(box.right + px(4), box.centery - px(5), px(10), px(10))
    ui.stroke(draw_list.polygon, arrow, draw_list.ARROW, look.DIM)
    ui.stroke(draw_list.cells, box.move(box.width + px(18), 0), after)
    left = rect.x + px(PICTURE)
    for number, text in enumerate(lines):
        place = pygame.Rect(left, rect.y + number * line, rect.right - px(CHANCE) - left, line)
        ui.stroke(draw_list.words, place, text, look.BODY, look.TEXT, 0)
    below = pygame.Rect(left, rect.y + len(lines) * line, rect.right - left, small)
    ui.stroke(draw_list.words, below, reaction.event, look.SMALL, look.FAINT, 0)
    chance = pygame.Rect(rect.right - px(CHANCE), rect.y, px(CHANCE), line)
    spelt = _spelled(reaction.chance)
    size = look.BODY if width(spelt, look.BODY) <= chance.width else look.SMALL
    ui.stroke(draw_list.words, chance, spelt, size, look.DIM, 1)


def _spelled(chance):
    """Return a chance, or the least and the most that it can be, in words."""
    if isinstance(chance, tuple):
        return "–".join(map(spelled, chance))
    return "always" if chance == 1.0 else spelled(chance)
