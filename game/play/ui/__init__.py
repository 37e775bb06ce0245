"""The panel toolkit: controls that are a pure function of the events and values they are given."""
