"""A request that a simulated device refuses."""

from __future__ import annotations


class Refusal(Exception):
    """A refused request. `reason` is a word of the key `refuse` of behaviours, `detail` is for the log."""

    def __init__(self, reason: str, detail: str = "") -> None:
        super().__init__(f"{reason}: {detail}" if detail else reason)
        self.reason, self.detail = reason, detail
