"""The data of a rule as C: names, colours, probabilities, and what adds up to each threshold."""

import re
from functools import lru_cache
from itertools import accumulate

from game.core.compiler.plan import ALWAYS, CHANCE, NEVER, plan, threshold_of, thresholds_in
from game.core.compiler.rule_pass import edges_of
from game.core.rule_table import CERTAIN
from game.export.c_text import listed, plain, text
from game.export.pass_text import pass_text

RESERVED = (  # what the header calls SANDGLASS_… beside the materials
    *("API", "BALANCED", "CHANCES", "H", "IMPLEMENTATION", "LARGEST", "MARGOLUS", "MATERIALS", "PAPER"),
    *("SCENE_HEIGHT", "SCENE_WIDTH"),
)


def plan_of(rule):
    """Return the Plan of a rule in which any chance with a name may be anything."""
    named = len(rule.definition.chances)
    kinds = {slots: _kind(slots, named, rule.values) for slots in thresholds_in(rule.table)}
    return _planned(rule.table, tuple(kinds.items()))


@lru_cache(maxsize=4)
def _planned(table, kinds):
    return plan(table, dict(kinds))


def _kind(slots, named, values):
    if CERTAIN in slots:
        return ALWAYS
    if any(slot < named for slot in slots):
        return CHANCE
    return {0: NEVER, 2**32: ALWAYS}.get(threshold_of(slots, values), CHANCE)


def rule_parts(rule):
    """Return {name in the template: C} of a rule."""
    gates = plan_of(rule)
    return {**_spoken_parts(rule), **_table_parts(rule, gates), "pass": pass_text(gates, rule.definition.layers)}


def _spoken_parts(rule):
    """Return the parts with the names that the rule gives."""
    told, names = rule.definition, rule.materials
    materials = constants(names)
    chances = [f"       {each.name} {rule.chances[each.name]!r}: {plain(each.meaning)}" for each in told.chances]
    return {
        "title": plain(told.title),
        "materials": listed([f"{name} = {code}" for code, name in enumerate(materials)]),
        "material_count": len(names),
        "material_names": listed(map(text, names)),
        "digested_names": "" if told.codes.is_sand else f"{', '.join(names)} ",
        "usual": materials[told.codes.code(told.codes.usual)],
        "wall": materials[told.codes.wall],
        "palette": listed(map(_colour, told.materials)),
        "chance_count": len(told.chances),
        "chance_list": "\n".join(chances or ["       none"]),
        "chance_names": listed([text(each.name) for each in told.chances] or ["0"]),
        "schedule": f"SANDGLASS_{rule.schedule.upper()}",
    }


def _table_parts(rule, gates):
    """Return the parts with the numbers that the passes need."""
    groups = [group for layer in gates.layers for group in layer.groups]
    most = max((len(group.slots) for group in groups), default=1)
    turned = {bit for layer in gates.layers for level in layer.deltas for _, bit in level}
    above, below = edges_of(rule.table)
    return {
        "bits": gates.bits,
        "outside": rule.table.outside,
        "layer_count": len(gates.layers),
        "group_count": max(1, len(groups)),
        "slot_count": max(1, len(rule.values)),
        "term_count": most,
        "above": int(above),
        "below": int(below),
        "probabilities": listed([repr(float(p)) for p in rule.values] or ["0.0"]),
        "terms": listed([_terms(group.slots, most) for group in groups] or [_terms((), most)]),
        "first_groups": ", ".join(map(str, [0, *accumulate(len(layer.groups) for layer in gates.layers)])),
        "changing": ", ".join(str(int(bit in turned)) for bit in range(gates.bits)),
    }


def constants(names):
    """Return the C name of each material, no two alike."""
    found, taken = [], {f"SANDGLASS_{word}" for word in RESERVED}
    for code, name in enumerate(names):
        constant = "SANDGLASS_" + re.sub(r"\W", "_", name.upper())
        found.append(f"{constant}_{code}" if constant in taken else constant)
        taken.add(found[-1])
    return found


def _colour(material):
    red, green, blue = material.colour
    return f"0xFF{blue:02X}{green:02X}{red:02X}u"


def _terms(slots, most):
    return "{ " + ", ".join(map(str, (*slots, *[-1] * (most - len(slots))))) + " }"
