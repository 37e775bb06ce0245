"""A line of text that is being typed: new letters go to its end, or in place of all of it at first."""

from typing import NamedTuple

import pygame

LONGEST = 60  # characters
TYPING_KEYS = frozenset(
    {pygame.K_BACKSPACE, pygame.K_DELETE, pygame.K_LEFT, pygame.K_RIGHT, pygame.K_HOME, pygame.K_END}
)


class TextLine(NamedTuple):
    """What has been typed so far."""

    text: str
    fresh: bool = True  # what is typed next takes the place of all of it

    def typed(self, key, text):
        """Return the line after a key that may have typed a text."""
        if key == pygame.K_BACKSPACE:
            return TextLine("" if self.fresh else self.text[:-1], False)
        if key == pygame.K_DELETE:
            return TextLine("", False)
        if key in TYPING_KEYS:
            return TextLine(self.text, False)
        before = "" if self.fresh else self.text
        return TextLine((before + text)[:LONGEST], False) if types(text) else self


def types(text):
    """Return whether a key types letters with that text."""
    return text != "" and text.isprintable()
