"""Names of a device as options of the command line."""

from __future__ import annotations


def option_word(name: str) -> str:
    """A name of the device as the name of an option."""
    return name.replace("_", "-")


def option_text(name: str) -> str:
    """An option in a remark: `--link`."""
    return f"--{option_word(name)}"
