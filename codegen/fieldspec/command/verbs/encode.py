"""`fieldspec encode`: the frame of a message."""

from __future__ import annotations

import argparse
import re
from collections.abc import Collection, Iterator, Mapping

from fieldspec.codec.explain.entered import parameter_number
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.occupants import Occupant, forbidden, occupant_at
from fieldspec.codec.explain.readings import DIRECTIONS
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.spans import accessed
from fieldspec.codec.layout.bits import packed_bits
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.layout.values import MeaningError, Raw, body_of, raw_of, raw_value
from fieldspec.command.console.streams import print_json, print_line
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.frames.encode_parameters import whole_count, with_parameter
from fieldspec.command.frames.frame_options import frame_options, number_of
from fieldspec.command.sources import layout_cache
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.quantity import count_of
from fieldspec.language.model.record import RegisterAccess

_MOST = 20
_WRITE = "write"
_UNIT = "unit"
"""The name of the unit address on the command line, whatever the manual calls it."""


def run(arguments: argparse.Namespace) -> int:
    """Prints the frame in hexadecimal, and as characters where it consists of them. Raises UsageError."""
    from fieldspec.codec.reference import CodecError, codec

    layout = layout_cache.requested_layout(arguments)
    if _writes_by_name(layout, arguments):
        return _write_by_name(layout, arguments)
    frame_kind, pairs = _way(layout, arguments)
    if frame_kind.direction == "request" and not layout.messages[frame_kind.message].message.is_requested:
        raise UsageError(f"only the device sends {frame_kind.message}; use: --direction response")
    texts = _nested(pairs)
    fields = _fields(layout, frame_kind)
    address = layout.links[frame_kind.link].frame(frame_kind.direction).role("unit_address")
    if address is not None and _UNIT in texts and _UNIT not in fields and address.name not in texts:
        texts[address.name] = texts.pop(_UNIT)
    body = body_of(layout, frame_kind.link, frame_kind.direction, frame_kind.message, False)
    _by_print(layout, frame_kind, texts)
    for name in texts:
        if name not in fields:
            reason = computed(layout.links[frame_kind.link].frame(frame_kind.direction), body, name)
            raise UsageError(f"{reason}; give {', '.join(fields)}") if reason else unknown("field", name, fields)
    _with_address(layout, frame_kind.message, texts)
    parts = layout.links[frame_kind.link].frame(frame_kind.direction).header
    try:
        _with_words(layout, frame_kind.message, texts)
        with_parameter(layout, body, frame_kind.direction, texts)
        counts = {name: _count_of(layout, frame_kind, name, value) for name, value in texts.items()}
        values = raw_of(layout.device, parts, body, counts)
        _refuse_access(layout, frame_kind, values)
        frame = codec(layout).links[frame_kind.link].encode(frame_kind.direction, frame_kind.message, values)
    except (MeaningError, CodecError) as error:
        raise UsageError(f"{error}; {_way_text(layout, frame_kind)} has the fields {', '.join(fields)}") from None
    _judge(layout, frame_kind, frame)
    _print(layout, frame_kind, arguments.format, frame)
    return 0


def _writes_by_name(layout: DeviceLayout, arguments: argparse.Namespace) -> bool:
    """Whether the arguments are `write NAME=VALUE`, and no message is called `write`."""
    is_named = arguments.message is not None or arguments.words
    return not is_named and arguments.assignments[:1] == [_WRITE] and _WRITE not in layout.messages


def _write_by_name(layout: DeviceLayout, arguments: argparse.Namespace) -> int:
    """Prints the frames that write registers or parameters by their names. Raises UsageError."""
    from fieldspec.command.live.connection import (
        access_of,
        connected,
        fixed_options,
        link_of_values,
        unit_address_option,
    )
    from fieldspec.command.live.writing import assignments, frames_of

    if arguments.direction == "response":
        raise UsageError(f"{_WRITE} makes requests; name the message to encode a response")
    name = link_of_values(layout, arguments)
    pairs, unit = unit_address_option(layout, name, arguments.assignments[1:])
    pairs, fixed = fixed_options(layout, name, pairs)
    line = dict.fromkeys(("baud", "parity", "data_bits", "timeout", "pause", "port"))
    settings = argparse.Namespace(link=name, unit=unit, fixed=fixed, format="json", trace=False, retries=0, **line)
    with connected(layout, settings) as client:
        access = access_of(client)
        for names, frame in frames_of(client, access, assignments(layout, access, pairs)):
            request = client.frames.decode(frame, "request")
            message = request.message.name if request.message is not None else names
            _print(layout, _Way(client.frames.link.name, "request", message), arguments.format, frame)
    return 0


