"""The laws of the window: what a hand on mouse and keys may rely on."""
