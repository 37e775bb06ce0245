"""The sand against exact probabilities."""
