"""Explains the bytes of frames, from the layout alone."""
