"""A rule in words: its materials, its laws, and the picture of each event with its probability."""

from game.core.compiler.rule_pass import gates_of
from game.world.rules.events import OwnNumber
from game.world.rules.laws import Changes, laws, overlaps, reacting_pairs

WAYS = {"as drawn": "as drawn", "mirror": "mirrored too", "turn": "turned all ways"}
_WIDTH = 100  # characters of a line


def description(rule):
    """Return the lines that tell of a rule."""
    told = rule.definition
    events = told.told_events()
    layers = ", then ".join(dict.fromkeys(each.layer for each in events))
    lines = [f"{told.title}: {len(told.materials)} materials, {len(events)} events, schedule {rule.schedule}"]
    lines += [told.notice] if told.notice else []
    lines += [
        _size(rule.table, rule.values),
        "",
        *_materials(told),
        "",
        *_laws(rule),
        *_chances(rule),
        "",
        f"In each block happens at most one of these; tried are {layers}:",
    ]
    for event in events:
        lines += ["", *_event(event, rule)]
    return [line.rstrip() for line in lines]


def _size(table, values):
    states, claimed = len(table.used_states), len(table.claimed_states)
    gates = gates_of(table, values)
    return f"Something can happen in {claimed:,} of {states:,} block states; the circuit for it has {gates:,} gates."


def _materials(told):
    rows = [("code", "letter", "material", "class", "density", "its own")]
    for code, each in enumerate(told.materials):
        density = "" if each.kind in ("solid", "empty") else f"{each.density:g}"
        own = ", ".join(f"{name} {value}" for name, value in each.numbers)
        rows.append((str(code), each.letter, each.name, each.kind, density, own))
    return _columns(rows)


def _laws(rule):
    told = rule.definition
    rows = [("law", "kept", "found")]
    rows += [(law.name, "yes" if law.holds else "NO", law.found) for law in laws(told, rule.values)]
    lines = _columns(rows)
    pairs = [f"{x} and {y}" for x, y in reacting_pairs(Changes(told, rule.values))]
    lines += ["", *_wrapped("Change each other: ", pairs)] if pairs else []
    met = [f"{earlier!r} before {later!r}" for earlier, later, _ in overlaps(told)]
    return lines + (["", *_wrapped("Meet in a block: ", met)] if len(met) <= len(told.events) and met else [])


def _chances(rule):
    rows = [(each.name, f"{rule.chances[each.name]:g}", each.meaning) for each in rule.definition.chances]
    return ["", *_columns([("chance", "value", "how likely it is that"), *rows])] if rows else []


def _event(event, rule):
    """Return the lines of an event: name, probability and ways, what its letters mean, and its pictures."""
    told = rule.definition
    lines = [f"  {event.name}: {event.spoken_chance(rule.chances)}, {WAYS[event.ways]}"]
    lines += [f"    {line}" for line in event.picture.lines()]
    lines += _wrapped("    where ", [each.words for each in event.where])
    for sign, codes in event.codes.items():
        if sign.isupper():
            lines += _wrapped(f"    {sign}: ", [words_for(codes, told)])
    own = {each.name for each in event.chances if isinstance(each, OwnNumber)}
    for name in sorted(own):
        rows = [f"{each.name} {dict(each.numbers)[name]}" for each in told.materials if name in dict(each.numbers)]
        lines += _wrapped(f"    {name}: ", [*rows, "else 1"])
    return lines


def words_for(codes, told):
    """Return what a capital stands for, in words."""
    names = [each.name for each in told.materials]
    inside, outside = [names[code] for code in sorted(codes)], [n for code, n in enumerate(names) if code not in codes]
    if len(outside) * 2 < len(names):
        return f"everything{', but ' if outside else ''}{' and '.join(outside)}"
    return ", ".join(inside) or "nothing"


def _columns(rows):
    """Return rows of texts as lines with aligned columns."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(text.ljust(width) for text, width in zip(row, widths, strict=True)).rstrip() for row in rows]


def _wrapped(head, words):
    """Return a head and words, parted by commas, as lines that fit; no line where there are no words."""
    lines, line = [], head
    for number, word in enumerate(words):
        last = number + 1 == len(words)
        if len(line) + len(word) > _WIDTH and line.strip() != head.strip():
            lines.append(line)
            line = " " * len(head)
        line += word if last else f"{word}, "
    return [*lines, line] if words else []
