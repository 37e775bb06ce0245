"""Text in C: lists in lines, strings, and words in comments."""

WIDTH = 120  # characters of a line


def listed(entries, indent=4, parted=",\n"):
    """Return entries of a list, as many in a line as fit, each line but the first indented anew."""
    lines, line = [], ""
    for entry in entries:
        if line and indent + len(line) + len(entry) + 3 > WIDTH:
            lines.append(line)
            line = entry
        else:
            line += f", {entry}" if line else entry
    return " " * indent + (parted + " " * indent).join([*lines, line])


def text(words):
    """Return a string as C spells it."""
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def plain(words):
    """Return words that can stand in a comment."""
    shown = "".join(sign if sign.isprintable() else " " for sign in words)
    return shown.replace("*/", "* /").replace("/*", "/ *").replace("\\", "/").replace("?", " ?")
