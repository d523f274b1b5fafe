"""`fieldspec encode`: the frame of a message."""

from __future__ import annotations

import argparse

from fieldspec.commands import specs
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.meaning import MeaningError, body_of, raw_of


def run(arguments: argparse.Namespace) -> int:
    """Prints the frame as hexadecimal bytes, with its characters where it is made of them."""
    from fieldspec.reference import CodecError, codec

    layout = specs.layout(arguments.specs, arguments.device)
    link = _link(layout, arguments.link)
    if arguments.message not in layout.messages:
        raise unknown("message", arguments.message, layout.messages)
    written = _written(arguments.values)
    parts = layout.links[link].frame(arguments.direction).head
    body = body_of(layout, link, arguments.direction, arguments.message, False)
    try:
        values = raw_of(layout.device, parts, body.fields, written)
        frame = codec(layout).links[link].encode(arguments.direction, arguments.message, values)
    except (MeaningError, CodecError) as error:
        raise UsageError(f"{error}; the message has {_fields(layout, link, arguments)}") from None
    _print(frame, layout.links[link].link.encoding, arguments.format)
    return 0


def _link(layout: DeviceLayout, given: str | None) -> str:
    if given is None:
        return next(iter(layout.links))
    if given not in layout.links:
        raise unknown("link", given, layout.links)
    return given


def _written(pairs: list[str]) -> dict[str, object]:
    """`points.0.position=1` as nested mappings and lists."""
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
        holder[last] = value
    return {name: _listed(value) for name, value in root.items()}


def _listed(value: object) -> object:
    """Mappings whose keys are 0, 1, ... as lists."""
    if not isinstance(value, dict):
        return value
    inner = {key: _listed(held) for key, held in value.items()}
    if all(key.isdigit() for key in inner):
        return [inner[key] for key in sorted(inner, key=int)]
    return inner


def _fields(layout: DeviceLayout, link: str, arguments: argparse.Namespace) -> str:
    shape = layout.links[link].frame(arguments.direction)
    head = [part.name for part in shape.head if part.role in ("station", "plain")]
    body = body_of(layout, link, arguments.direction, arguments.message, False)
    return ", ".join([*head, *(field.name for field in body.fields if field.field.measures is None)])


def _print(frame: bytes, encoding: str, form: str) -> None:
    text = frame.hex(" ").upper()
    if form == "json":
        import json

        print(json.dumps({"frame": frame.hex().upper()}))
        return
    print(text)
    if form == "text" and encoding == "hex_ascii":
        print(frame.decode("ascii").replace("\r", "\\r").replace("\n", "\\n"))
