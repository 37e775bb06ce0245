"""What accuracy costs in speed."""
