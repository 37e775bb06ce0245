"""Cells to pixels."""
