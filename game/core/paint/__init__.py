"""What tools do to cells."""
