"""A scene as it is played: acts, time, undo, recordings and journals."""
