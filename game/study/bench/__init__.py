"""The bench: how fast the sand is, beside the paper, its peers and the memory's own pace.

A row of a table is timed only after its cells were found equal to those of the plain twin (`checks`). Candidates take
turns, round by round (`rounds`), from the same world each time (`worlds`), so that a noisy moment or sand that has
come to rest favours none of them. `plan` says how much is measured, `goals` what is wanted, each other module makes
one `table`, and `command` runs them all.
"""
