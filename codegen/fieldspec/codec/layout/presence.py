"""Fields that are not always sent, and the bits of an earlier field that say whether one is."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.record import Record

if TYPE_CHECKING:
    from typing import Any


@dataclass(frozen=True, slots=True)
class PresenceLayout:
    """A field is sent if the bits `mask` of the number of the field `by` are one of `numbers`."""

    by: str
    mask: int
    numbers: tuple[int, ...]

    def is_met(self, number: int) -> bool:
        """Whether a number says that the field is sent."""
        return number & self.mask in self.numbers

    def text(self, name: str, number: int) -> str:
        """The statement of a number about the field with a name."""
        return f"{self.by} is {number}, which says that {name} is{'' if self.is_met(number) else ' not'} sent"


def presence_layout(record: Record, name: str, enums: Mapping[str, Enum]) -> PresenceLayout | None:
    """The bits that say whether a field of a record is sent, None for one that always is."""
    field = record.named(name)
    presence = field.presence if field is not None else None
    selector = record.named(presence.by) if presence is not None else None
    if presence is None or selector is None or selector.value is None:
        return None
    if presence.bit is not None:
        return PresenceLayout(presence.by, 1 << presence.bit, (presence.value << presence.bit,))
    members = (enums[selector.value.enum].named(member) for member in presence.when)
    numbers = sorted({member.value for member in members if member is not None})
    return PresenceLayout(presence.by, (1 << 8 * selector.value.size) - 1, tuple(numbers))


def presence_data(presence: PresenceLayout) -> dict[str, Any]:
    """A presence as programs in JavaScript have it."""
    return {"by": presence.by, "mask": presence.mask, "numbers": [*presence.numbers]}
