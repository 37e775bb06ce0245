"""What is drawn over and beside the sand."""
