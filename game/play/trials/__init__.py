"""Programs that try the window."""
