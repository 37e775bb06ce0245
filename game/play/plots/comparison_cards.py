"""The cards of worlds side by side: one quantity in each, a curve for every world in its colour."""

import math
from typing import NamedTuple

from game.play.plots import charts
from game.play.plots.material_cards import MOST_LEGEND, SWATCH, legend
from game.play.ui import theme as look

UNKNOWN = "–"


class Quantity(NamedTuple):
    """What is compared."""

    title: str
    unit: str
    of: object  # a function of Measurements: a number for each of their samples, NaN where it is not known
    spell: object  # a function of a number: its text


def quantities(measurements):
    """Return the Quantities that worlds like that of Measurements have."""
    above = Quantity("Above", "grains", lambda each: [sample.above for sample in each.samples], "{:,}".format)
    flow = Quantity(f"Flow, row {measurements.row:,}", "grains/it.", lambda each: each.flows(), "{:.3g}".format)
    if not measurements.codes.is_sand:
        name = measurements.codes.usual
        amount = Quantity(name.capitalize(), "cells", lambda each: _amounts(each, name), "{:,.0f}".format)
        return amount, above._replace(unit="filled cells"), flow._replace(unit="cells/it.")
    height = Quantity("Pile height", "cells", lambda each: [it.height for it in each.samples], "{:,}".format)
    slope = Quantity("Pile slope", "degrees", lambda each: [it.slope for it in each.samples], "{:.0f}°".format)
    return flow, above, height, slope


def comparison_card(theme, rect, quantity, measured, colours):
    """Return the strokes of the card of a Quantity; measured: {name: Measurements}."""
    series = {name: quantity.of(each) for name, each in measured.items()}
    known = [number for numbers in series.values() for number in numbers if not math.isnan(number)]
    strokes, room = charts.card(theme, rect, quantity.title, quantity.unit)
    now = {name: _last(numbers, quantity.spell) for name, numbers in series.items()}
    names, room, _ = _names(theme, room, [(name, now[name], colours[name]) for name in series])
    nows = {name: [sample.now for sample in each.samples] for name, each in measured.items()}
    room, foot = charts.with_foot(theme, room, sorted({now for each in nows.values() for now in each}))
    low, high = -charts.round_up(-min([0.0, *known])), charts.round_up(max([0.1, *known]))
    ends = [(each, charts.figure(each)) for each in dict.fromkeys((high, low, 0))]
    figures, room = charts.scale(theme, room, ends, low, high)
    lines = [(nows[name], series[name], colours[name]) for name in series]
    return strokes + names + foot + figures + charts.curves(room, lines, low, high)


def _names(theme, room, entries):
    """Return what `legend` does, without figures where there is no room for all worlds with them."""
    for each in (entries, [(name, "", colour) for name, _, colour in entries]):
        wide = max(theme.width(f"{name}  {figure}", look.SMALL) for name, figure, _ in each) + theme.px(2 * SWATCH)
        rows = -(-len(each) // max(1, room.width // wide))
        if rows * theme.line_height(look.SMALL) <= MOST_LEGEND * room.height:
            break
    return legend(theme, room, each, wide)


def _last(numbers, spell):
    return UNKNOWN if not numbers or math.isnan(numbers[-1]) else spell(numbers[-1])


def _amounts(measurements, name):
    """Return how many cells hold a material, in a world that may have none of it."""
    codes = measurements.codes
    if codes.is_sand:
        return [sum(each.amounts) if name in codes.told else 0 for each in measurements.samples]
    held = codes.codes_of(name) if name in codes.told else ()
    return [sum(each.amounts[code] for code in held) for each in measurements.samples]
