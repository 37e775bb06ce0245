"""What a cell of a world can hold: bit 0 of its code is a cell of the planes of sand, bit 1 of those of walls."""

MATERIALS = ("air", "sand", "wall")  # by code
EMPTY, SAND, WALL = range(3)


def check_held(rule):
    """Raise ValueError unless a world can hold the materials of `rule`."""
    if rule.materials != MATERIALS:
        held, wanted = ", ".join(MATERIALS), ", ".join(rule.materials)
        raise ValueError(f"a world holds {held}; the rule {rule.definition.name} is of {wanted}")
