"""Dyes: the names of the colours that sand can have, and how they look in a picture file."""

DYED = {  # RGB in a picture file; the window has colours of its own for each theme
    "amber": (222, 170, 84),
    "terracotta": (196, 88, 60),
    "rose": (226, 132, 140),
    "plum": (124, 70, 118),
    "indigo": (62, 78, 150),
    "teal": (58, 148, 156),
    "moss": (128, 152, 66),
    "ivory": (240, 230, 204),
}
COLOURS = tuple(DYED)  # a colour's number is its place here; the first is that of sand that was given none
AMBER = COLOURS[0]
RAINBOW = "rainbow"  # stripes of all of them
DYES = (*COLOURS, RAINBOW)  # what sand can be painted with
