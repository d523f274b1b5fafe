"""How many random inputs a test tries."""

from __future__ import annotations

import os

from hypothesis import settings

from proofs import IS_WHOLE

FACTOR = int(os.environ.get("FIELDSPEC_EXAMPLES", "1"))
"""How many times more inputs than usual are tried; `make test-night` raises it."""


def examples(count: int) -> settings:
    """The settings of a test that tries `count` inputs where proofs are whole, and otherwise half as many."""
    return settings(max_examples=count * FACTOR // (1 if IS_WHOLE else 2), deadline=None)
