"""Prints modules of Python as modules of JavaScript: a small part of the language, and errors for all else."""
