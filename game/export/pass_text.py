"""A plan as C: functions that run one layer of an iteration on the blocks of many words, one after the other.

What they do is what `game.core.compiler.vector_ir` does, with all thresholds as data: any chance may come to be 0 or 1.
A layer has a function of its own, as the code of all of them together would not stay in a processor's nearest cache.
"""

from itertools import pairwise

from game.core.compiler.circuit import FALSE
from game.export.c_text import WIDTH, listed
from game.export.gates import CORNERS, GateText, declared

LAYER = """\
/* Layer {number}: {name}. */
static int sg_layer_{number}(const sandglass *world, uint64_t *const *from, uint64_t *blocks, uint64_t place,
                       uint32_t size)
{{
    uint64_t
{streams};
    uint32_t i;
    int told = 0;
    {digits}
    {origin}
    for (i = 0; i < size; i += SG_LANES{next}) {{
{loads}
        const sg_word open = SG_LOAD(blocks + i);
{body}    }}
    return told;
}}
"""
PASS = """\
static int sg_pass(const sandglass *world, uint64_t *const *from, uint64_t *blocks, uint64_t place, uint32_t size)
{
    int told = 0;
"""


def pass_text(plan, layer_names):
    """Return the C functions of a Plan: one for each layer, and sg_pass."""
    first, told = 0, []
    last = max((number for number, layer in enumerate(plan.layers) if layer.event != FALSE), default=-1)
    text = ""
    for number, layer in enumerate(plan.layers):
        if layer.event != FALSE:
            text += _LayerText(plan, number, number < last).text(layer_names[number], first) + "\n"
            told.append(f"    told |= sg_layer_{number}(world, from, blocks, place, size);\n")
        first += len(layer.groups)
    return f"{text}{PASS}{''.join(told)}    return told;\n}}\n"


