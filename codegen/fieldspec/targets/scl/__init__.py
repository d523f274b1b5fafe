"""External sources and constants for TIA Portal: types, data blocks, functions, and a tag table."""