def _judge(layout: DeviceLayout, frame_kind: _Way, frame: bytes) -> None:
    """Refuses a frame with a value that no codec can judge alone: one beyond the range of the parameter or of the
    register that it is written to.
    """
    explanation = explained(layout, frame_kind.link, frame_kind.direction, frame, frame_kind.message)
    wrong = [row for row in (*explanation.rows, *explanation.registers) if row.verdict.startswith("wrong")]
    if wrong and frame_kind.direction == "request":
        reasons = "; ".join(f"{_row_name(row)} is {row.value or spec_text(row.number)}: {row.verdict}" for row in wrong)
        raise UsageError(f"out_of_range: {reasons}")


def _row_name(row: ExplanationRow) -> str:
    """The path of a value, with the name of its parameter."""
    return row.path if not row.meanings or not row.meanings[0].name else f"{row.path} ({row.meanings[0].name})"


@dataclass(frozen=True, slots=True)
class _Way:
    """The message, its link and its direction."""

    link: str
    direction: str
    message: str


def _way(layout: DeviceLayout, arguments: argparse.Namespace) -> tuple[_Way, list[str]]:
    """The message, and the assignments of values."""
    pairs = list(arguments.assignments)
    has_option = arguments.message is not None or arguments.words
    if not has_option and pairs and "=" not in pairs[0]:
        arguments.message = pairs.pop(0)
    options = frame_options(layout, arguments)
    if not options.message:
        from fieldspec.command.live.connection import has_registers

        names = _names_text(layout.messages)
        by_name = f"; a register is written by its name: {_WRITE} NAME=VALUE" if has_registers(layout) else ""
        raise UsageError(f"name the message; {layout.device.id} has {names}{by_name}")
    usual = layout.device.default_link
    link, direction = next((place for place in options.places if place[0] == usual), options.places[0])
    return _Way(link, direction if arguments.direction else "request", options.message), pairs


def _way_text(layout: DeviceLayout, frame_kind: _Way) -> str:
    name = layout.device.links[frame_kind.link].direction_name(frame_kind.direction)
    return f"the {name}" if name in DIRECTIONS else f"{frame_kind.message} {name}"


def _names_text(names: Collection[str]) -> str:
    return ", ".join(names) if len(names) <= _MOST else f"{len(names)} of them; `fieldspec show` lists them"


def _nested(pairs: list[str]) -> dict[str, object]:
    """`items.0.size=1`, or `items[0].size=1`, as nested mappings and lists; `items=[]` is an empty list."""
    root: dict[str, object] = {}
    for pair in pairs:
        name, equals, value = pair.partition("=")
        if not equals or not name:
            raise UsageError(f"{pair} is not of the form NAME=VALUE")
        *path, last = _INDEX.sub(r".\1", name).split(".")
        occupant = root
        for step in path:
            inner = occupant.setdefault(step, {})
            if not isinstance(inner, dict):
                raise UsageError(f"{name}: {step} has a value of its own")
            occupant = inner
        if last in occupant:
            raise UsageError(f"{name} has two values")
        occupant[last] = [] if value == "[]" else value
    return {name: _lists_of(value) for name, value in root.items()}


def _lists_of(value: object) -> object:
    """Mappings whose keys are 0, 1, ... as lists."""
    if not isinstance(value, dict):
        return value
    inner = {key: _lists_of(inner_value) for key, inner_value in value.items()}
    if sorted(inner, key=_order) == [str(number) for number in range(len(inner))]:
        return [inner[str(number)] for number in range(len(inner))]
    return inner


def _order(key: str) -> tuple[int, str]:
    return len(key), key


