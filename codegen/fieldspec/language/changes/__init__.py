"""The differences of two versions of a device, and whom they affect.

Each rule is a function in `rules/`, named after what happened. `table` lists them; it is imported on first use.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fieldspec.language.changes.table import RULES, changes

__all__ = ["RULES", "changes"]


def __getattr__(name: str) -> object:
    if name in __all__:
        return getattr(import_module("fieldspec.language.changes.table"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
