"""How the frames of a link are recognized in a byte stream."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.frames import is_simple
from fieldspec.backends.python.text import docstring
from fieldspec.layout.frame import FrameLayout, LinkLayout
from fieldspec.layout.record import FieldLayout, RecordLayout

Carried = Sequence[tuple[str, int | None, RecordLayout]]


def framer(
    link: LinkLayout, direction: str, carried: Carried, refusal: RecordLayout | None, frames: str
) -> tuple[str, list[str], list[str]]:
    """The class of a framer, its arguments and its docstring; an empty class where no frame marks its end.

    `carried` are the messages: name, code and data. `refusal` is the data of an exception response.
    """
    frame = link.frame(direction)
    bodies = [record for _, _, record in carried] + ([refusal] if refusal else [])
    if not bodies:
        return "", [], []
    arguments = [frames, *_bounds(link, frame, bodies), *_unit_addresses(link, frame, direction)]
    about = [f"Finds the {direction}s in a stream."]
    if frame.start and frame.end and link.link.encoding == "hex_ascii":
        about.append("A start delimiter within a frame begins another frame.")
        return "_MarkFramer", arguments, docstring(about, 8)
    length, code = frame.role("length"), frame.role("code")
    if not _ordered(frame):
        return "", [], []
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) == (0, None):
        if not frame.end:
            return "", [], []
        about.append("The end delimiter determines where a frame ends; it does not occur within, as bytes are escaped.")
        sizes = [int(argument.partition("=")[2]) for argument in arguments[1:3]]
        marks = len(frame.start) + len(frame.end)
        most = f"most={marks + frame.escape.most(sizes[1] - marks)}"
        return "_EscapeFramer", [*arguments, most], docstring(about, 8)
    if frame.escape is not None and (length is None or length.escaped):
        return "", [], []
    if length is not None:
        about.append("The length determines where a frame ends; a length that fits no message is garbage.")
        kind = "_LengthFramer" if is_simple(frame) else "_CountFramer"
        return kind, [*arguments, f"length_size={length.size}"], docstring(about, 8)
    if code is None or link.link.encoding != "binary":
        return "", [], []
    extents: dict[int, tuple[int, int, int, int]] = {}
    for _, code_number, record in carried:
        if code_number is not None:
            extent = _extent(link, frame, record)
            # Of messages that share a code, only those of one form are told by it.
            extents[code_number] = extent if extents.get(code_number, extent) == extent else (0, 0, -1, 0)
    error = link.link.exception_response if refusal is not None else None
    if error is not None and refusal is not None and not error.flag:
        own = _extent(link, frame, refusal)
        extents |= {error.code: own} if error.code is not None else {}
        # Where a part marks exception responses, the code tells the length only of those that are as long as others.
        extents |= {number: (0, 0, -1, 0) for number, extent in extents.items() if error.part and extent != own}
    arguments.append(f"code_size={code.size}")
    rows = "".join(f"\n{' ' * 16}{code:#04x}: {extent}," for code, extent in extents.items())
    arguments.append(f"extents={{{rows}\n{' ' * 12}}}")
    if refusal is not None and link.link.exception_response is not None and link.link.exception_response.flag:
        arguments += [f"flag={link.link.exception_response.flag}", f"refusal={_extent(link, frame, refusal)}"]
    ends = {name: extents[code][2] for name, code, _ in carried if code is not None}
    open_ended = [name for name, end in ends.items() if end == -1]
    about.append("Code and count of the repeated part determine where a frame ends; an unknown code is garbage.")
    about += ["The end delimiter ends frames whose values vary in width."] * (-2 in ends.values())
    if open_ended:
        about.append(f"No part of {', '.join(open_ended)} determines its length: only `idle` ends such a frame.")
    return "_CodeFramer", arguments, docstring(about, 8)


def _ordered(frame: FrameLayout) -> bool:
    """Whether all binary numbers by which a framer finds frames have the byte order of the header."""
    numbers = (frame.role(role) for role in ("unit_address", "code", "length"))
    return all(p is None or p.form or p.size == 1 or p.order == _order(frame) for p in numbers)


def _order(frame: FrameLayout) -> str:
    """The byte order of the header."""
    return next((part.order for part in frame.header if part.size > 1 and not part.form), "big")


def _bounds(link: LinkLayout, frame: FrameLayout, bodies: list[RecordLayout]) -> list[str]:
    least = min(record.least for record in bodies)
    most = max(record.most if record.most is not None else 0xFFFF for record in bodies)
    width = 2 if link.link.encoding == "hex_ascii" else 1
    marks = len(frame.start) + len(frame.end)
    sizes = [marks + width * (frame.header_size + size + frame.trailer_size) for size in (least, most)]
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) != (0, None):
        sizes[1] = frame.escape.most(sizes[1])
    return [f"shortest={sizes[0]}", f"longest={sizes[1]}"]


def _unit_addresses(link: LinkLayout, frame: FrameLayout, direction: str) -> list[str]:
    ordered = ['order="little"'] if _order(frame) == "little" else []
    unit_address, unit_addresses = frame.role("unit_address"), link.link.unit_addresses
    if unit_address is None or unit_addresses is None or unit_addresses.ranges is None:
        return ordered
    known = [_span(interval) for interval in unit_addresses.ranges.intervals]
    if direction == "request" and unit_addresses.broadcast is not None:
        known.append(str(unit_addresses.broadcast))
    return [
        f"unit_address_offset={unit_address.offset}",
        f"unit_address_size={unit_address.size}",
        f"unit_addresses=frozenset(({', '.join(known)},))",
        *ordered,
    ]


def _span(interval: tuple[int, int]) -> str:
    low, high = interval
    return str(low) if low == high else f"*range({low}, {high + 1})"


def _extent(link: LinkLayout, frame: FrameLayout, record: RecordLayout) -> tuple[int, int, int, int]:
    """The length without the repeated part; then offset and size of its count, and the bytes of each unit."""
    around = len(frame.start) + frame.header_size + frame.trailer_size + len(frame.end)
    if record.size is not None:
        return around + record.size, 0, 0, 0
    tail = record.fields[-1]
    if record.spans and frame.end:
        return around + record.first_bytes, 0, -2, 0
    measures = [field for field in record.fields if record.has_place(field) and _measures(field, tail, frame)]
    measure = min(measures, key=lambda field: field.size, default=None)  # one byte is read faster than two
    if measure is None or measure.field.measures is None or tail.cases or record.spans or not record.has_single_list:
        return 0, 0, -1, 0
    unit, plus = measure.field.measures.unit(tail.size), measure.field.measures.plus
    return around + tail.offset - plus * unit, frame.header_size + measure.offset, measure.size, unit


def _measures(field: FieldLayout, tail: FieldLayout, frame: FrameLayout) -> bool:
    measure = field.field.measures
    return (
        measure is not None
        and measure.field == tail.name
        and field.size <= 2
        and (field.size == 1 or field.order == _order(frame))
    )
