"""Parts of requests whose values no spec states: those that clients count, and those that users choose."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.layout.frame import LinkLayout, PartLayout
from fieldspec.model.ranges import merged
from fieldspec.model.value import Kind, Value

_SEQUENCE_WORDS = frozenset({"counter", "reference", "sequence", "transaction"})
"""The words of names that say that a part numbers the requests, if the response has a part with the same name."""
_ADDRESS_WORDS = frozenset(
    {
        *("address", "axis", "channel", "destination", "device", "drive", "line"),
        *("module", "network", "node", "slave", "source", "station", "unit"),
    }
)
"""The words of names that say where a request goes: another number is that of another device."""


@dataclass(frozen=True, slots=True)
class OpenPart:
    """A plain part before the body of a request that has no constant.

    `repeated` is the part of the response that repeats it, None where none does. `numbering` is the first and the last
    number of a part that clients count, None for one that users choose. A `choosable` part is one that users may
    choose: all but those whose names say that they are the numbers of requests.
    """

    part: PartLayout
    repeated: PartLayout | None
    numbering: tuple[int, int] | None
    choosable: bool


def open_parts(link: LinkLayout) -> list[OpenPart]:
    """The open parts of the requests on a link, in the order of the frame.

    Of several parts that the response repeats, those count whose names say that they number requests: others are
    mostly addresses. One alone counts unless its name says that it is an address.
    """
    parts = [part for part in link.request.header if part.role == "plain" and part.is_argument]
    repeated = {part.name: other for part in parts if (other := _repeated(link, part)) is not None}
    numbers = {part.name: span for part in parts if part.name in repeated and (span := _numbers(part.value))}
    named = {name for name in numbers if _names_sequence(name)}
    alone = {name for name in numbers if len(repeated) == 1 and _ADDRESS_WORDS.isdisjoint(name.split("_"))}
    numbering = named or alone
    return [
        OpenPart(
            part,
            repeated.get(part.name),
            numbers[part.name] if part.name in numbering else None,
            part.name not in named,
        )
        for part in parts
    ]


def _names_sequence(name: str) -> bool:
    return not _SEQUENCE_WORDS.isdisjoint(name.split("_"))


def _repeated(link: LinkLayout, part: PartLayout) -> PartLayout | None:
    """The part of the response that repeats a part of the request."""
    others = [other for other in link.response.header if other.role == "plain" and other.is_argument]
    stated = next((other for other in others if other.part.same_as == part.name), None)
    if stated is not None or not _names_sequence(part.name):
        return stated
    return next((other for other in others if other.name == part.name and not other.part.same_as), None)


def _numbers(value: Value | None) -> tuple[int, int] | None:
    """The first and the last of the numbers that a part can count; None for a value that has a meaning."""
    if value is None or value.enum or value.flags or value.unit or value.scale != 1 or value.offset:
        return None
    if value.type.kind is not Kind.INTEGER:
        return None
    if value.ranges is None:
        return (0, value.high)
    return max(merged(value.ranges.intervals), key=lambda interval: interval[1] - interval[0])
