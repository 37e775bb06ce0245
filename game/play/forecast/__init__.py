"""The forecast over the sand."""