def _by_print(layout: DeviceLayout, frame_kind: _Way, texts: dict[str, object]) -> None:
    """Replaces printed names by the names of fields. Raises UsageError for a field with two values."""
    body = body_of(layout, frame_kind.link, frame_kind.direction, frame_kind.message, False)
    printed = {field.field.printed_name.lower(): field.name for field in body.fields if field.field.printed_name}
    for name in [name for name in texts if body.named(name) is None and name.lower() in printed]:
        own = printed[name.lower()]
        if own in texts:
            raise UsageError(f"{name} and {own} are the same field; give it one value")
        texts[own] = texts.pop(name)


def _with_address(layout: DeviceLayout, message: str, texts: dict[str, object]) -> None:
    """Replaces the name of a register by its address. Raises UsageError for a register in another space."""
    device = layout.device
    own = layout.messages[message].message
    accesses = device.register_access(own) or device.bit_access(own)
    start_value = texts.get(accesses.start) if accesses else None
    register = device.register(start_value) if isinstance(start_value, str) else None
    if accesses is None or register is None:
        return
    theirs, ours = device.space_name(register.space), device.space_name(accesses.space)
    if theirs != ours:
        raise UsageError(f"{register.name} lies in {theirs}, and {message} {accesses.operation}s {ours}")
    texts[accesses.start] = register.address


def _with_words(layout: DeviceLayout, message: str, texts: dict[str, object]) -> None:
    """Replaces quantities and names by the words of registers, and truth values by bits. Raises UsageError."""
    bits = layout.device.bit_access(layout.messages[message].message)
    if bits is not None and isinstance(text := texts.get(bits.values), str):
        texts[bits.values] = carried_bits(bits, text)
    access = layout.device.register_access(layout.messages[message].message)
    if access is None or access.operation != "write":
        return
    text, start = texts.get(access.values), texts.get(access.start)
    address = number_of(start) if isinstance(start, str) else start
    if not isinstance(text, str) or not isinstance(address, int):
        return
    words = register_words(layout, access, address, text)
    field = layout.messages[message].request.named(access.values)
    if words is None or field is None:
        return
    if not field.is_list and len(words) != 1:
        unit = layout.device.space(access.space).unit
        raise UsageError(f"{text} takes {len(words)} {unit}s, and {message} writes one")
    texts[access.values] = words if field.is_list else words[0]


def _refuse_access(layout: DeviceLayout, frame_kind: _Way, values: Mapping[str, Raw]) -> None:
    """Refuses to write what can only be read, and to read what can only be written. Raises UsageError."""
    if frame_kind.direction != "request":
        return
    for access in layout.messages[frame_kind.message].message.accesses:
        words = values.get(access.values)
        count = len(words) if isinstance(words, list) else 0 if words is None else 1
        carried = bytes(layout.device.space(access.space).unit_size * count) if access.operation == "write" else b""
        span = accessed(layout.device, access, values, {}, 0, carried)
        objection = forbidden(layout, span, access.operation) if span is not None else ""
        if objection:
            raise UsageError(f"{objection}; no frame is written")


def _count_of(layout: DeviceLayout, frame_kind: _Way, name: str, text: object) -> object:
    """A value as counts, where that needs more than its own field: the number of a named parameter, and a quantity
    between two counts, which is rounded as in the generated code. Says what it rounds.
    """
    body = body_of(layout, frame_kind.link, frame_kind.direction, frame_kind.message, False)
    field = body.named(name)
    value = field.value if field else None
    if value is None or not isinstance(text, str):
        return text
    if value.parameter is not None and value.parameter.part == "number":
        number = parameter_number(layout.device, value.parameter.set, text)
        return text if number is None else number
    return whole_count(layout, name, value, text)


def _fields(layout: DeviceLayout, frame_kind: _Way) -> list[str]:
    """The names that take values: parts of the header that nothing else decides, and fields of the body."""
    shape = layout.links[frame_kind.link].frame(frame_kind.direction)
    head = [part.name for part in shape.header if part.role in ("unit_address", "plain") and not part.reserved]
    body = body_of(layout, frame_kind.link, frame_kind.direction, frame_kind.message, False)
    return [*head, *(field.name for field in body.fields if field.field.measures is None)]


