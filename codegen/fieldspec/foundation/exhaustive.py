"""The branch of a `match` that no value reaches, by which type checkers name the case that has no branch."""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import NoReturn


def assert_never(value: NoReturn) -> NoReturn:
    """Ends a `match` over a closed type. Raises AssertionError for a case that type checkers were not asked about."""
    raise AssertionError(f"no branch for {value!r}")
