"""Frames of fixed length, packed and unpacked in one call with header and checksum."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.checksums import checksum
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_signed
from fieldspec.targets.python.frames import greatest_part, is_simple, letter, variable
from fieldspec.targets.python.reading import local, targets
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.record_writing import writing_lines
from fieldspec.targets.python.records import condition, constant_tests, construction_lines
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import chained, filled, literal, unpacked
from fieldspec.targets.python.writing import greatest

TABLES = 8
_WORDS = "crc16_modbus"
_APPENDED = {
    "": "",
    "crc16_modbus": ' + _crc16_modbus(data).to_bytes(2, "little")',
    "lrc": " + _BYTES[-sum(data) & 255]",
    "sum8": " + _BYTES[sum(data) & 255]",
}
# The letters of the checksum in a received frame, their targets, and the condition of a wrong checksum.
_TAKEN = {
    "": ("", [], []),
    "crc16_modbus": ("2x", [], ["_crc16_modbus(data)"]),
    "lrc": ("x", [], ["sum(data) & 255"]),
    "sum8": ("B", ["check"], ["(sum(data) - check) & 255 != check"]),
}
_BIG = (
    ' + _crc16_modbus(data).to_bytes(2, "big")',
    ("2s", ["check"], ['_crc16_modbus(data[:-2]).to_bytes(2, "big") != check']),
)


@dataclass(frozen=True, slots=True)
class FixedFrame:
    """The code of one message on one link in one direction.

    `declared` defines `pack` and `unpack`. To write, `bind` locals; where `tests` hold, `steps` return the frame. To
    read, `unpack`, which may raise `unread`; unless the condition `wrong` holds, `lines` create the message.
    """

    declared: list[str]
    bind: list[str]
    tests: list[str]
    steps: list[str]
    unpack: list[str]
    unread: str
    wrong: str
    lines: list[str]


def has_fixed_length(shaped: RecordShape, frame: FrameLayout) -> bool:
    """Whether the frames of a message are packed and unpacked in one call."""
    lists = sum(field.is_list and not field.skipped for field in shaped.fields)
    if shaped.record.size is None or shaped.selector is not None or lists > 1:
        return False
    if not is_simple(frame):
        return False
    orders = {part.order for part in frame.header if part.size > 1}
    if any(field.letters.strip("0123456789sx") not in ("", "B", "b") for field in shaped.fields):
        orders.add(shaped.order)
    return len(orders) <= 1


def fixed_frame(
    shaped: RecordShape,
    link: LinkLayout,
    direction: str,
    code: int | None,
    name: str,
    frames: str,
    tests: list[str],
    reads: bool,
) -> FixedFrame:
    """The code of one message; it writes frames, and reads them where `reads` is set.

    `name` is the suffix of `_PACK` and `_UNPACK`, `frames` the name of the link's `Frames`, `tests` are the conditions
    of the header.
    """
    frame = link.frame(direction)
    order = next((part.order for part in frame.header if part.size > 1), shaped.order)
    size = frame.header_size + (shaped.record.size or 0)
    known = {"code": code, "length": size + frame.trailer_size}
    constants = {part.name: number for part in frame.header if (number := known.get(part.role)) is not None}
    always = {part.name: number for part in frame.header if (number := part.constant) is not None}
    constants |= always
    algorithm = frame.checksum.algorithm if frame.checksum else ""
    looked_up = algorithm == _WORDS and size <= TABLES and all(map(_single, shaped.fields))
    writing = writing_lines(shaped, frozenset(field.title for field in shaped.stored) if looked_up else frozenset(), "")
    letters = ("<" if order == "little" else ">") + "".join(map(letter, frame.header)) + shaped.letters
    packed = [_slot(part, constants) for part in frame.header] + writing.values
    marked = f"{frames}.marked" if frame.is_marked or link.link.transmission == "hex_ascii" else ""
    into = [_target(part) for part in frame.header]
    into += [target for field in shaped.fields for target in targets(field, "message", looked_up)]
    check: list[str] = []
    compared: list[str] = []
    unread = "_StructError"
    declared: list[str] = []
    if looked_up:
        encoding_terms, read = (
            list(_crc_terms(shaped, link, frame, constants, order, size, raw)) for raw in (".raw", "")
        )
        unit_address = frame.role("unit_address")
        if unit_address is not None and unit_address.size == 1:
            maximum, table = greatest_part(link, unit_address), f"_UNIT_ADDRESSES{name}"
            declared = [_begun(table, encoding_terms, maximum)]
            encoding_terms, read = (
                [f"{table}[unit_address]", *_terms_outside_table(terms)] for terms in (encoding_terms, read)
            )
            # The table has no greater addresses, and `pack` refuses negative ones.
            tests = [test for test in tests if test != f"unit_address <= {maximum}"]
        letters += "H"
        packed.append("check")
        check = chained("check = ", encoding_terms, "^", "", 16)
        compared = chained("expected = ", read, "^", "", 12)
        unread = "_UNREAD"
        # The tables have the terms of the expected constants, so each received constant is compared as well.
        wrong = ["check != expected", *constant_tests(shaped)]
        appended, check_letters, checked = "", "", ["check"]
    else:
        big = algorithm == _WORDS and frame.checksum is not None and frame.checksum.order == "big"
        appended, (check_letters, checked, wrong) = _BIG if big else (_APPENDED[algorithm], _TAKEN[algorithm])
    wrong = [*(f"{variable(p)} != {constants[p.name]}" for p in frame.header if p.role == "length"), *wrong]
    wrong = [*(f"{variable(p)} != {always[p.name]}" for p in frame.header if p.name in always), *wrong]
    conditions = condition([*tests, *writing.tests])
    return FixedFrame(
        declared=[*_declared(name, letters, letters + check_letters, reads), *declared],
        bind=writing.bind,
        tests=conditions,
        steps=[*check, *_packing(f"_PACK{name}(", packed, marked, appended, 16 if conditions else 12)],
        unpack=[*unpacked([*into, *checked], f"_UNPACK{name}(data)", 12), *compared],
        unread=unread,
        wrong=" or ".join(wrong),
        lines=construction_lines(shaped, "message", frame.header_size, looked_up),
    )


def _declared(name: str, letters: str, read: str, reads: bool) -> list[str]:
    """The statements that define `_PACK`, and `_UNPACK` where frames are read."""
    if reads and read == letters:
        return filled(f"_PACK{name}, _UNPACK{name} = _packing(", [literal(letters)], ")", 0)
    lines = [f"_PACK{name} = _Struct({literal(letters)}).pack"]
    return [*lines, f"_UNPACK{name} = _Struct({literal(read)}).unpack"] if reads else lines


_UNIT_ADDRESS = "[unit_address]"


def _begun(table: str, terms: list[str], maximum: int) -> str:
    """The statement of the table that begins a CRC: the constant, combined with the term of each unit address."""
    unit_address_terms = next(term for term in terms if term.endswith(_UNIT_ADDRESS)).removesuffix(_UNIT_ADDRESS)
    return f"{table} = tuple({terms[0]} ^ term for term in {unit_address_terms}[:{maximum + 1}])"


def _terms_outside_table(terms: list[str]) -> list[str]:
    """The terms of a CRC that are not in its table."""
    return [term for term in terms[1:] if not term.endswith(_UNIT_ADDRESS)]


def _packing(call: str, packed: list[str], marked: str, appended: str, indent: int) -> list[str]:
    """Lines that return the frame: the packed values, the bytes appended to them, and the delimiters around."""
    if not marked and not appended:
        return filled(f"return {call}", packed, ")", indent)
    whole = f"{marked}(data{appended})" if marked else f"data{appended}"
    return [*filled(f"data = {call}", packed, ")", indent), f"return {whole}"]


def _slot(part: PartLayout, constants: dict[str, int]) -> str:
    """The expression of the slot of a header part."""
    if part.name not in constants:
        return variable(part)
    return f"{constants[part.name]:#04x}" if part.role == "code" else str(constants[part.name])


def _single(field: Slots) -> bool:
    """Whether a field is one number in one slot, so that its bytes can be computed from the number.

    A received reserved field may have any value and still counts for the checksum, so it is excluded.
    """
    if field.field.record is not None or field.is_list or field.field.field.measures or field.field.field.reserved:
        return False
    return len(field.letters) == 1 and field.letters in "BbHhIiQq"


def _target(part: PartLayout) -> str:
    """The target of a header part. The code has been read before."""
    return "_" if part.role == "code" else variable(part)


def _crc_terms(
    shaped: RecordShape,
    link: LinkLayout,
    frame: FrameLayout,
    constants: dict[str, int],
    order: str,
    size: int,
    raw: str,
) -> Iterator[str]:
    """The terms whose exclusive or is the CRC: one constant, and a look-up for each byte that varies.

    Bytes that are 0 in all valid numbers need no look-up. The look-up of the byte below them then raises IndexError
    for greater numbers, and such a frame is read step by step. `raw` is the suffix that turns a word of flags into a
    number.
    """
    base = bytearray(size)
    varying: list[tuple[int, int, bool, int, str]] = []
    for part in frame.header:
        if part.name in constants:
            number = constants[part.name] & ((1 << 8 * part.size) - 1)
            known = number.to_bytes(part.size, "little" if part.order == "little" else "big")
            base[part.offset : part.offset + part.size] = known
        else:
            signed = part.value is not None and is_signed(part.value.encoding)
            varying.append((part.offset, part.size, signed, greatest_part(link, part), variable(part)))
    for field in shaped.fields:
        offset = frame.header_size + field.field.offset
        if field.stored:
            flags = raw if field.value.flags and not field.deferred else ""
            signed, maximum = is_signed(field.value.encoding), greatest(field)
            varying.append((offset, field.field.size, signed, maximum, local(field) + flags))
        elif field.constant:
            base[offset : offset + field.field.size] = field.bytes_of(field.constant)
    constant, same = checksum(_WORDS, bytes(base)), frame.checksum is not None and frame.checksum.order == order
    yield str(constant if same else (constant & 0xFF) << 8 | constant >> 8)
    table = "_C" if same else "_X"
    for offset, width, signed, maximum, expression in varying:
        for place in range(width):
            shift = 8 * (place if order == "little" else width - 1 - place)
            if shift and not signed and not maximum >> shift:
                continue
            byte = f"{expression} >> {shift}" if shift else expression
            if signed or maximum >> shift > 255:
                byte += " & 255"
            yield f"{table}{size - 1 - offset - place}[{byte}]"
