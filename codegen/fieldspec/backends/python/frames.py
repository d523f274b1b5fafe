"""Frame headers, and how the frames of a link are recognized in a byte stream."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import docstring, literal
from fieldspec.backends.python.writing import packed, pairs, tuple_of, within
from fieldspec.classes import dataclass
from fieldspec.layout.frame import FrameLayout, LinkLayout, MessageLayout, PartLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.checksums import SIMPLE, checksum_named
from fieldspec.model.ranges import Ranges


@dataclass(frozen=True, slots=True)
class PartView:
    """A header part that the caller passes: its attribute, variable and type, and the expressions that read it."""

    name: str
    variable: str
    type: str
    expression: str
    quickly: str


def variable(part: PartLayout) -> str:
    """The variable of a header part."""
    return "unit_address" if part.role == "unit_address" else f"part_{part.name}"


def number(part: PartLayout) -> str:
    """The expression of the number in the slot of a header part."""
    return f"{variable(part)}.raw" if part.value is not None and part.value.flags else variable(part)


def letter(part: PartLayout) -> str:
    """The letter of a header part in its Struct."""
    assert part.value is not None
    return part.value.type.letter


def _argument_view(part: PartLayout, place: int, words: Words) -> PartView:
    flags = part.value.flags if part.value else ""
    construction = f"{words.flags[flags]}({{}})" if flags else "{}"
    name = Scope(frozenset({"unit_address", "message", "self", "frame", "request"})).take(part.name)
    return PartView(
        name=name,
        variable=variable(part),
        type=words.flags[flags] if flags else "int",
        expression=construction.format(f"head[{place}]"),
        quickly=construction.format(variable(part)),
    )


def code_literal(code: int | None) -> str:
    """A code as Python writes it: `0x03`, `None`."""
    return "None" if code is None else f"{code:#04x}"


def head_value(part: PartLayout, code: str) -> str:
    """The expression of a header part before the length of the frame is known."""
    if part.role in ("length", "checksum"):
        return "0"
    fixed_number = part.constant
    return code if part.role == "code" else number(part) if fixed_number is None else str(fixed_number)


def marks_exceptions(link: LinkLayout, frame: FrameLayout, part: PartLayout) -> bool:
    """Whether the number of a header part tells exception responses from others."""
    error = link.link.exception_response
    return error is not None and frame.direction == "response" and error.part == part.name


def _allowed(
    link: LinkLayout, frame: FrameLayout, part: PartLayout, is_exception: bool = False
) -> tuple[tuple[tuple[int, int], ...], tuple[int, ...]]:
    """The intervals of a header part, and single values besides."""
    assert part.value is not None
    if link.link.exception_response is not None and marks_exceptions(link, frame, part):
        return link.link.exception_response.permitted(part.value, is_exception).intervals, ()
    unit_addresses = link.link.unit_addresses if part.role == "unit_address" else None
    if unit_addresses is not None and unit_addresses.ranges is not None:
        beside = () if unit_addresses.broadcast is None else (unit_addresses.broadcast,)
        return unit_addresses.ranges.intervals, beside
    return (part.value.ranges.intervals if part.value.ranges else ()), ()


def is_simple(frame: FrameLayout) -> bool:
    """Whether a header of one byte order precedes the body and, at most, a checksum over everything before it.

    A length then counts all parts. Any other frame is read and written part by part, which is slower.
    """
    check, length = frame.checksum, frame.role("length")
    return (
        frame.escape is None
        and len({part.order for part in frame.header if part.size > 1}) <= 1
        and not any(part.reserved for part in frame.header)
        and frame.trailer == (() if check is None else (check,))
        and (check is None or _is_usual(check))
        and (length is None or (length.unit_size, length.base) == (1, 0))
    )


def _is_usual(check: PartLayout) -> bool:
    """Whether a checksum has an algorithm with its own function, covers everything before it, and is sent as bytes."""
    return check.algorithm in SIMPLE and not check.digits and (check.start, check.stop) == (0, check.offset)


def escape_call(frame: FrameLayout) -> str:
    """`.escaping(_Cobs(), 0, None, ...)`: what gives frames their escape; empty where they have none."""
    escape = frame.escape
    if escape is None:
        return ""
    places = {place: part for place, part in enumerate(frame.parts) if part.role in ("length", "checksum")}
    sent = sorted(place for place, part in places.items() if not part.escaped)
    own = sorted(place for place, part in places.items() if part.escaped)
    construction = {
        "cobs": "_Cobs()",
        "replace": f"_Replace({escape.pairs})",
        "can": f"_CanIdentifier({', '.join(map(str, (escape.bits, *escape.fields)))})",
        "insert": f'_Insert(bytes.fromhex("{escape.pattern.hex()}"), {escape.inserted:#04x})',
    }[escape.method]
    bounds = f"{frame.escape_start}, {frame.escape_stop}"
    return f".escaping({construction}, {bounds}, frozenset({sent}), frozenset({own}))"


def check_rows(frame: FrameLayout) -> str:
    """The checksums in the order in which they are computed: place, function, what it covers, and its digits."""
    rows = [
        f"({frame.parts.index(check)}, {_function(check)}, {check.start}, {check.stop}, {literal(check.digits)})"
        for check in frame.checksums
    ]
    return tuple_of(rows) if rows else "()"


def _function(check: PartLayout) -> str:
    """`_Sum(8)`, `_Crc(16, 0x1021, 0xFFFF, False, False, 0x0)`: the function of an algorithm."""
    kind = checksum_named(check.algorithm)
    if kind.method == "crc":
        numbers = f"{kind.width}, {kind.polynomial:#x}, {kind.initial:#x}"
        return f"_Crc({numbers}, {kind.reflect_in}, {kind.reflect_out}, {kind.final_xor:#x})"
    name = "_Sum" if kind.method == "sum" else "_Xor"
    order = literal("little" if check.order == "little" else "big")
    return f"{name}({kind.width}, {kind.initial:#x}, {literal(kind.complement)}, {kind.unit_size}, {order})"


def part_rows(parts: tuple[PartLayout, ...]) -> str:
    """Parts as the rows of a tuple: name, size, order, sign, constant, and whether a received constant is compared."""
    rows = [
        f"({literal(part.name)}, {part.size}, {literal(part.order)}, {_signed(part)}, {part.constant},"
        f" {part.constant is not None and not part.reserved})"
        for part in parts
    ]
    return tuple_of(rows) if rows else "()"


def _signed(part: PartLayout) -> bool:
    return part.value is not None and part.value.type.signed


def head_arguments(frame: FrameLayout) -> list[PartLayout]:
    """The header parts that the caller passes."""
    return [part for part in frame.header if part.is_argument]


def argument_views(frame: FrameLayout, words: Words) -> list[PartView]:
    """The header parts besides the unit address that the caller passes."""
    return [
        _argument_view(part, frame.header.index(part), words) for part in head_arguments(frame) if part.role == "plain"
    ]


def constants(frame: FrameLayout) -> list[str]:
    """The constant header parts: place, name, value and offset of each."""
    return [
        f"({place}, {literal(part.name)}, {number}, {part.offset})"
        for place, part in enumerate(frame.header)
        if (number := part.constant) is not None
    ]


def frames_arguments(link: LinkLayout, frame: FrameLayout) -> list[str]:
    """The arguments of the `_Frames` or `_PartFrames` of a link in one direction."""
    arguments = _simple_arguments(frame) if is_simple(frame) else _part_arguments(frame)
    for role in ("code", "length"):
        part = frame.role(role)
        if part is not None:
            arguments += [f"{role}={frame.header.index(part)}", f"{role}_offset={part.offset}"]
            if role == "length":
                arguments += [f"length_name={literal(part.name)}", f"longest={256**part.size - 1}"]
    for name, mark in (("start", frame.start), ("end", frame.end)):
        if mark:
            arguments.append(f'{name}=bytes.fromhex("{mark.hex()}")')
    if link.link.encoding == "hex_ascii":
        arguments.append("hexadecimal=True")
    if is_simple(frame) and constants(frame):
        arguments.append(f"constants=({', '.join(constants(frame))},)")
    return arguments


def _simple_arguments(frame: FrameLayout) -> list[str]:
    """The arguments of `_Frames` for the header and the checksum."""
    order = next((part.order for part in frame.header if part.size > 1), "big")
    letters = "".join(map(letter, frame.header))
    arguments = [literal(f"{'<' if order == 'little' else '>'}{letters}")]
    arguments.append(literal(frame.checksum.algorithm if frame.checksum else ""))
    if frame.checksum and frame.checksum.order == "big":
        arguments.append('check_order="big"')
    return arguments


def _part_arguments(frame: FrameLayout) -> list[str]:
    """The arguments of `_PartFrames` for the parts."""
    length = frame.role("length")
    arguments = [part_rows(frame.header), part_rows(frame.trailer), check_rows(frame)]
    if length is not None:
        arguments += [f"unit={length.unit_size}", f"base={length.base}"]
    return arguments


def head_tests(link: LinkLayout, frame: FrameLayout, asked: MessageLayout | None) -> list[str]:
    """The conditions on the header parts that the caller passes; `asked` is the message of a request."""
    tests = []
    barred = link.barred_address(asked) if asked is not None else None
    for part in head_arguments(frame):
        intervals, beside = _allowed(link, frame, part)
        if intervals:
            assert part.value is not None
            tests.append(within(number(part), Ranges(intervals), beside, packed(part.value.type)))
        if part.role == "unit_address" and barred is not None:
            tests.append(f"{number(part)} != {barred}")
    return [test for test in tests if test]


def greatest_part(link: LinkLayout, part: PartLayout) -> int:
    """The greatest number that the conditions of an unsigned header part accept."""
    assert part.value is not None
    intervals, beside = _allowed(link, link.request, part)
    return max((*(high for _, high in intervals), *beside), default=packed(part.value.type)[1])


def head_refusals(
    link: LinkLayout, frame: FrameLayout, asked: MessageLayout | None = None, is_exception: bool = False
) -> list[str]:
    """The expressions of the refusals of the header parts that the caller passes; `asked` is the message of a request.

    The broadcast address comes first: it is refused for the message, whatever is wrong with other parts.
    """
    refusals = []
    part, barred = link.request.role("unit_address"), link.barred_address(asked) if asked is not None else None
    if asked is not None and part is not None and barred is not None:
        arguments = f"{literal(part.name)}, {variable(part)}, {barred}, {literal(asked.name)}"
        refusals.append(f"_refused_broadcast({arguments})")
    for part in head_arguments(frame):
        assert part.value is not None
        intervals, beside = _allowed(link, frame, part, is_exception)
        limits = [str(part.value.type.low), str(part.value.type.high)]
        if intervals:
            limits.append(pairs(Ranges(intervals)))
        if part.value.flags:
            refusals.append(f"_refused_flags({literal(part.name)}, {variable(part)}, {', '.join(limits[1:])})")
            continue
        if beside:
            limits.append(tuple_of(beside))
        refusals.append(f"_refused_number({literal(part.name)}, {variable(part)}, {', '.join(limits)})")
    return refusals


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
    """Whether all numbers by which a framer finds frames have the byte order of the header."""
    order = next((part.order for part in frame.header if part.size > 1), "big")
    numbers = (frame.role(role) for role in ("unit_address", "code", "length"))
    return all(part is None or part.size == 1 or part.order == order for part in numbers)


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
    order = next((part.order for part in frame.header if part.size > 1), "big")
    ordered = ['order="little"'] if order == "little" else []
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
    order = next((part.order for part in frame.header if part.size > 1), "big")
    return (
        measure is not None
        and measure.field == tail.name
        and field.size <= 2
        and (field.size == 1 or field.order == order)
    )
