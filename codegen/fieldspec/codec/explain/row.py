"""The rows of an explanation, the errata that they cite, and a frame without its delimiters and encoding."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.errata import citations, errata_at, errata_of_words
from fieldspec.codec.explain.values import DecodedValue, Meaning
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.escape import CAN_EXTENDED, CAN_REMOTE, Escape
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Link

IDENTIFIER, DLC = "identifier", "DLC"
"""Where the parts of the identifier of a CAN frame are, and the number of bytes that a remote request asks for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ExplanationRow:
    """Some bytes of a frame and their meaning.

    `kind` is `mark`, `part` (of the frame), `field` (of the body), `register`, or `unexplained`.
    `offset` and `length` count bytes of the frame as it is sent, and `raw` are the bytes that they encode. If each byte
    is sent as two characters, `characters` are these, and `length` counts them.
    In a CAN frame, `can_place` is `identifier`, the `DLC` of a remote request, or the number of the first byte in the
    data; otherwise it is empty.
    `path` is the place in the frame, as in `items[0].size`; `fact` is the path of the fact in the spec.
    `number` is the raw value, `value` the exact quantity with its unit.
    `verdict` is empty, `right`, or `wrong: ..`, and `reason` then names the fault as the errors of the codecs do.
    `source` cites the manual, `errata` are the ids of the errata of the fact.
    Rows of registers have an `address`, a number of `words`, which are bits where `unit` is `bit`, and `access`,
    empty if it is not printed.
    """

    kind: str
    offset: int
    length: int
    raw: bytes
    characters: str = ""
    can_place: str = ""
    path: str = ""
    fact: str = ""
    printed_name: str = ""
    label: str = ""
    doc: str = ""
    number: Raw | None = None
    value: str = ""
    meanings: tuple[Meaning, ...] = ()
    verdict: str = ""
    reason: str = ""
    source: str = ""
    notes: tuple[str, ...] = ()
    errata: tuple[str, ...] = ()
    address: int | None = None
    words: int = 0
    unit: str = WORD
    access: str = ""

    @property
    def at(self) -> str:
        """Where its bytes begin, as people count: in a CAN frame from the first byte of the data."""
        return self.can_place or str(self.offset)

    @property
    def sent(self) -> str:
        """The characters of the bytes, or the identifier of a CAN frame as tools for CAN buses write it: `123`."""
        if self.can_place != IDENTIFIER or not self.characters:
            return self.characters
        number = int(self.characters.replace(" ", "")[:8], 16)
        identifier = number & ~CAN_EXTENDED & ~CAN_REMOTE
        return f"{identifier:08X}" if number & CAN_EXTENDED else f"{identifier:03X}"

    @property
    def byte_text(self) -> str:
        """`byte 4`; in a CAN frame `byte 2 of the data`, `the identifier` or `the DLC`."""
        if self.can_place in (IDENTIFIER, DLC):
            return f"the {self.can_place}"
        return f"byte {self.can_place} of the data" if self.can_place else f"byte {self.offset}"


@dataclass(frozen=True, slots=True)
class Spot:
    """Where the bytes of the parts are in a frame: from `start` on, `width` bytes or characters for each.

    `escape` is that of the bytes, if they have one. In a frame with escapes, `originals` are the bytes before they were
    escaped, and `places` the offsets after `start` of what is sent for them, and of the end. `gap` is the place of the
    first byte after an escape of nothing, which is sent between that byte and the one before; None without one.
    """

    frame: bytes
    start: int
    width: int
    places: tuple[int, ...] = ()
    originals: bytes = b""
    escape: Escape | None = None
    gap: int | None = None

    def can_place(self, position: int) -> str:
        """Where the byte at `position` of the parts is in a CAN frame; empty in others, and where it is unreadable."""
        if self.escape is None or self.escape.method != "can" or not self.places:
            return ""
        if position < self.escape.fields_size:
            return IDENTIFIER
        is_remote = self.escape.is_remote(self.frame[self.start :])
        return DLC if is_remote else str(position - self.escape.fields_size)

    def byte_text(self, position: int) -> str:
        """`byte 4` of the frame, or `byte 2 of the data` of a CAN frame, for a byte of the parts."""
        if self.escape is not None and self.escape.method == "can":
            return self.escape.byte_text(position)
        return f"byte {self.place(position, 0)[0]}"

    def place(self, position: int, length: int) -> tuple[int, int, str]:
        """The offset and the length in the frame of `length` bytes of the parts from `position` on; their characters.

        The characters of bytes that are escaped are the bytes that are sent, as hexadecimal digits.
        """
        if self.places:
            end = len(self.places) - 1
            first, stop = self.places[min(position, end)], self.places[min(position + length, end)]
            stop = self.gap if length and position + length == self.gap else stop
            offset = self.start + first
            escaped = self.frame[offset : offset + stop - first]
            return (
                offset,
                len(escaped),
                escaped.hex(" ").upper() if escaped != self.originals[position : position + length] else "",
            )
        offset, length = self.start + position * self.width, length * self.width
        characters = self.frame[offset : offset + length].decode("latin-1") if self.width > 1 else ""
        return offset, length, characters


def fact_row(
    device: Device,
    kind: str,
    path: str,
    fact: Fact,
    spot: Spot,
    position: int,
    raw: bytes,
    read: DecodedValue,
    outer: Fact,
) -> ExplanationRow:
    """The row of a fact whose bytes are at `position` in the parts. A fact without sources has the
    sources of `outer`.
    """
    offset, length, characters = spot.place(position, len(raw))
    errata = (*errata_at(device, fact.place.path), *errata_of_words(device, read.facts))
    return ExplanationRow(
        kind=kind,
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        can_place=spot.can_place(position),
        path=path,
        fact=fact.place.path,
        printed_name=fact.printed_name,
        label=fact.label,
        doc=fact.doc,
        number=read.number,
        value=read.text,
        meanings=read.meanings,
        verdict=read.verdict,
        reason=read.reason,
        source=citations(fact.sources or outer.sources),
        notes=(*fact.notes, *read.notes),
        errata=tuple(dict.fromkeys(errata)),
    )


