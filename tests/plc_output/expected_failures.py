"""What fails of test_blocks_against_models.py and of test_blocks_at_random.py until the blocks are mended."""

from __future__ import annotations

BROKEN: dict[str, frozenset[int]] = {}
"""The rules that the blocks of each device break at random. A number goes when no block breaks the rule any more."""
EXPECTED: dict[str, tuple[str, tuple[str, ...]]] = {}
"""The scenes that fail, by test, with the item that mends them."""
