"""What is exported, rewritten by hand and imported comes back with the same facts, or the import says which do not."""

from __future__ import annotations

from rewritten_lists import came_back

LISTS = 30
"""The share of the lists; `make fuzz-lists` draws more."""


def test_no_fact_of_a_rewritten_export_is_wrong_in_silence() -> None:
    outcome = came_back(1, 600, LISTS)
    assert outcome.silent == []
    assert outcome.lists >= LISTS
    assert outcome.right > 50 * len(outcome.noted)
