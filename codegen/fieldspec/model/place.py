"""Where a fact of the model stands in the spec."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass
from fieldspec.source import Span


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """The place of a fact: its path, and the spans of its keys' values."""

    path: str
    whole: Span
    spans: Mapping[str, Span]

    def __getitem__(self, key: str) -> Span:
        """The span of a key's value; where the key is not given, that of the fact's name."""
        span = self.spans.get(key) or self.spans.get("name") or self.spans.get("id")
        return span or self.whole

    def __contains__(self, key: object) -> bool:
        return key in self.spans