def _print(layout: DeviceLayout, frame_kind: _Way, form: str, frame: bytes) -> None:
    characters = frame.decode("latin-1") if layout.links[frame_kind.link].link.transmission == "hex_ascii" else None
    if form == "json":
        data = {
            "device": layout.device.id,
            "version": layout.device.version,
            "link": frame_kind.link,
            "direction": frame_kind.direction,
            "direction_name": layout.device.links[frame_kind.link].direction_name(frame_kind.direction),
            "message": frame_kind.message,
            "frame": frame.hex().upper(),
            "characters": characters,
        }
        print_json(data, indent=1)
        return
    print_line(frame.hex(" ").upper())
    if form == "text" and characters is not None:
        print_line(characters)


_BITS = {"true": 1, "false": 0, "on": 1, "off": 0}


def carried_bits(access: RegisterAccess, text: str) -> object:
    """The numbers that a message carries for `on, off, true`; the text itself otherwise.

    Raises UsageError.
    """
    bits = [_BITS.get(item.strip().lower()) for item in text.split(",")]
    if None in bits:
        return text
    if access.set is None:
        return list(packed_bits([bit or 0 for bit in bits]))
    if len(bits) != 1:
        raise UsageError(f"{text} has {len(bits)} bits, and the message carries one")
    return access.set if bits[0] else access.clear


_INDEX = re.compile(r"\[([0-9]{1,5})\]")
_COUNTS = re.compile(r"[-+]?(?:0x[0-9A-Fa-f]+|[0-9]+)(?:[, ]+[-+]?(?:0x[0-9A-Fa-f]+|[0-9]+))*")


def register_words(layout: DeviceLayout, access: RegisterAccess, start: int, text: str) -> list[int] | None:
    """The words of `50.00 mm, 0x0001`: a quantity or a name stands for the whole value of the register at its address.

    None where all items are raw words. Raises UsageError for an item that no register at its address takes.
    """
    if _COUNTS.fullmatch(text.strip()):
        return None
    words: list[int] = []
    for item in (item.strip() for item in text.split(",")):
        if not item and "," in text:
            raise UsageError(f"{access.values}: `{text}` has a comma without a value")
        words += _words(layout, access, start + len(words), item)
    return words


def _words(layout: DeviceLayout, access: RegisterAccess, address: int, item: str) -> Iterator[int]:
    count, space = count_of(item), layout.device.space(access.space)
    if count is not None and 0 <= count < 1 << 8 * space.unit_size:
        yield count
        return
    occupant = occupant_at(layout, access.space, address)
    if occupant is None or occupant.value.size % space.unit_size:
        text = f"no register or field of {space.unit}s begins at 0x{address:04X}, so that `{item}` has no meaning"
        raise UsageError(text)
    data = _bytes(layout, occupant, access.operation, item)
    big = layout.device.byte_order == "big"
    for offset in range(0, len(data), space.unit_size):
        yield int.from_bytes(data[offset : offset + space.unit_size], "big" if big else "little")


def _bytes(layout: DeviceLayout, occupant: Occupant, operation: str, item: str) -> bytes:
    """The bytes of a value in the order of the registers."""
    from fieldspec.codec.reference.records import encoded_value
    from fieldspec.codec.reference.structs import value_construct

    text = whole_count(layout, occupant.path, occupant.value, item)
    raw = raw_value(layout.device, occupant.path, occupant.value, text)
    known = encoded_value(occupant.path, occupant.value, raw, layout.device)
    built: bytes = value_construct(occupant.value, occupant.order, occupant.is_swapped(operation)).build(known)
    return built


_OF_ROLES = {
    "length": "it is the length of what it counts",
    "checksum": "it is the checksum of what it covers",
    "code": "it is the code of the message",
}


def computed(shape: FrameLayout, body: RecordLayout, name: str) -> str:
    """`word_count is not given: it is the number of values`; empty for a name that the frame and its body lack."""
    for part in (*shape.header, *shape.trailer):
        if part.name == name:
            reason = "it is reserved" if part.reserved else _OF_ROLES.get(part.role, "its bytes are constant")
            return f"{name} is not given: {reason}"
    field = body.named(name)
    measure = field.field.measures if field is not None else None
    if measure is None:
        return ""
    measure_text = "the number of bytes of" if measure.of == "bytes" else "the number of"
    plus_text = f", and {measure.plus} more" if measure.plus else ""
    return f"{name} is not given: it is {measure_text} {measure.field}{plus_text}"
