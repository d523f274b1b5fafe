"""`fieldspec encode`: the frame of a message."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Collection, Mapping

from fieldspec.classes import dataclass
from fieldspec.commands import compiled
from fieldspec.commands.frame_options import frame_options, number_of
from fieldspec.commands.register_words import register_words
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.explain.explanation import explained
from fieldspec.explain.parameters import nearest, parameter_number
from fieldspec.explain.readings import DIRECTIONS
from fieldspec.explain.registers import accessed, forbidden
from fieldspec.explain.row import ExplanationRow
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.values import MeaningError, Raw, body_of, raw_of
from fieldspec.render.blocks import visible_text

_MOST = 20


def run(arguments: argparse.Namespace) -> int:
    """Prints the frame as hexadecimal bytes, with its characters where it is made of them."""
    from fieldspec.reference import CodecError, codec

    layout = compiled.asked(arguments)
    way, pairs = _way(layout, arguments)
    written = _nested(pairs)
    fields = _fields(layout, way)
    _by_print(layout, way, written)
    for name in written:
        if name not in fields:
            raise unknown("field", name, fields)
    _with_address(layout, way.message, written)
    parts = layout.links[way.link].frame(way.direction).head
    body = body_of(layout, way.link, way.direction, way.message, False)
    try:
        _with_words(layout, way.message, written)
        counted = {name: _count_of(layout, way, name, held) for name, held in written.items()}
        values = raw_of(layout.device, parts, body, counted)
        _refuse_access(layout, way, values)
        frame = codec(layout).links[way.link].encode(way.direction, way.message, values)
    except (MeaningError, CodecError) as error:
        raise UsageError(f"{error}; {_spoken(layout, way)} has the fields {', '.join(fields)}") from None
    _judge(layout, way, frame)
    _print(layout, way, arguments.format, frame)
    return 0


def _judge(layout: DeviceLayout, way: _Way, frame: bytes) -> None:
    """Refuses a frame with a value that no codec can judge alone: one beyond the range of the parameter or of the
    register that it is written to.
    """
    found = explained(layout, way.link, way.direction, frame, way.message)
    wrong = [row for row in (*found.rows, *found.registers) if row.verdict.startswith("wrong")]
    if wrong and way.direction == "request":
        said = "; ".join(f"{_row_name(row)} is {row.value or repr(row.number)}: {row.verdict}" for row in wrong)
        raise UsageError(f"out_of_range: {said}")


def _row_name(row: ExplanationRow) -> str:
    """The path of a value, with the parameter that it is."""
    return row.path if not row.meanings or not row.meanings[0].name else f"{row.path} ({row.meanings[0].name})"


@dataclass(frozen=True, slots=True)
class _Way:
    """Which message is sent, and which way."""

    link: str
    direction: str
    message: str


def _way(layout: DeviceLayout, arguments: argparse.Namespace) -> tuple[_Way, list[str]]:
    """The message, and the values behind it."""
    pairs = list(arguments.given)
    named = arguments.message is not None or arguments.words
    if not named and pairs and "=" not in pairs[0]:
        arguments.message = pairs.pop(0)
    said = frame_options(layout, arguments)
    if not said.message:
        raise UsageError(f"nothing says which message it is; {layout.device.id} has {_some(layout.messages)}")
    if arguments.direction:
        return _Way(*said.places[0], said.message), pairs
    return _Way(said.places[0][0], "request", said.message), pairs


def _spoken(layout: DeviceLayout, way: _Way) -> str:
    name = layout.device.links[way.link].direction_name(way.direction)
    return f"the {name}" if name in DIRECTIONS else f"{way.message} {name}"


def _some(names: Collection[str]) -> str:
    return ", ".join(names) if len(names) <= _MOST else f"{len(names)} of them"


def _nested(pairs: list[str]) -> dict[str, object]:
    """`items.0.size=1` as nested mappings and lists."""
    root: dict[str, object] = {}
    for pair in pairs:
        name, equals, value = pair.partition("=")
        if not equals or not name:
            raise UsageError(f"{pair} is no NAME=VALUE")
        *path, last = name.split(".")
        holder = root
        for step in path:
            inner = holder.setdefault(step, {})
            if not isinstance(inner, dict):
                raise UsageError(f"{name}: {step} has a value of its own")
            holder = inner
        if last in holder:
            raise UsageError(f"{name} is given twice")
        holder[last] = value
    return {name: _lists_of(value) for name, value in root.items()}


def _lists_of(value: object) -> object:
    """Mappings whose keys are 0, 1, ... as lists."""
    if not isinstance(value, dict):
        return value
    inner = {key: _lists_of(held) for key, held in value.items()}
    if sorted(inner, key=_order) == [str(number) for number in range(len(inner))]:
        return [inner[str(number)] for number in range(len(inner))]
    return inner


def _order(key: str) -> tuple[int, str]:
    return len(key), key


def _by_print(layout: DeviceLayout, way: _Way, written: dict[str, object]) -> None:
    """Puts our names in the place of the manual's."""
    body = body_of(layout, way.link, way.direction, way.message, False)
    printed = {field.field.printed_name.lower(): field.name for field in body.fields if field.field.printed_name}
    for name in [name for name in written if body.named(name) is None and name.lower() in printed]:
        own = printed[name.lower()]
        if own in written:
            raise UsageError(f"{name} is {own}, which is given twice")
        written[own] = written.pop(name)


