"""What a scene file says, and how scenes are made, saved and opened."""
