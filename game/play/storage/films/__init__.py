"""Films: worlds as frames, and files of frames in several formats."""
