"""Routines as trees: expressions, and the statements of a routine."""
