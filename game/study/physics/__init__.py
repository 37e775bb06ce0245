"""Sand as physics."""
