"""The sizes of frames as people count them: without delimiters, and of a CAN bus only the data."""

from __future__ import annotations

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.explained_frame import Explanation
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.language.model.escape import CAN_HEADER


def size_text(link: LinkLayout, own: Explanation) -> str:
    """The size of a frame, counted like the size of a message: `without its delimiters, the frame has 4 bytes`."""
    if link.link.is_can:
        return sentences.SIZE_OF_DATA.format(bytes=sentences.byte_count(len(own.frame) - CAN_HEADER))
    rows = [row for row in own.rows if row.kind != "mark"]
    is_hex = link.link.transmission == "hex_ascii"
    size = sum(row.length for row in rows) // 2 if is_hex else sum(len(row.raw) for row in rows)
    names = {
        "preamble": link.link.preamble is not None,
        "delimiters": any(link.link.marks(own.direction)),
        "escapes": link.frame(own.direction).escape is not None,
    }
    without = [name for name, is_present in names.items() if is_present]
    sentence = sentences.SIZE_WITHOUT if without else sentences.SIZE_OF_FRAME
    return sentence.format(names=" and ".join(without), bytes=sentences.byte_count(size))


def bounds_text(minimum: int, maximum: int | None, identifier: int) -> str:
    """`8`, `8 or more` or `8 to 12`: sizes without the bytes of the parts of an identifier."""
    lowest = minimum - identifier
    if maximum is None or maximum == minimum:
        return sentences.OR_MORE.format(low=lowest) if maximum is None else str(lowest)
    return sentences.BOUNDS.format(low=lowest, high=maximum - identifier)
