"""How many random inputs a test tries."""

from __future__ import annotations

import os

from hypothesis import settings

FACTOR = int(os.environ.get("FIELDSPEC_EXAMPLES", "1"))
"""How many times more inputs than usual are tried; `make test-night` raises it."""


def examples(count: int) -> settings:
    """The settings of a test that usually tries `count` inputs, however long one of them takes."""
    return settings(max_examples=count * FACTOR, deadline=None)
