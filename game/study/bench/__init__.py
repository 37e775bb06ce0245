"""The bench: how fast the sand is, beside the paper, its peers and the memory's own pace.

A row of a table is timed only after its cells were found equal to those of the plain twin (`checks`). What is timed
takes turns, round by round (`rounds`), from the same world each time (`worlds`), so that a noisy moment or sand that
has come to rest favours nobody. `plan` says how much is measured, `goals` what is wanted. Each other module makes one
section of the report, and `command` runs them all.
"""
