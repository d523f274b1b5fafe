"""Where a fact of the model stands in the spec."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from fieldspec.source import Span, Spanned


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """The place of a fact: its path, what stands there, and the values of its keys.

    These are whatever has a span: the nodes that were read, which are worked into spans when somebody asks, or spans.
    """

    path: str
    stated: Spanned
    values: Mapping[str, Spanned]

    @property
    def whole(self) -> Span:
        """Where the fact stands."""
        return self.stated.span

    @property
    def spans(self) -> dict[str, Span]:
        """Where the values of its keys stand."""
        return {key: value.span for key, value in self.values.items()}

    def __getitem__(self, key: str) -> Span:
        """The span of a key's value; where the key is not given, that of the fact's name."""
        values = self.values
        value = values.get(key) or values.get("name") or values.get("id") or self.stated
        return value.span

    def __contains__(self, key: object) -> bool:
        return key in self.values
