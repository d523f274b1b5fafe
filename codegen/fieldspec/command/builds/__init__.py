"""What `build` does: finds out what has changed, makes it with all processors, and keeps a record."""
