"""How the frames of a link are found in a stream: by their marks, their length, or their code."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.heads import is_simple
from fieldspec.backends.python.text import docstring
from fieldspec.layout.frame import FrameLayout, LinkLayout
from fieldspec.layout.record import FieldLayout, RecordLayout

Carried = Sequence[tuple[str, int | None, RecordLayout]]


def framer(
    link: LinkLayout, direction: str, carried: Carried, refusal: RecordLayout | None, frames: str
) -> tuple[str, list[str], list[str]]:
    """The class of a framer, its arguments and its docstring; an empty class where no frame shows its end.

    `carried` are the messages: name, code and data. `refusal` is the data of an error reply.
    """
    frame = link.frame(direction)
    bodies = [record for _, _, record in carried] + ([refusal] if refusal else [])
    if not bodies:
        return "", [], []
    arguments = [frames, *_bounds(link, frame, bodies), *_stations(link, frame, direction)]
    about = [f"Finds the {direction}s in a stream."]
    if link.link.start and link.link.end and link.link.encoding == "hex_ascii":
        about.append("A start mark within a frame begins another one.")
        return "_MarkFramer", arguments, docstring(about, 8)
    length, code = frame.role("length"), frame.role("code")
    if not _ordered(frame):
        return "", [], []
    if length is not None:
        about.append("The length says where a frame ends; one that fits no message is taken for garbage.")
        kind = "_LengthFramer" if is_simple(frame) else "_CountFramer"
        return kind, [*arguments, f"length_size={length.size}"], docstring(about, 8)
    if code is None or link.link.encoding != "binary":
        return "", [], []
    extents = {code: _extent(link, frame, record) for _, code, record in carried if code is not None}
    arguments.append(f"code_size={code.size}")
    rows = "".join(f"\n{' ' * 16}{code:#04x}: {extent}," for code, extent in extents.items())
    arguments.append(f"extents={{{rows}\n{' ' * 12}}}")
    if refusal is not None and link.link.error is not None:
        arguments += [f"flag={link.link.error.flag}", f"refusal={_extent(link, frame, refusal)}"]
    open_ended = [name for name, code, _ in carried if code is not None and extents[code][2] < 0]
    about.append(
        "The code, and what counts the repeated part, say where a frame ends; an unknown code is taken for garbage."
    )
    if open_ended:
        about.append(f"No part of {', '.join(open_ended)} says how long it is: only `idle` ends such a frame.")
    return "_CodeFramer", arguments, docstring(about, 8)


def _ordered(frame: FrameLayout) -> bool:
    """Whether all numbers by which a framer finds frames lie in the order of the head."""
    order = next((part.order for part in frame.head if part.size > 1), "big")
    numbers = (frame.role(role) for role in ("station", "code", "length"))
    return all(part is None or part.size == 1 or part.order == order for part in numbers)


def _bounds(link: LinkLayout, frame: FrameLayout, bodies: list[RecordLayout]) -> list[str]:
    least = min(record.least for record in bodies)
    most = max(record.most if record.most is not None else 0xFFFF for record in bodies)
    width = 2 if link.link.encoding == "hex_ascii" else 1
    marks = len(link.link.start) + len(link.link.end)
    sizes = [marks + width * (frame.head_size + size + frame.tail_size) for size in (least, most)]
    return [f"shortest={sizes[0]}", f"longest={sizes[1]}"]


def _stations(link: LinkLayout, frame: FrameLayout, direction: str) -> list[str]:
    order = next((part.order for part in frame.head if part.size > 1), "big")
    ordered = ['order="little"'] if order == "little" else []
    station, stations = frame.role("station"), link.link.stations
    if station is None or stations is None or stations.ranges is None:
        return ordered
    known = [_span(interval) for interval in stations.ranges.intervals]
    if direction == "request" and stations.broadcast is not None:
        known.append(str(stations.broadcast))
    return [
        f"station_offset={station.offset}",
        f"station_size={station.size}",
        f"stations=frozenset(({', '.join(known)},))",
        *ordered,
    ]


def _span(interval: tuple[int, int]) -> str:
    low, high = interval
    return str(low) if low == high else f"*range({low}, {high + 1})"


def _extent(link: LinkLayout, frame: FrameLayout, record: RecordLayout) -> tuple[int, int, int, int]:
    """The length without the repeated part, and where the number of bytes, or of elements, of that part stands."""
    around = len(link.link.start) + frame.head_size + frame.tail_size + len(link.link.end)
    if record.size is not None:
        return around + record.size, 0, 0, 0
    tail = record.fields[-1]
    measures = [field for field in record.fields if _measures(field, tail, frame)]
    # One byte is had quicker than two.
    measure = min(measures, key=lambda field: field.size, default=None)
    if measure is None or measure.field.measures is None or tail.cases:
        return 0, 0, -1, 0
    unit = 1 if measure.field.measures.of == "bytes" else tail.size
    return around + tail.offset, frame.head_size + measure.offset, measure.size, unit


def _measures(field: FieldLayout, tail: FieldLayout, frame: FrameLayout) -> bool:
    measure = field.field.measures
    order = next((part.order for part in frame.head if part.size > 1), "big")
    return (
        measure is not None
        and measure.field == tail.name
        and field.size <= 2
        and (field.size == 1 or field.order == order)
    )
