"""Gates as C: declarations of words, one for each gate of a circuit."""

from game.core.compiler.circuit import FALSE, TRUE
from game.export.c_text import WIDTH

CORNERS = "abcd"


class GateText:
    """Writes gates of a Plan's circuit, each once in the scope that is open; bit 0 of the corner a is called a0."""

    def __init__(self, plan):
        self.circuit = plan.circuit
        self._names = {}  # node -> (name, whether it holds the inverse)
        for corner, letter in enumerate(CORNERS):
            for bit in range(plan.bits):
                self._names[1 + corner * plan.bits + bit] = f"{letter}{bit}", False
        if plan.fair is not None:
            self._names[1 + plan.fair] = "fair", False

    def scope(self):
        """Return what is known here, to be handed to `leave`."""
        return dict(self._names)

    def leave(self, known):
        """Forget the gates written since `scope`."""
        self._names = known

    def declarations(self, literals, indent):
        """Return the lines that work out literals, as far as no line has yet."""
        parts = []
        for node in self.circuit.cone(literals):
            if node not in self._names:
                text, inverted = self._gate(self.circuit.gates[node])
                self._names[node] = f"n{node}", inverted
                parts.append(f"n{node} = {text}")
        return declared(parts, indent)

    def literal(self, literal):
        """Return the C expression of a literal that has been worked out."""
        if literal in (FALSE, TRUE):
            return "(open & ~open)" if literal == FALSE else "(open | ~open)"
        name, inverted = self._held(literal)
        return f"~{name}" if inverted else name

    def _gate(self, gate):
        """Return the expression of a gate, and whether that is its inverse."""
        (x, x_inverted), (y, y_inverted) = (self._held(literal) for literal in (gate.x, gate.y))
        if gate.op == "xor":
            return f"{x} ^ {y}", x_inverted != y_inverted
        if x_inverted and y_inverted:
            return f"{x} | {y}", True
        if x_inverted:
            x, y, y_inverted = y, x, True
        return f"{x} & {'~' * y_inverted}{y}", False

    def _held(self, literal):
        name, inverted = self._names[literal >> 1]
        return name, inverted != bool(literal & 1)


def declared(parts, indent):
    """Return lines that declare constants, from parts such as 'n7 = a0 & b0'."""
    lines, line = [], ""
    for part in parts:
        if line and len(indent) + len(line) + len(part) + 3 > WIDTH:
            lines.append(f"{indent}{line};")
            line = ""
        line += f", {part}" if line else f"const sg_word {part}"
    return [*lines, f"{indent}{line};"] if line else lines
