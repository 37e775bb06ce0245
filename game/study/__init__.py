"""Experiments with figures and verdicts; no window."""
