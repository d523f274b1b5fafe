"""Lists whose elements say by their bits whether another one follows, so that the last one ends the list."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.presence import PresenceLayout, presence_data
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class Continuation:
    """Another element follows one whose number, `size` bytes at `offset` in it, has the bits of a `presence`.

    It is the number of the field `by` which the presence names, or the element itself where that names none. If not all
    numbers are permitted, `legal` are one with which another element follows, and one with which none does.
    """

    presence: PresenceLayout
    offset: int
    size: int
    order: Literal["big", "little"]
    legal: tuple[int | None, int | None] | None = None

    def number_in(self, element: object) -> int:
        """The number of an element, which is given as bytes, by the values of its fields, or is the number."""
        if isinstance(element, bytes):
            return int.from_bytes(element[self.offset : self.offset + self.size], self.order)
        number = element[self.presence.by] if isinstance(element, Mapping) else element
        assert isinstance(number, int)
        return number

    def follows(self, element: object) -> bool:
        """Whether another element follows one."""
        return self.presence.is_met(self.number_in(element))

    def wrong_element(self, elements: Sequence[object]) -> int | None:
        """The first element that is wrong about whether another one follows, None where none is."""
        last = len(elements) - 1
        return next((index for index, own in enumerate(elements) if self.follows(own) != (index < last)), None)

    def text(self, name: str, elements: Sequence[object], index: int) -> str:
        """The statement of a wrong element of the list with a name."""
        number = f"{self.presence.by or name} is {self.number_in(elements[index])} in element {index} of {name}"
        return f"{number}, which says that {'none' if index < len(elements) - 1 else 'another one'} follows"

    def ended(self, elements: Sequence[Any]) -> list[Any]:
        """Elements, of which only the last one says that none follows; what else they say stays, as far as possible."""
        last = len(elements) - 1
        return [self._with_bits(own, index < last) for index, own in enumerate(elements)]

    def _with_bits(self, element: Any, follows: bool) -> Any:
        if self.follows(element) == follows:
            return element
        if self.legal is None:
            mask = self.presence.mask
            rest = self.number_in(element) & ~mask
            number: int | None = rest if (0 in self.presence.numbers) == follows else rest | (mask & -mask)
        else:
            number = self.legal[0 if follows else 1]
        if number is None:
            return element
        return {**element, self.presence.by: number} if isinstance(element, Mapping) else number


def continuation_data(continuation: Continuation) -> dict[str, Any]:
    """What elements say, as programs in JavaScript have it."""
    is_little = {"little": True} if continuation.order == "little" else {}
    place = {"at": continuation.offset, "length": continuation.size, **is_little}
    return {**place, **presence_data(continuation.presence)}
