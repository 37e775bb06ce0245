"""What keys, mouse and touch do."""
