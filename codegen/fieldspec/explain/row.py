"""The rows of an explanation, and those of the header, trailer and delimiters."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from fieldspec.classes import dataclass
from fieldspec.explain.values import DecodedValue, Meaning
from fieldspec.layout.values import Raw
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.link import Link
from fieldspec.model.record import Message
from fieldspec.model.texts import Erratum


@dataclass(frozen=True, slots=True, kw_only=True)
class ExplanationRow:
    """Some bytes of a frame and what they say.

    `kind` is `mark`, `part` (of the frame), `field` (of the body), `register`, or `unexplained`.
    `offset` and `length` are those in the frame as it is sent; `raw` are the bytes meant. Where each byte is
    sent as two characters, `characters` holds them and `length` counts them.
    `path` is the place in the frame, as in `items[0].size`; `fact` is the path of the fact in the spec.
    `number` is the raw value, `value` the exact value in its unit.
    `verdict` is empty, `right`, or `wrong: ..`; `reason` is then the word of the codecs' errors.
    `source` cites the manual, `errata` are the ids of those that touch the fact.
    Rows of registers have an `address`, a number of `words`, and `access`, empty where it is not printed.
    """

    kind: str
    offset: int
    length: int
    raw: bytes
    characters: str = ""
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
    access: str = ""


@dataclass(frozen=True, slots=True)
class Spot:
    """How the parts of a frame lie in it: from `start` on, each byte in `width` bytes or characters."""

    frame: bytes
    start: int
    width: int

    def place(self, at: int, length: int) -> tuple[int, int, str]:
        """Offset, length and characters in the frame of some bytes of its parts."""
        offset, length = self.start + at * self.width, length * self.width
        characters = self.frame[offset : offset + length].decode("latin-1") if self.width > 1 else ""
        return offset, length, characters


def citations(sources: Iterable[Citation]) -> str:
    """`8.2 L1622; 9.1 L5`"""
    return "; ".join([citation.text() for citation in sources])


class _Errata:
    """The errata of one device by the paths that they touch. They are asked for at every row."""

    def __init__(self, errata: tuple[Erratum, ...]) -> None:
        self.errata = errata
        self.within: dict[str, list[str]] = {}
        self.of: dict[str, list[tuple[int, str]]] = {}
        for number, one in enumerate(errata):
            for path in (one.fact, *(one.fact[: found.start()] for found in re.finditer("/", one.fact))):
                self.within.setdefault(path, []).append(one.id)
            for path in {one.fact, one.fact.partition("/restated/")[0]}:
                self.of.setdefault(path, []).append((number, one.id))


_last = [_Errata(())]


def _errata(device: Device) -> _Errata:
    """Those of a device; the last ones are kept, as one device is explained at a time."""
    if _last[0].errata is not device.errata:
        _last[0] = _Errata(device.errata)
    return _last[0]


def errata_at(device: Device, path: str) -> tuple[str, ...]:
    """The errata of a fact and of what lies in it."""
    return tuple(_errata(device).within.get(path, ()))


def errata_of_message(device: Device, message: Message) -> tuple[str, ...]:
    """The errata of a message but for those of its fields."""
    path = message.place.path
    found = errata_at(device, path)
    if not found:
        return ()
    fields = (f"{path}/request/", f"{path}/response/")
    of_fields = {erratum.id for erratum in device.errata if erratum.fact.startswith(fields)}
    return tuple(one for one in found if one not in of_fields)


def errata_of_words(device: Device, facts: Collection[str]) -> tuple[str, ...]:
    """The errata of enums, members and flags that took part; those of other members do not touch a value."""
    if not facts:
        return ()
    of = _errata(device).of
    return tuple(name for _, name in sorted({one for fact in facts for one in of.get(fact, ())}))


def fact_row(
    device: Device, kind: str, path: str, fact: Fact, spot: Spot, at: int, raw: bytes, read: DecodedValue, outer: Fact
) -> ExplanationRow:
    """The row of a fact whose bytes lie at `at` in the parts; `outer` cites the manual where the fact does not."""
    offset, length, characters = spot.place(at, len(raw))
    errata = (*errata_at(device, fact.place.path), *errata_of_words(device, read.facts))
    return ExplanationRow(
        kind=kind,
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
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
    spot: Spot, at: int, raw: bytes, reason: str, detail: str, path: str = "", fact: str = ""
) -> ExplanationRow:
    """The row of bytes that are over, or of a place where bytes are missing."""
    offset, length, characters = spot.place(at, len(raw))
    return ExplanationRow(
        kind="unexplained",
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        path=path,
        fact=fact,
        verdict=f"wrong: {detail}",
        reason=reason,
    )


HEX = b"0123456789ABCDEFabcdef"


@dataclass(frozen=True, slots=True)
class Unwrapped:
    """A frame taken apart: what stands for the start mark, the parts as bytes, what is over, and the end mark.

    `reason` says why something is over: `not_hex`, after which nothing is known of the rest, or `wrong_length`.
    """

    link: Link
    frame: bytes
    start: bytes
    data: bytes
    over: bytes
    reason: str
    end: bytes

    @property
    def whole(self) -> bool:
        """Whether the parts go on to the end of the frame."""
        return self.reason != "not_hex"


def unwrapped(link: Link, frame: bytes) -> Unwrapped:
    """A frame of a link, taken apart."""
    start = _mark(frame, link.start, link.encoding)
    end = _mark(frame[len(start) :][::-1], link.end[::-1], link.encoding)[::-1]
    inner = frame[len(start) : len(frame) - len(end)]
    if link.encoding == "binary":
        return Unwrapped(link, frame, start, inner, b"", "", end)
    good = next((at for at, char in enumerate(inner) if char not in HEX), len(inner))
    pairs = good // 2 * 2
    reason = "not_hex" if good < len(inner) else "wrong_length" if pairs < good else ""
    return Unwrapped(link, frame, start, bytes.fromhex(inner[:pairs].decode("ascii")), inner[pairs:], reason, end)


def _mark(frame: bytes, mark: bytes, encoding: str) -> bytes:
    """What stands in the place of a mark: the mark itself, or bytes that cannot be anything else."""
    if frame.startswith(mark) or encoding == "binary":
        return frame[: len(mark)]
    return frame[: next((at for at, char in enumerate(frame[: len(mark)]) if char in HEX), len(mark))]


def start_rows(parts: Unwrapped) -> Iterator[ExplanationRow]:
    """The row of the start mark, where the link has one."""
    yield from _mark_row(parts, "start", 0, parts.start, parts.link.start)


def end_rows(parts: Unwrapped) -> Iterator[ExplanationRow]:
    """The rows of what is over, and of the end mark, where the link has one."""
    at = len(parts.frame) - len(parts.end)
    if parts.over:
        text = "these are no pairs of hexadecimal characters" if not parts.whole else "one character is over"
        yield ExplanationRow(
            kind="unexplained",
            offset=at - len(parts.over),
            length=len(parts.over),
            raw=parts.over,
            characters=parts.over.decode("latin-1"),
            verdict=f"wrong: {text}",
            reason=parts.reason,
        )
    yield from _mark_row(parts, "end", at, parts.end, parts.link.end)


def _mark_row(parts: Unwrapped, name: str, at: int, held: bytes, should: bytes) -> Iterator[ExplanationRow]:
    if should:
        right = held == should
        yield ExplanationRow(
            kind="mark",
            offset=at,
            length=len(held),
            raw=held,
            characters=held.decode("latin-1") if parts.link.encoding == "hex_ascii" else "",
            path=name,
            fact=parts.link.place.path,
            verdict="right" if right else f"wrong: should be {should.hex(' ').upper()}",
            reason="" if right else "wrong_mark",
            source=citations(parts.link.sources),
        )
