"""The window, its layout and the machine around it."""
