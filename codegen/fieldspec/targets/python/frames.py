"""Frame headers, and the arguments of the frames of a link."""

from __future__ import annotations

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.checksums import SIMPLE, Checksum, checksum_named
from fieldspec.language.model.encoding import Sign, number_of, struct_letter
from fieldspec.language.model.ranges import Ranges
from fieldspec.targets.python.codecs import codec_key
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.slots import Words
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import packed, pairs, tuple_of, within


@dataclass(frozen=True, slots=True)
class PartView:
    """A header part that the caller passes: its attribute, variable and type, and the expressions that read it.

    `accepted` is the type that encoders take, a word of bits also as a number; `number` is the number of an argument.
    """

    name: str
    variable: str
    type: str
    accepted: str
    number: str
    expression: str
    quickly: str


def variable(part: PartLayout) -> str:
    """The variable of a header part."""
    return "unit_address" if part.role == "unit_address" else f"part_{part.name}"


def letter(part: PartLayout) -> str:
    """The letter of a header part in its Struct."""
    assert part.value is not None
    return struct_letter(part.value.encoding)


def _argument_view(part: PartLayout, place: int, words: Words) -> PartView:
    flags = part.value.flags if part.value else ""
    construction = f"{words.flags[flags]}({{}})" if flags else "{}"
    name = Scope(frozenset({"unit_address", "message", "self", "frame", "request"})).take(part.name)
    return PartView(
        name=name,
        variable=variable(part),
        type=words.flags[flags] if flags else "int",
        accepted=f"{words.flags[flags]} | int" if flags else "int",
        number=f"{name}.raw if isinstance({name}, _Flags) else {name}" if flags else name,
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
    return code if part.role == "code" else variable(part) if fixed_number is None else str(fixed_number)


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
        singles = () if unit_addresses.broadcast is None else (unit_addresses.broadcast,)
        return unit_addresses.ranges.intervals, singles
    return (part.value.ranges.intervals if part.value.ranges else ()), ()


def is_simple(frame: FrameLayout) -> bool:
    """Whether a header of one byte order precedes the body and, at most, a checksum over everything before it.

    A length then counts all parts. Any other frame is read and written part by part, which is slower.
    """
    check, length = frame.checksum, frame.role("length")
    return (
        frame.escape is None
        and len(frame.lengths) < 2
        and len({part.order for part in frame.header if part.size > 1}) <= 1
        and not any(part.reserved or part.form or part.width or _has_no_letter(part) for part in frame.header)
        and frame.trailer == (() if check is None else (check,))
        and (check is None or _is_usual(check))
        and (length is None or (length.unit_size, length.base) == (1, 0))
    )


def _has_no_letter(part: PartLayout) -> bool:
    """Whether a part is a number that no letter of a Struct stands for."""
    return part.value is not None and not struct_letter(part.value.encoding)


def _is_usual(check: PartLayout) -> bool:
    """Whether a checksum has an algorithm with its own function, covers everything before it, and is sent as bytes."""
    return check.algorithm in SIMPLE and not check.digits and (check.start, check.stop) == (0, check.offset)


def escape_call(frame: FrameLayout) -> str:
    """`.escaping(_Cobs(), 0, None, ...)`: what gives frames their escape; empty where they have none."""
    escape = frame.escape
    if escape is None:
        return ""
    places = {place: part for place, part in enumerate(frame.parts) if part.role in ("length", "checksum")}
    sent_places = sorted(place for place, part in places.items() if not part.before_escape)
    own = sorted(place for place, part in places.items() if part.before_escape)
    remote = [] if escape.remote is None else [f"remote={escape.remote}"]
    construction = {
        "cobs": "_Cobs()",
        "replace": f"_Replace({escape.pairs})",
        "can": f"_CanIdentifier({', '.join(map(str, (escape.bits, *escape.fields, *remote)))})",
        "add": f"_Add({escape.inserted:#04x})",
        "insert": f'_Insert(bytes.fromhex("{escape.pattern.hex()}"), {escape.inserted:#04x})',
    }[escape.method]
    bounds = f"{frame.escape_start}, {frame.escape_stop}"
    return f".escaping({construction}, {bounds}, frozenset({sent_places}), frozenset({own}))"


def check_rows(frame: FrameLayout) -> str:
    """The checksums in the order in which they are computed: place, function, what it covers, and its digits."""
    rows = [
        f"({frame.parts.index(check)}, {_checksum(check)}, {check.start}, {check.stop}, {literal(check.digits)})"
        for check in frame.checksums
    ]
    return tuple_of(rows) if rows else "()"


def _checksum(check: PartLayout) -> str:
    """`_Sum(8)`, `_Crc(16, 0x1021, 0xFFFF, False, False, 0x0)`: the function of an algorithm."""
    kind = checksum_named(check.algorithm)
    function = _function(kind, check.order)
    if kind.method == "crc" and kind.unit_size > 1:
        function = f"_Swapped({function}, {kind.unit_size})"
    if kind.suffix:
        function = f'_Followed({function}, bytes.fromhex("{kind.suffix.hex()}"))'
    if kind.avoided:
        pairs = dict(zip(kind.avoided, kind.replacements, strict=True))
        function = f"_Avoiding({function}, {kind.size}, {pairs})"
    return function


def _function(kind: Checksum, byte_order: str) -> str:
    if kind.codec:
        return f"_CHECKSUMS[{literal(codec_key(kind.codec))}]"
    if kind.method == "crc":
        numbers = f"{kind.width}, {kind.polynomial:#x}, {kind.initial:#x}"
        return f"_Crc({numbers}, {kind.reflect_in}, {kind.reflect_out}, {kind.final_xor:#x})"
    order = literal("little" if (kind.unit_order or byte_order) == "little" else "big")
    if kind.method == "fletcher":
        return f"_Fletcher({kind.width}, {kind.initial:#x}, {kind.modulus}, {kind.unit_size}, {order})"
    name = "_Sum" if kind.method == "sum" else "_Xor"
    return f"{name}({kind.width}, {kind.initial:#x}, {literal(kind.complement)}, {kind.unit_size}, {order})"


def part_rows(parts: tuple[PartLayout, ...]) -> str:
    """Parts as the rows of a tuple: name, size, order, sign, constant, and whether a received constant is compared.

    In place of an order, a part that is sent as digits has their form.
    """
    rows = [
        f"({literal(part.name)}, {part.size}, {literal(part.form or part.order)}, {_signed(part)}, {part.constant},"
        f" {part.constant is not None and not part.reserved})"
        for part in parts
    ]
    return tuple_of(rows) if rows else "()"


def _signed(part: PartLayout) -> str:
    """Whether a part has a sign: `True` in two's complement, `None` for one that is a bit of its own."""
    whole = number_of(part.value.encoding) if part.value is not None else None
    match Sign.NONE if whole is None else whole.sign:
        case Sign.NONE:
            return "False"
        case Sign.COMPLEMENT:
            return "True"
        case Sign.MAGNITUDE:
            return "None"
        case unknown:
            assert_never(unknown)


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
                arguments += [f"length_name={literal(part.name)}", f"longest={_longest(part)}"]
    for name, mark in (("start", frame.start), ("end", frame.end)):
        if mark:
            arguments.append(f'{name}=bytes.fromhex("{mark.hex()}")')
    if frame.preamble is not None:
        own = frame.preamble
        arguments.append(f"preamble=({own.byte}, {own.least}, {len(own.further)}, {own.spare})")
    if link.link.transmission == "hex_ascii":
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
    further_lengths = [
        f"({frame.header.index(part)}, {part.offset}, {literal(part.name)}, {_longest(part)}, {part.unit_size},"
        f" {part.base})"
        for part in frame.lengths[1:]
    ]
    arguments += [f"lengths={tuple_of(further_lengths)}"] if further_lengths else []
    bits = {place: (part.shift, part.width) for place, part in enumerate(frame.header) if part.width}
    return [*arguments, *([f"bits={bits}"] if bits else [])]


def _longest(part: PartLayout) -> int:
    """The greatest number of a length."""
    return part.value.high if part.value is not None else 0


def head_tests(link: LinkLayout, frame: FrameLayout, request: MessageLayout | None) -> list[str]:
    """The conditions on the header parts that the caller passes; `request` is the message of a request."""
    tests = []
    barred = link.barred_address(request) if request is not None else None
    for part in head_arguments(frame):
        intervals, singles = _allowed(link, frame, part)
        if intervals:
            assert part.value is not None
            further = ((number, number) for number in singles)
            tests.append(within(variable(part), Ranges(intervals), further, packed(part.value.encoding)))
        if part.role == "unit_address" and barred is not None:
            tests.append(f"{variable(part)} != {barred}")
    return [test for test in tests if test]


def greatest_part(link: LinkLayout, part: PartLayout) -> int:
    """The greatest number that the conditions of an unsigned header part accept."""
    assert part.value is not None
    intervals, singles = _allowed(link, link.request, part)
    return max((*(high for _, high in intervals), *singles), default=packed(part.value.encoding)[1])


def head_refusals(
    link: LinkLayout, frame: FrameLayout, request: MessageLayout | None = None, is_exception: bool = False
) -> list[str]:
    """The expressions of the refusals of the header parts that the caller passes.

    `request` is the message of a request. The broadcast address comes first: it is refused for the message, whatever is
    wrong with other parts.
    """
    refusals = []
    part, barred = link.request.role("unit_address"), link.barred_address(request) if request is not None else None
    if request is not None and part is not None and barred is not None:
        arguments = f"{literal(part.name)}, {variable(part)}, {barred}, {literal(request.name)}"
        refusals.append(f"_refused_broadcast({arguments})")
    for part in head_arguments(frame):
        assert part.value is not None
        intervals, singles = _allowed(link, frame, part, is_exception)
        limits = [str(part.value.low), str(part.value.high)]
        if intervals:
            limits.append(pairs(Ranges(intervals)))
        if singles:
            limits.append(tuple_of(singles))
        refusals.append(f"_refused_number({literal(part.name)}, {variable(part)}, {', '.join(limits)})")
    return refusals