def _with_address(layout: DeviceLayout, message: str, written: dict[str, object]) -> None:
    """Puts the address of a register in the place of its name."""
    device = layout.device
    accesses = device.register_access(layout.messages[message].message)
    named = written.get(accesses.start) if accesses else None
    register = device.register(named) if isinstance(named, str) else None
    if accesses is None or register is None:
        return
    theirs, ours = device.space_name(register.space), device.space_name(accesses.space)
    if theirs != ours:
        raise UsageError(f"{register.name} lies in {theirs}, and {message} {accesses.operation}s {ours}")
    written[accesses.start] = register.address


def _with_words(layout: DeviceLayout, message: str, written: dict[str, object]) -> None:
    """Puts the words of registers in the place of quantities in their units, and of names."""
    access = layout.device.register_access(layout.messages[message].message)
    if access is None or access.operation != "write":
        return
    text, start = written.get(access.values), written.get(access.start)
    address = number_of(start) if isinstance(start, str) else start
    if not isinstance(text, str) or not isinstance(address, int):
        return
    words = register_words(layout, access, address, text)
    field = layout.messages[message].request.named(access.values)
    if words is None or field is None:
        return
    if not field.is_list and len(words) != 1:
        raise UsageError(f"{text} takes {len(words)} words, and {message} writes one")
    written[access.values] = words if field.is_list else words[0]


def _refuse_access(layout: DeviceLayout, way: _Way, values: Mapping[str, Raw]) -> None:
    """Refuses a request to write what can only be read, or to read what can only be written."""
    accesses = layout.device.register_access(layout.messages[way.message].message)
    if accesses is None or way.direction != "request":
        return
    held = values.get(accesses.values)
    carried = bytes(2 * (len(held) if isinstance(held, list) else 0 if held is None else 1))
    span = accessed(accesses, values, {}, 0, carried)
    why = forbidden(layout, span, accesses.operation) if span is not None else ""
    if why:
        raise UsageError(f"{why}: no frame is made of it")


def _count_of(layout: DeviceLayout, way: _Way, name: str, held: object) -> object:
    """A value as counts, where that needs more than its own field: the number of a named parameter, and what is a
    share of a power of two, of which hardly any value in the unit is a whole number. Says what it rounds.
    """
    body = body_of(layout, way.link, way.direction, way.message, False)
    field = body.named(name)
    value = field.value if field else None
    if value is None or not isinstance(held, str):
        return held
    if value.parameter is not None and value.parameter.part == "number":
        number = parameter_number(layout.device, value.parameter.set, held)
        return held if number is None else number
    if "/" not in value.scale_text:
        return held
    count = nearest(value, held)
    if count is None or count.is_whole:
        return held
    which = "" if count.text.replace(" ", "") == held.replace(" ", "") else f", which is {count.text}"
    print(f"fieldspec: {name}: {held} is {count.exact} counts; {count.raw} is sent{which}", file=sys.stderr)
    return count.raw


def _fields(layout: DeviceLayout, way: _Way) -> list[str]:
    """What can be given: the parts of the head that no other part decides, and the fields of the body."""
    shape = layout.links[way.link].frame(way.direction)
    head = [part.name for part in shape.head if part.role in ("unit_address", "plain") and not part.reserved]
    body = body_of(layout, way.link, way.direction, way.message, False)
    return [*head, *(field.name for field in body.fields if field.field.measures is None)]


def _print(layout: DeviceLayout, way: _Way, form: str, frame: bytes) -> None:
    characters = frame.decode("latin-1") if layout.links[way.link].link.encoding == "hex_ascii" else None
    if form == "json":
        import json

        data = {
            "device": layout.device.id,
            "version": layout.device.version,
            "link": way.link,
            "direction": way.direction,
            "direction_name": layout.device.links[way.link].direction_name(way.direction),
            "message": way.message,
            "frame": frame.hex().upper(),
            "characters": characters,
        }
        print(json.dumps(data, ensure_ascii=False, indent=1))
        return
    print(frame.hex(" ").upper())
    if form == "text" and characters is not None:
        print(visible_text(characters))
