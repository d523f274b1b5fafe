"""How the frames of a link are recognized in a byte stream."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.first_bytes import first_bytes
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.frame_extents import BY_COUNT, DELIMITED, OPEN, FrameExtent, FrameExtents, frame_extents
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.language.model.link import LARGEST_SET
from fieldspec.targets.python.frames import is_simple
from fieldspec.targets.python.text import docstring

Carried = Sequence[tuple[str, int | None, RecordLayout]]


def framer(
    link: LinkLayout,
    direction: str,
    carried: Carried,
    refusal: RecordLayout | None,
    frames: str,
    names: Sequence[str],
) -> tuple[str, list[str], list[str]]:
    """The class of a framer, its arguments and its docstring; an empty class where no frame marks its end.

    `carried` are the messages: name, code and data. `refusal` is the data of an exception response. `names` are
    those by which decoders take the messages where a frame does not identify its own.
    """
    frame = link.frame(direction)
    bodies = [record for _, _, record in carried] + ([refusal] if refusal else [])
    if not bodies:
        return "", [], []
    arguments = [frames, *_bounds(link, frame, bodies), *_unit_addresses(link, frame, direction)]
    paragraphs = [f"Finds the {direction}s in a stream."]
    if frame.start and frame.end and link.link.transmission == "hex_ascii":
        paragraphs.append("A start delimiter within a frame begins another frame.")
        return "_MarkFramer", arguments, docstring(paragraphs, 8)
    length, code = frame.role("length"), frame.role("code")
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) == (0, None):
        if not frame.end:
            return "", [], []
        paragraphs.append(
            "The end delimiter determines where a frame ends; it does not occur within, as bytes are escaped."
        )
        sizes = [int(argument.partition("=")[2]) for argument in arguments[1:3]]
        marks = len(frame.start) + len(frame.end)
        longest = f"maximum={marks + frame.escape.most(sizes[1] - marks)}"
        return "_EscapeFramer", [*arguments, longest], docstring(paragraphs, 8)
    if frame.escape is not None and (length is None or length.before_escape):
        return "", [], []
    if length is not None:
        paragraphs.append("The length determines where a frame ends; a length that fits no message is garbage.")
        kind = "_LengthFramer" if is_simple(frame) else "_CountFramer"
        size = [f"length_size={length.size}", *_own_order("length", length, frame), *_bits("length", length)]
        return kind, [*arguments, *size], docstring(paragraphs, 8)
    if link.link.transmission != "binary":
        return "", [], []
    extents = frame_extents(link, direction, carried if code is not None else (), refusal)
    if frame.end and (code is None or extents.has(OPEN)):
        paragraphs.append("A frame ends with the first end delimiter with which it is one of the messages.")
        arguments.append(f"decode=self.decode_{direction}")
        if code is None or link.ambiguous_codes(direction):
            arguments.append(f"messages=({', '.join(names)},)")
        known = "".join(
            f'\n{" " * 16}{place}: bytes.fromhex("{values.hex()}"),'
            for place, values in first_bytes(link, direction).items()
        )
        arguments += [f"first_bytes={{{known}\n{' ' * 12}}}"] if known else []
        return "_EndFramer", arguments, docstring(paragraphs, 8)
    if code is None:
        return "", [], []
    arguments += [f"code_size={code.size}", *_own_order("code", code, frame), *_bits("code", code)]
    arguments.append(f"extents={_table(extents.by_code, frame, 16)}")
    if extents.by_subcode:
        arguments.append(f"subcodes={_subcodes(extents, frame)}")
    if extents.refusal is not None and link.link.exception_response is not None:
        arguments += [f"flag={link.link.exception_response.flag}", f"refusal={_extent_row(extents.refusal, frame)}"]
    open_ended = [name for name, own, _ in carried if own is not None and extents.of_message(name, own).kind == OPEN]
    paragraphs.append("Code and count of the repeated part determine where a frame ends; an unknown code is garbage.")
    paragraphs += ["For messages that share a code, the subcode determines it."] * bool(extents.by_subcode)
    paragraphs += ["The end delimiter ends frames whose values vary in width."] * extents.has(DELIMITED)
    if open_ended:
        paragraphs.append(f"No part of {', '.join(open_ended)} determines its length: only `idle` ends such a frame.")
    return "_CodeFramer", arguments, docstring(paragraphs, 8)


def _table(extents: Mapping[int, FrameExtent], frame: FrameLayout, indent: int) -> str:
    """A Python dictionary with the extents of frames by their keys."""
    rows = "".join(
        f"\n{' ' * indent}{number:#04x}: {_extent_row(extent, frame)}," for number, extent in extents.items()
    )
    return f"{{{rows}\n{' ' * (indent - 4)}}}"


def _subcodes(extents: FrameExtents, frame: FrameLayout) -> str:
    """A dictionary of what tells messages apart, and of their extents."""
    rows = "".join(
        f'\n{" " * 16}{code:#04x}: ({frame.header_size + shared.offset}, {shared.size}, "{shared.order}", '
        f"{_table(own, frame, 20)}),"
        for code, (shared, own) in extents.by_subcode.items()
    )
    return f"{{{rows}\n{' ' * 12}}}"


def _extent_row(extent: FrameExtent, frame: FrameLayout) -> tuple[int | str | bool, ...]:
    """The length without the repeated part; then offset and size of its count, and the bytes of each unit.

    After these is the byte order of a count if it differs from the order of the unit address, and whether the bytes of
    its words have the opposite order.
    """
    if extent.kind == BY_COUNT:
        usual = extent.length, extent.offset, extent.size, extent.unit
        is_usual = extent.size == 1 or (extent.order == _order(frame) and not extent.is_turned)
        return usual if is_usual else (*usual, extent.order, extent.is_turned)
    return extent.length, 0, {DELIMITED: -2, OPEN: -1}.get(extent.kind, 0), 0


def _own_order(name: str, part: PartLayout, frame: FrameLayout) -> list[str]:
    """The argument with the byte order of a part, where it is not that of the unit address."""
    is_other = part.size > 1 and not part.form and part.order != _order(frame)
    return [f'{name}_order="{part.order}"'] if is_other else []


def _bits(name: str, part: PartLayout) -> list[str]:
    """The argument with the first bit and the number of bits of a part that shares its bytes with others."""
    return [f"{name}_bits=({part.shift}, {part.width})"] if part.width else []


def _order(frame: FrameLayout) -> str:
    """The byte order of the unit address, and of the header where it has none."""
    parts = [part for part in frame.header if part.size > 1 and not part.form]
    unit_address = next((part for part in parts if part.role == "unit_address"), None)
    return unit_address.order if unit_address is not None else next((part.order for part in parts), "big")


def _bounds(link: LinkLayout, frame: FrameLayout, bodies: list[RecordLayout]) -> list[str]:
    smallest = min(record.least for record in bodies)
    largest = max(record.most if record.most is not None else 0xFFFF for record in bodies)
    width = 2 if link.link.transmission == "hex_ascii" else 1
    marks = len(frame.start) + len(frame.end)
    sizes = [marks + width * (frame.header_size + size + frame.trailer_size) for size in (smallest, largest)]
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) != (0, None):
        sizes[1] = frame.escape.most(sizes[1])
    return [f"shortest={sizes[0]}", f"longest={sizes[1]}"]


def _unit_addresses(link: LinkLayout, frame: FrameLayout, direction: str) -> list[str]:
    ordered = ['order="little"'] if _order(frame) == "little" else []
    unit_address, intervals = frame.role("unit_address"), link.framed_addresses(direction)
    if unit_address is None or not intervals:
        return ordered
    if sum(high - low + 1 for low, high in intervals) > LARGEST_SET:
        known = f"_Intervals({', '.join(map(str, intervals))})"
    else:
        known = f"frozenset(({', '.join(map(_span, intervals))},))"
    return [
        f"unit_address_offset={unit_address.offset}",
        f"unit_address_size={unit_address.size}",
        f"unit_addresses={known}",
        *_bits("unit_address", unit_address),
        *ordered,
    ]


def _span(interval: tuple[int, int]) -> str:
    low, high = interval
    return str(low) if low == high else f"*range({low}, {high + 1})"
