"""What can be chosen and is no number: a switch, one of a few, a list of names. They are asked like a Knob."""

from dataclasses import dataclass

LONGEST_NAME = 60  # characters
MOST_NAMES = 100


@dataclass(frozen=True)
class Switch:
    """Something that is on or off."""

    name: str
    default: bool
    meaning: str

    wanted = "true or false"

    def check(self, value):
        """Return `value`, or raise ValueError saying what is wanted."""
        if not isinstance(value, bool):
            raise ValueError(f"{self.name} must be {self.wanted}, got {value!r}")
        return value


@dataclass(frozen=True)
class Choice:
    """One of a few words."""

    name: str
    default: str
    options: tuple
    meaning: str

    @property
    def wanted(self):
        """The options in words."""
        return f"one of {', '.join(self.options)}"

    def check(self, value):
        """Return `value`, or raise ValueError saying what is wanted."""
        if not isinstance(value, str) or value not in self.options:
            raise ValueError(f"{self.name} must be {self.wanted}, got {value!r}")
        return value


@dataclass(frozen=True)
class Names:
    """A list of short words, each once."""

    name: str
    meaning: str
    default: tuple = ()

    wanted = f"a list of at most {MOST_NAMES} words"

    def check(self, value):
        """Return the words as a tuple, or raise ValueError saying what is wanted."""
        if not isinstance(value, list | tuple) or len(value) > MOST_NAMES or not all(map(_is_name, value)):
            raise ValueError(f"{self.name} must be {self.wanted}, got {value!r}")
        return tuple(dict.fromkeys(value))


def _is_name(value):
    return isinstance(value, str) and 0 < len(value) <= LONGEST_NAME and value.isascii() and value.isprintable()
