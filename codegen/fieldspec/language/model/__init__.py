"""The model of a device: frozen, complete dataclasses, one kind of object per file."""
