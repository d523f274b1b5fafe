"""What differs between two versions of a device, and who is hurt. One file a rule, named by what happened.

The table of all rules is in `table`. It is imported when it is first asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fieldspec.changes.table import RULES, changes

__all__ = ["RULES", "changes"]


def __getattr__(name: str) -> object:
    if name in __all__:
        return getattr(import_module("fieldspec.changes.table"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
