"""Decodes captures and logs in bulk: packets, frames and values as columns, without Python for each value."""
