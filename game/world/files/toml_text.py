"""TOML read at a price that its length bounds."""

import re
import tomllib

DEEPEST = 16  # parts of a dotted key: reading one takes the square of their number
QUOTED = re.compile(  # texts and comments, also those without an end
    r'"""(?:[^"\\]++|\\.|"(?!""))*+(?:""")?|'
    r"'''(?:[^']++|'(?!''))*+(?:''')?|"
    r'"(?:[^"\\\n]++|\\[^\n])*+"?|'
    r"'[^'\n]*+'?|"
    r"#[^\n]*+",
    re.DOTALL,
)
DEEP = re.compile(rf"(?<![\w-])[\w-]++(?:[ \t]*+\.[ \t]*+[\w-]++){{{DEEPEST}}}")


def parse_toml(text):
    """Return the values of TOML; raise ValueError or RecursionError for what is none or has too deep a key."""
    if DEEP.search(QUOTED.sub("x", text)):
        raise ValueError(f"a key of more than {DEEPEST} parts")
    return tomllib.loads(text)
