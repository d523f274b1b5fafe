"""Installed packages that bring outputs, checks and protocols."""
