"""The panel beside the sand."""
