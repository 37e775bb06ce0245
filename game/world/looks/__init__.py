"""What cells look like."""
