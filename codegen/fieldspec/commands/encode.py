"""`fieldspec encode`: the frame of a message."""

from __future__ import annotations

import argparse

from fieldspec.commands import specs
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.meaning import MeaningError, body_of, raw_of
from fieldspec.render.columns import one_line


def run(arguments: argparse.Namespace) -> int:
    """Prints the frame as hexadecimal bytes, with its characters where it is made of them."""
    from fieldspec.reference import CodecError, codec

    layout = specs.layout(arguments.specs, arguments.device)
    link = arguments.link or next(iter(layout.links), "")
    if link not in layout.links:
        raise unknown("link", link, layout.links)
    if arguments.message not in layout.messages:
        raise unknown("message", arguments.message, layout.messages)
    written = _written(arguments.values)
    fields = _fields(layout, link, arguments)
    for name in written:
        if name not in fields:
            raise unknown("field", name, fields)
    _with_address(layout, arguments.message, written)
    parts = layout.links[link].frame(arguments.direction).head
    body = body_of(layout, link, arguments.direction, arguments.message, False)
    try:
        values = raw_of(layout.device, parts, body, written)
        frame = codec(layout).links[link].encode(arguments.direction, arguments.message, values)
    except (MeaningError, CodecError) as error:
        raise UsageError(f"{error}; the {arguments.direction} has the fields {', '.join(fields)}") from None
    _print(layout, link, arguments, frame)
    return 0


def _written(pairs: list[str]) -> dict[str, object]:
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
    return {name: _listed(value) for name, value in root.items()}


def _listed(value: object) -> object:
    """Mappings whose keys are 0, 1, ... as lists."""
    if not isinstance(value, dict):
        return value
    inner = {key: _listed(held) for key, held in value.items()}
    if sorted(inner, key=_order) == [str(number) for number in range(len(inner))]:
        return [inner[str(number)] for number in range(len(inner))]
    return inner


def _order(key: str) -> tuple[int, str]:
    return len(key), key


def _with_address(layout: DeviceLayout, message: str, written: dict[str, object]) -> None:
    """Puts the address of a register in the place of its name."""
    accesses = layout.messages[message].message.accesses
    named = written.get(accesses.start) if accesses else None
    register = layout.device.register(named) if isinstance(named, str) else None
    if accesses is not None and register is not None:
        written[accesses.start] = register.address


def _fields(layout: DeviceLayout, link: str, arguments: argparse.Namespace) -> list[str]:
    """What can be given: the parts of the head that no other part decides, and the fields of the body."""
    shape = layout.links[link].frame(arguments.direction)
    head = [part.name for part in shape.head if part.role in ("station", "plain")]
    body = body_of(layout, link, arguments.direction, arguments.message, False)
    return [*head, *(field.name for field in body.fields if field.field.measures is None)]


def _print(layout: DeviceLayout, link: str, arguments: argparse.Namespace, frame: bytes) -> None:
    characters = frame.decode("latin-1") if layout.links[link].link.encoding == "hex_ascii" else None
    if arguments.format == "json":
        import json

        data = {
            "device": layout.device.id,
            "version": layout.device.version,
            "link": link,
            "direction": arguments.direction,
            "message": arguments.message,
            "frame": frame.hex().upper(),
            "characters": characters,
        }
        print(json.dumps(data, ensure_ascii=False, indent=1))
        return
    print(frame.hex(" ").upper())
    if arguments.format == "text" and characters is not None:
        print(one_line(characters))
