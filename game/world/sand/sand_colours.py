"""Dyes: the names of the colours that sand can have, and how they look in a picture file."""

DYED = {  # RGB in a picture file; the window has colours of its own for each theme
    "amber": (222, 170, 84),
    "terracotta": (199, 106, 82),
    "rose": (244, 180, 198),
    "plum": (129, 87, 140),
    "indigo": (99, 119, 198),
    "teal": (99, 180, 155),
    "moss": (168, 192, 138),
    "ivory": (240, 229, 203),
}
COLOURS = tuple(DYED)  # a colour's number is its place here; the first is that of sand that was given none
AMBER = COLOURS[0]
RAINBOW = "rainbow"  # stripes of all of them
DYES = (*COLOURS, RAINBOW)  # what sand can be painted with
