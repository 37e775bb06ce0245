"""The sand against the paper."""
