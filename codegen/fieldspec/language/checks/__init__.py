"""What holds in a good spec. One file a check, named by what holds when it passes.

The table of all checks is in `table`. It is imported when it is first asked for, so that a verb that uses one check
does not wait for all.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fieldspec.language.checks.table import CHECKS, INSTALLED, run, run_named

__all__ = ["CHECKS", "INSTALLED", "run", "run_named"]


def __getattr__(name: str) -> object:
    if name in __all__:
        return getattr(import_module("fieldspec.language.checks.table"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