class _LayerText:
    """Writes the function of a layer; `is_followed`: whether later ones ask which blocks are left."""

    def __init__(self, plan, number, is_followed):
        self.plan, self.number, self.layer = plan, number, plan.layers[number]
        self.is_followed = is_followed
        self.gates = GateText(plan)

    def text(self, name, first_group):
        streams = self._streams()
        places = [f"*const at_{each} = from[{n}]" for each, n in streams.items()]
        digits = f"const uint64_t *const digits = world->digits + {first_group} * SG_DIGITS;"
        origin = "sg_word origin = sg_lanes(place, SG_STEP); /* where the draws of these words start */"
        random = bool(self.layer.groups) or self._asks_fair_bit()
        return LAYER.format(
            number=self.number,
            name=name,
            streams=listed(places, 8),
            digits=digits if self.layer.groups else "(void)world;",
            origin=origin if random else "(void)place;",
            next=", origin += SG_LANES * SG_STEP" if random else "",
            loads="\n".join(declared([f"{each} = SG_LOAD(at_{each} + i)" for each in streams], " " * 8)),
            body="".join(f"{line}\n" for line in self._body()),
        )

    def _streams(self):
        """Return {name: number} of the bits of corners that the layer reads or changes."""
        found, bits = {}, self.plan.bits
        changed = {key for level in self.layer.deltas for key in level}
        for corner, letter in enumerate(CORNERS):
            for bit in range(bits):
                number = corner * bits + bit
                if (corner, bit) in changed or self.plan.circuit.uses(self._literals(), number):
                    found[f"{letter}{bit}"] = number
        return found

    def _literals(self):
        """Return all literals that the layer works out."""
        layer, watch = self.layer, [self.plan.watch] if self.plan.watch is not None else []
        changes = [literal for level in layer.deltas for literal in level.values()]
        return [*watch, layer.event, *layer.sure, *(group.blocks for group in layer.groups), *changes]

    def _asks_fair_bit(self):
        """Return whether a fair bit decides between a picture and its mirror image."""
        return self.plan.fair is not None and self.plan.circuit.uses(self._literals(), self.plan.fair)

    def _body(self):
        indent, layer = " " * 8, self.layer
        lines = []
        if self.plan.watch is not None:
            lines += self.gates.declarations([self.plan.watch], indent)
            lines += [f"{indent}if (!sg_any({self.gates.literal(self.plan.watch)} & open)) continue;"]
        lines += self.gates.declarations([layer.event], indent)
        lines += [f"{indent}if (!sg_any({self.gates.literal(layer.event)} & open)) continue;"]
        lines += [f"{indent}told = 1;", *self._decide(indent)]
        yes = [f"yes{level}" for level in range(len(layer.sure))]
        lines += [f"{indent}if (!sg_any({yes[-1]})) continue;"]
        if self.is_followed:
            lines += [f"{indent}SG_STORE(blocks + i, open & ~{yes[-1]});"]
        return lines + self._act(yes, indent)

    def _decide(self, indent):
        """Return the lines that say in which blocks an outcome happens."""
        layer, groups = self.layer, self.layer.groups
        wanted = [*layer.sure, *(group.blocks for group in groups)]
        lines = []
        if self._asks_fair_bit():
            lines += [f"{indent}const sg_word fair = sg_mix(origin + SG_FAIR_STEP);"]
        lines += self.gates.declarations(wanted, indent)
        lines += declared([f"group{at} = {self.gates.literal(each.blocks)}" for at, each in enumerate(groups)], indent)
        levels = range(len(layer.sure))
        sure = [f"yes{level} = {self.gates.literal(layer.sure[level])} & open" for level in levels]
        lines += [f"{indent}sg_word {', '.join(sure)};"]
        if groups:
            lines += self._draw(indent)
        return lines + [f"{indent}yes{high} |= yes{low};" for low, high in pairwise(levels)]

    def _draw(self, indent):
        """Return the loop that compares random numbers with thresholds, digit by digit."""
        own = {}
        for at, group in enumerate(self.layer.groups):
            own.setdefault(group.level, []).append(at)
        lines = []
        certain = [f"{indent}if (world->certain[{self.number}]) {{"]
        for level, groups in own.items():
            lines += _or(f"{indent}sg_word rest{level} = open & (", [f"group{at}" for at in groups], ");")
            certain += self._bound(level, groups, indent + "    ", "digits")
            certain += [
                f"{indent}    yes{level} |= rest{level} & bound{level};",
                f"{indent}    rest{level} &= ~bound{level};",
            ]
        rests = " | ".join(f"rest{level}" for level in own)
        lines += [
            *certain,
            f"{indent}}}",
            f"{indent}sg_word draw = origin{f' + {self.number} * SG_LAYER_STEP' if self.number else ''};",
            f"{indent}const uint64_t *ones = digits + {len(self.layer.groups)};",
            f"{indent}for (uint32_t n = world->draws[{self.number}]; n && sg_any({rests}); n--, "
            f"ones += {len(self.layer.groups)}, draw += SG_GOLDEN) {{",
            f"{indent}    const sg_word random = sg_mix(draw);",
        ]
        for level, groups in own.items():
            lines += self._bound(level, groups, indent + "    ", "ones")
            lines += [
                f"{indent}    yes{level} |= rest{level} & bound{level} & ~random;",
                f"{indent}    rest{level} &= ~(random ^ bound{level});",
            ]
        return [*lines, f"{indent}}}"]

    def _bound(self, level, groups, indent, digits):
        """Return the lines that work out a digit of the thresholds of all blocks."""
        terms = [f"(group{at} & {digits}[{at}])" for at in groups]
        return _or(f"{indent}const sg_word bound{level} = ", terms, ";")

    def _act(self, yes, indent):
        """Return the lines that store what the outcomes change."""
        deltas = self.layer.deltas
        own = [yes[0], *(f"({now} & ~{before})" for before, now in pairwise(yes))]
        lines = self.gates.declarations([literal for level in deltas for literal in level.values()], indent)
        for corner, bit in sorted({key for level in deltas for key in level}):
            terms = [
                f"({mine} & {self.gates.literal(delta[corner, bit])})"
                for mine, delta in zip(own, deltas, strict=True)
                if (corner, bit) in delta
            ]
            stream = f"{CORNERS[corner]}{bit}"
            turned = terms[0] if len(terms) == 1 else f"({' | '.join(terms)})"
            lines += [f"{indent}SG_STORE(at_{stream} + i, {stream} ^ {turned});"]
        return lines


def _or(head, terms, tail):
    """Return the lines of an or of many terms."""
    lines, line = [], head + terms[0]
    for term in terms[1:]:
        if len(line) + len(term) + 5 > WIDTH:
            lines.append(f"{line} |")
            line = " " * (len(head) - len(head.lstrip()) + 4) + term
        else:
            line += f" | {term}"
    return [*lines, line + tail]
