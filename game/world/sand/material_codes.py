"""Which materials the codes of a world's cells stand for."""

from dataclasses import dataclass
from functools import cached_property

AIR, SAND_NAME, WALL_NAME = "air", "sand", "wall"


@dataclass(frozen=True)
class MaterialCodes:
    """The names of the materials by code, air first."""

    names: tuple
    forms: tuple = ()  # for each code the name of the material that it is to the player; its own if left out

    @cached_property
    def wall(self):
        """The code of walls, which is that of the outside."""
        return self.names.index(WALL_NAME)

    @cached_property
    def filled(self):
        """The codes of all that is neither air nor wall."""
        return frozenset(range(1, len(self.names))) - {self.wall}

    @property
    def is_sand(self):
        """Whether the cells are air, sand and walls alone, so that grains may have colours."""
        return self == SAND_CODES

    def code(self, name):
        """Return the code of a material, or None if there is no such material."""
        return self.names.index(name) if name in self.names else None

    @property
    def told(self):
        """For each code the name of the material that it is to the player."""
        return self.forms or self.names

    def told_of(self, codes):
        """Return the names of the materials that some codes are to the player, each once, in the order of the codes."""
        return tuple(dict.fromkeys(self.told[code] for code in sorted(codes)))

    @property
    def usual(self):
        """The name of what fills a glass or comes from a tap where nothing else is said: sand, or what comes first."""
        return SAND_NAME if SAND_NAME in self.names else self.names[min(self.filled)]

    def codes_of(self, name):
        """Return the codes that are one material to the player; raise ValueError if there is none of that name."""
        if name not in self.told:
            raise ValueError(f"a material must be one of {', '.join(dict.fromkeys(self.told))}, got {name!r}")
        return frozenset(code for code, form in enumerate(self.told) if form == name)


SAND_CODES = MaterialCodes((AIR, SAND_NAME, WALL_NAME))
EMPTY, SAND, WALL = range(3)  # there


def check_held(rule, world):
    """Raise ValueError unless `rule` is of the materials that a world holds."""
    if rule.codes != world.codes:
        held, wanted = ", ".join(world.codes.names), ", ".join(rule.materials)
        raise ValueError(f"the world holds {held}; the rule {rule.definition.name} is of {wanted}")
