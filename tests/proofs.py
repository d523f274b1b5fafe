"""Long proofs: `make proofs` runs the whole of them, and any other run a share that is always the same."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import TypeVar

Case = TypeVar("Case")

IS_WHOLE = os.environ.get("FIELDSPEC_PROOFS") == "all"


def share(cases: Sequence[Case], most: int = sys.maxsize) -> list[Case]:
    """All cases, or so many of them that lie evenly among the others."""
    if IS_WHOLE or len(cases) <= most:
        return [*cases]
    return [cases[number * len(cases) // most] for number in range(most)]
