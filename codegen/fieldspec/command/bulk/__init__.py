"""Captures and logs in bulk, into tables."""
