"""The words of the parts of frames for identities."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.identity_words import Words, order_of, value_words
from fieldspec.codec.layout.part import PartLayout
from fieldspec.language.model import codecs
from fieldspec.language.model.checksums import checksum_named

_HASHED_ROLES = {"checksum": "check", "unit_address": "station"}
"""The words for roles in the hash. With them, a rename of a role changes no identity."""


def part_words(part: PartLayout) -> Iterator[Words]:
    """The place and the value of a part, and what it counts, covers or repeats. The number of a reserved part means
    nothing, so that only the size of its type counts.
    """
    words = value_words(part.value)
    if part.reserved and words:
        words = (f"u{8 * part.size}", *words[1:])
    role = _HASHED_ROLES.get(part.role, part.role)
    order = order_of(part.value, part.order) if part.size > 1 or not part.width else ""
    yield part.name, role, part.offset, part.size, part.algorithm, order, *words
    yield from _span(part)


def _span(part: PartLayout) -> Iterator[Words]:
    """The parts that a part counts, covers or repeats, and whether it is reserved; empty for the default."""
    usual = part.role != "checksum" or (part.start, part.stop) == (0, part.offset)
    if not usual or (part.unit_size, part.base, part.reserved) != (1, 0, False):
        yield "span", part.start, part.stop, part.unit_size, part.base, part.reserved
    if part.digits:
        yield "digits", part.digits
    name = checksum_named(part.algorithm).codec if part.algorithm else ""
    if name:
        yield "codec", codecs.checksum_codec(name).version
    if part.before_escape and not part.escaped:
        yield ("before escape",)
    if part.part.same_as:
        yield "repeats", part.part.same_as
    if part.part.bits is not None:
        yield "bits", part.part.bits
