"""The scenes of test_blocks_against_models.py that fail today, by test, with the item that mends them."""

from __future__ import annotations

EXPECTED: dict[str, tuple[str, tuple[str, ...]]] = {}
