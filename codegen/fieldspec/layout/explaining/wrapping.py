"""The marks of a frame, and its parts as bytes."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass
from fieldspec.layout.explaining.row import Row, citations
from fieldspec.model.link import Link

HEX = b"0123456789ABCDEFabcdef"


@dataclass(frozen=True, slots=True)
class Wrapped:
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


def wrapped(link: Link, frame: bytes) -> Wrapped:
    """A frame of a link, taken apart."""
    start = _mark(frame, link.start, link.encoding)
    end = _mark(frame[len(start) :][::-1], link.end[::-1], link.encoding)[::-1]
    inner = frame[len(start) : len(frame) - len(end)]
    if link.encoding == "binary":
        return Wrapped(link, frame, start, inner, b"", "", end)
    good = next((at for at, char in enumerate(inner) if char not in HEX), len(inner))
    pairs = good // 2 * 2
    reason = "not_hex" if good < len(inner) else "wrong_length" if pairs < good else ""
    return Wrapped(link, frame, start, bytes.fromhex(inner[:pairs].decode("ascii")), inner[pairs:], reason, end)


def _mark(frame: bytes, mark: bytes, encoding: str) -> bytes:
    """What stands in the place of a mark: the mark itself, or bytes that cannot be anything else."""
    if frame.startswith(mark) or encoding == "binary":
        return frame[: len(mark)]
    return frame[: next((at for at, char in enumerate(frame[: len(mark)]) if char in HEX), len(mark))]


def start_rows(parts: Wrapped) -> Iterator[Row]:
    """The row of the start mark, where the link has one."""
    yield from _mark_row(parts, "start", 0, parts.start, parts.link.start)


def end_rows(parts: Wrapped) -> Iterator[Row]:
    """The rows of what is over, and of the end mark, where the link has one."""
    at = len(parts.frame) - len(parts.end)
    if parts.over:
        text = "these are no pairs of hexadecimal characters" if not parts.whole else "one character is over"
        yield Row(
            kind="unexplained",
            offset=at - len(parts.over),
            length=len(parts.over),
            raw=parts.over,
            characters=parts.over.decode("latin-1"),
            verdict=f"wrong: {text}",
            reason=parts.reason,
        )
    yield from _mark_row(parts, "end", at, parts.end, parts.link.end)


def _mark_row(parts: Wrapped, name: str, at: int, held: bytes, should: bytes) -> Iterator[Row]:
    if should:
        right = held == should
        yield Row(
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