def wrong_row(
    spot: Spot, position: int, raw: bytes, reason: str, detail: str, path: str = "", fact: str = ""
) -> ExplanationRow:
    """The row of bytes that no fact describes, or of a place where bytes are missing."""
    offset, length, characters = spot.place(position, len(raw))
    return ExplanationRow(
        kind="unexplained",
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        can_place=spot.can_place(position),
        path=path,
        fact=fact,
        verdict=sentences.WRONG.format(fault=detail),
        reason=reason,
    )


def surplus_row(spot: Spot, position: int, raw: bytes) -> ExplanationRow:
    """The row of bytes after the end of a frame or of its body."""
    text = sentences.TOO_MANY.format(bytes=sentences.byte_count(len(raw)))
    return wrong_row(spot, position, raw, "wrong_length", text)


HEX = b"0123456789ABCDEFabcdef"


@dataclass(frozen=True, slots=True)
class Unwrapped:
    """A frame without delimiters and encoding.

    `marks` are the delimiters, `start` and `end` the bytes in their places, `start` with the `preamble` bytes of the
    preamble before it, of which a sender may send more or fewer. `data` are the bytes of the parts, and
    `surplus` is what is left between them and the end. Its `reason` is `wrong_length`, or `not_hex`, in which case the
    rest of the frame cannot be read.
    """

    link: Link
    marks: tuple[bytes, bytes]
    frame: bytes
    start: bytes
    data: bytes
    surplus: bytes
    reason: str
    end: bytes
    preamble: int = 0

    @property
    def whole(self) -> bool:
        """Whether the parts can be read up to the end of the frame."""
        return self.reason != "not_hex"


def unwrapped(link: Link, direction: str, frame: bytes) -> Unwrapped:
    """A frame of a link without its delimiters and its encoding."""
    marks = link.marks(direction)
    lead = link.preamble.least + link.preamble.surplus(frame) if link.preamble is not None else 0
    start = frame[:lead] + _mark(frame[lead:], marks[0], link.transmission)
    end = _mark(frame[len(start) :][::-1], marks[1][::-1], link.transmission)[::-1]
    inner = frame[len(start) : len(frame) - len(end)]
    if link.transmission == "binary":
        return Unwrapped(link, marks, frame, start, inner, b"", "", end, lead)
    good = next((index for index, char in enumerate(inner) if char not in HEX), len(inner))
    pairs = good // 2 * 2
    reason = "not_hex" if good < len(inner) else "wrong_length" if pairs < good else ""
    data = bytes.fromhex(inner[:pairs].decode("ascii"))
    return Unwrapped(link, marks, frame, start, data, inner[pairs:], reason, end)


def _mark(frame: bytes, mark: bytes, encoding: str) -> bytes:
    """The bytes in the place of a delimiter: the delimiter itself, or bytes that can be nothing else."""
    if frame.startswith(mark) or encoding == "binary":
        return frame[: len(mark)]
    return frame[: next((index for index, char in enumerate(frame[: len(mark)]) if char in HEX), len(mark))]


def start_rows(parts: Unwrapped) -> Iterator[ExplanationRow]:
    """The rows of the preamble and of the start delimiter, if the link has them."""
    preamble = parts.link.preamble
    size = parts.preamble
    if preamble is not None:
        yield from _mark_row(parts, "preamble", 0, parts.start[:size], bytes([preamble.byte] * size))
    yield from _mark_row(parts, "start", size, parts.start[size:], parts.marks[0])


def end_rows(parts: Unwrapped) -> Iterator[ExplanationRow]:
    """The rows of surplus characters, and of the end delimiter, if the link has one."""
    offset = len(parts.frame) - len(parts.end)
    if parts.surplus:
        text = sentences.CHARACTER_TOO_MANY if parts.whole else sentences.NOT_PAIRS
        yield ExplanationRow(
            kind="unexplained",
            offset=offset - len(parts.surplus),
            length=len(parts.surplus),
            raw=parts.surplus,
            characters=parts.surplus.decode("latin-1"),
            verdict=sentences.WRONG.format(fault=text),
            reason=parts.reason,
        )
    yield from _mark_row(parts, "end", offset, parts.end, parts.marks[1])


def escape_row(spot: Spot, link: Link, position: int, raw: bytes) -> ExplanationRow:
    """The row of bytes of an escape that stand for no bytes, as the code of COBS before no data.

    They are at `position` in the parts; `raw` are the bytes that are sent.
    """
    return ExplanationRow(
        kind="mark",
        offset=spot.start + position,
        length=len(raw),
        raw=raw,
        path="escape",
        fact=link.place.path,
        verdict="right",
        source=citations(link.sources),
    )


def _mark_row(parts: Unwrapped, name: str, offset: int, data: bytes, expected: bytes) -> Iterator[ExplanationRow]:
    if expected:
        right = data == expected
        yield ExplanationRow(
            kind="mark",
            offset=offset,
            length=len(data),
            raw=data,
            characters=data.decode("latin-1") if parts.link.transmission == "hex_ascii" else "",
            path=name,
            fact=parts.link.place.path,
            verdict="right" if right else sentences.SHOULD_BE.format(expected=expected.hex(" ").upper()),
            reason="" if right else "wrong_mark",
            source=citations(parts.link.sources),
        )
