"""Plots of what the sand does."""
