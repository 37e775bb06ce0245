"""A small rule, to be broken in one place."""

from game import load_rule

TEXT = """title = "Small"
layers = ["reactions", "motion"]
[materials]
air = { letter = ".", class = "empty", colour = "#000000" }
lava = { letter = "l", class = "liquid", density = 40, colour = "#f2561d", flow = "slow" }
wall = { letter = "#", class = "solid", colour = "#78828c" }
stone = { letter = "k", class = "powder", density = 60, colour = "#94918c" }
water = { letter = "w", class = "liquid", density = 20, colour = "#3b7ddd", flow = 0.5 }
[any]
M = "liquid, powder"
X = "everything, but wall"
[chances]
slow = { value = 0.25, label = "lava flows" }
boil = 0.5
[[conserve]]
sum = "lava + stone"
[[conserve]]
sum = "water"
but = ["lava and water"]
[[event]]
name = "lava and water"
chance = ["boil", 0.25]
picture = "lw -> k. | kw"
[[event]]
name = "fall"
layer = "motion"
where = ["M sinks in X"]
picture = '''
M?    X?
X? -> M?
'''
[[event]]
name = "flow"
layer = "motion"
chance = "M.flow"
picture = '''
M.    .M
## -> ##
'''
"""


def line_of(words, text=TEXT):
    """Return the number of the first line that has these words."""
    return next(number for number, line in enumerate(text.split("\n"), 1) if words in line)


def small_rule(folder, *changes):
    """Return the rule with pieces of its text changed: (old, new), ..."""
    return load_rule(written(folder, *changes))


def written(folder, *changes):
    """Return the path of the rule's file, with pieces of its text changed."""
    text = TEXT
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path = folder / "small.toml"
    path.write_text(text, encoding="utf-8")
    return path
