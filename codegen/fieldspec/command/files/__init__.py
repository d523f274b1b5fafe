"""Files as verbs read, write and cache them: whole or not at all."""
