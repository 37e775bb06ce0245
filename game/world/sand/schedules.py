"""Schedules: which partition is used when."""

# The offset (x, y) of the blocks' upper left corner, in cells, iteration by iteration, repeated.
SCHEDULES = {
    "margolus": ((0, 0), (1, 1)),
    "paper": ((0, 0), (1, 1), (0, 1), (1, 0)),
    "balanced": ((0, 0), (1, 1), (1, 0), (0, 1)),
}
