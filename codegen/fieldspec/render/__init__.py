"""Findings as text for people and for programs. One form a file."""
