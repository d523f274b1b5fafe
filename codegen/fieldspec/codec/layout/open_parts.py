"""Parts of requests whose values no spec states: those that clients count, and those that users choose."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.value import Value

_SEQUENCE_WORDS = frozenset({"counter", "reference", "sequence", "transaction"})
"""The words of names that say that a part numbers the requests, if the response has a part with the same name."""


@dataclass(frozen=True, slots=True)
class OpenPart:
    """A plain part before the body of a request that has no constant.

    `repeated` is the part of the response that repeats it, None where none does. `numbering` is the first and the last
    number of a part that clients count, None for one that users choose.
    """

    part: PartLayout
    repeated: PartLayout | None
    numbering: tuple[int, int] | None


def open_parts(link: LinkLayout) -> list[OpenPart]:
    """The open parts of the requests on a link, in the order of the frame.

    A part counts if the response repeats it and its name says that it numbers requests. Any other may be the address of
    a device, which only users know.
    """
    parts = [part for part in link.request.header if part.role == "plain" and part.is_argument]
    return [_open_part(part, _repeated(link, part)) for part in parts]


def _open_part(part: PartLayout, repeated: PartLayout | None) -> OpenPart:
    is_number = repeated is not None and _names_sequence(part.name)
    return OpenPart(part, repeated, _numbers(part.value) if is_number else None)


def _names_sequence(name: str) -> bool:
    return not _SEQUENCE_WORDS.isdisjoint(name.split("_"))


def _repeated(link: LinkLayout, part: PartLayout) -> PartLayout | None:
    """The part of the response that repeats a part of the request."""
    candidates = [other for other in link.response.header if other.role == "plain" and other.is_argument]
    stated = next((other for other in candidates if other.part.same_as == part.name), None)
    if stated is not None or not _names_sequence(part.name):
        return stated
    return next((other for other in candidates if other.name == part.name and not other.part.same_as), None)


def _numbers(value: Value | None) -> tuple[int, int] | None:
    """The first and the last of the numbers that a part can count; None for a value that has a meaning."""
    if value is None or value.enum or value.flags or value.unit or value.scale != 1 or value.offset:
        return None
    if not is_count(value.encoding):
        return None
    if value.ranges is None:
        return (0, value.high)
    return max(merged(value.ranges.intervals), key=lambda interval: interval[1] - interval[0])
