"""How the frames of a link are recognized in a byte stream."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.frames import is_simple
from fieldspec.backends.python.text import docstring
from fieldspec.layout.first_bytes import first_bytes
from fieldspec.layout.frame import FrameLayout, LinkLayout
from fieldspec.layout.part import PartLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.link import LARGEST_SET

Carried = Sequence[tuple[str, int | None, RecordLayout]]
Extent = tuple[int, int, int, int]

OPEN: Extent = (0, 0, -1, 0)
"""The extent of frames whose code does not determine their length."""


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
    about = [f"Finds the {direction}s in a stream."]
    if frame.start and frame.end and link.link.encoding == "hex_ascii":
        about.append("A start delimiter within a frame begins another frame.")
        return "_MarkFramer", arguments, docstring(about, 8)
    length, code = frame.role("length"), frame.role("code")
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) == (0, None):
        if not frame.end:
            return "", [], []
        about.append("The end delimiter determines where a frame ends; it does not occur within, as bytes are escaped.")
        sizes = [int(argument.partition("=")[2]) for argument in arguments[1:3]]
        marks = len(frame.start) + len(frame.end)
        most = f"most={marks + frame.escape.most(sizes[1] - marks)}"
        return "_EscapeFramer", [*arguments, most], docstring(about, 8)
    if frame.escape is not None and (length is None or length.before_escape):
        return "", [], []
    if length is not None:
        about.append("The length determines where a frame ends; a length that fits no message is garbage.")
        kind = "_LengthFramer" if is_simple(frame) else "_CountFramer"
        size = [f"length_size={length.size}", *_own_order("length", length, frame)]
        return kind, [*arguments, *size], docstring(about, 8)
    if link.link.encoding != "binary":
        return "", [], []
    extents, subcodes = _extents(link, frame, carried, refusal) if code is not None else ({}, {})
    if frame.end and (code is None or OPEN in extents.values()):
        about.append("A frame ends with the first end delimiter with which it is one of the messages.")
        arguments.append(f"decode=self.decode_{direction}")
        if code is None or link.ambiguous_codes(direction):
            arguments.append(f"messages=({', '.join(names)},)")
        known = "".join(
            f'\n{" " * 16}{place}: bytes.fromhex("{values.hex()}"),'
            for place, values in first_bytes(link, direction).items()
        )
        arguments += [f"begins={{{known}\n{' ' * 12}}}"] if known else []
        return "_EndFramer", arguments, docstring(about, 8)
    if code is None:
        return "", [], []
    arguments += [f"code_size={code.size}", *_own_order("code", code, frame)]
    arguments.append(f"extents={_table(extents, 16)}")
    if subcodes:
        rows = "".join(
            f"\n{' ' * 16}{number:#04x}: ({place}, {_table(own, 20)})," for number, (place, own) in subcodes.items()
        )
        arguments.append(f"subcodes={{{rows}\n{' ' * 12}}}")
    if refusal is not None and link.link.exception_response is not None and link.link.exception_response.flag:
        arguments += [f"flag={link.link.exception_response.flag}", f"refusal={_extent(link, frame, refusal)}"]
    ends = {name: extents[code][2] for name, code, _ in carried if code is not None and code in extents}
    open_ended = [name for name, end in ends.items() if end == -1]
    about.append("Code and count of the repeated part determine where a frame ends; an unknown code is garbage.")
    about += ["Of messages that share a code, the subcode determines it."] * bool(subcodes)
    about += ["The end delimiter ends frames whose values vary in width."] * (-2 in ends.values())
    if open_ended:
        about.append(f"No part of {', '.join(open_ended)} determines its length: only `idle` ends such a frame.")
    return "_CodeFramer", arguments, docstring(about, 8)


def _extents(
    link: LinkLayout, frame: FrameLayout, carried: Carried, refusal: RecordLayout | None
) -> tuple[dict[int, Extent], dict[int, tuple[str, dict[int, Extent]]]]:
    """The extents by code.

    Of the codes that messages of several extents share, also the place of the subcode, and the extents by its number.
    """
    each: dict[int, set[Extent]] = {}
    names = {}
    for name, code, record in carried:
        if code is not None:
            names[name] = _extent(link, frame, record)
            each.setdefault(code, set()).add(names[name])
    extents = {code: next(iter(own)) if len(own) == 1 else OPEN for code, own in each.items()}
    error = link.link.exception_response if refusal is not None else None
    if error is not None and refusal is not None and not error.flag:
        own = _extent(link, frame, refusal)
        extents |= {error.code: own} if error.code is not None else {}
        if error.part:
            # The code determines the length only where exception responses are as long as others.
            return {number: extent if extent == own else OPEN for number, extent in extents.items()}, {}
    subcodes = {}
    for code, shared in link.subcodes(frame.direction).items():
        if len(each.get(code, ())) > 1:
            place = f'{frame.header_size + shared.offset}, {shared.size}, "{shared.order}"'
            subcodes[code] = place, {number: names[message.name] for number, message in shared.messages.items()}
            del extents[code]
    return extents, subcodes


def _table(extents: dict[int, Extent], indent: int) -> str:
    """A dictionary of extents."""
    rows = "".join(f"\n{' ' * indent}{number:#04x}: {extent}," for number, extent in extents.items())
    return f"{{{rows}\n{' ' * (indent - 4)}}}"


def _own_order(name: str, part: PartLayout, frame: FrameLayout) -> list[str]:
    """The argument with the byte order of a part, where it is not that of the unit address."""
    is_other = part.size > 1 and not part.form and part.order != _order(frame)
    return [f'{name}_order="{part.order}"'] if is_other else []


def _order(frame: FrameLayout) -> str:
    """The byte order of the unit address, and of the header where it has none."""
    parts = [part for part in frame.header if part.size > 1 and not part.form]
    unit_address = next((part for part in parts if part.role == "unit_address"), None)
    return unit_address.order if unit_address is not None else next((part.order for part in parts), "big")


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
    intervals = unit_addresses.intervals(direction)
    if sum(high - low + 1 for low, high in intervals) > LARGEST_SET:
        known = f"_Intervals({', '.join(map(str, intervals))})"
    else:
        known = f"frozenset(({', '.join(map(_span, intervals))},))"
    return [
        f"unit_address_offset={unit_address.offset}",
        f"unit_address_size={unit_address.size}",
        f"unit_addresses={known}",
        *ordered,
    ]


def _span(interval: tuple[int, int]) -> str:
    low, high = interval
    return str(low) if low == high else f"*range({low}, {high + 1})"


def _extent(link: LinkLayout, frame: FrameLayout, record: RecordLayout) -> Extent:
    """The length without the repeated part; then offset and size of its count, and the bytes of each unit."""
    around = len(frame.start) + frame.header_size + frame.trailer_size + len(frame.end)
    if record.size is not None:
        return around + record.size, 0, 0, 0
    tail = record.fields[-1]
    count, others = record.count_of_text or (None, 0)
    if count is not None and (count.size == 1 or count.order == _order(frame)):
        return around + others, frame.header_size + count.offset, count.size, 1
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
