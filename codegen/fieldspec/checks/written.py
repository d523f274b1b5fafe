"""The numbers that examples are written with, as far as they are plain counts or quantities in the unit."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal

from fieldspec.model.device import Device
from fieldspec.model.example import Example
from fieldspec.model.record import Field
from fieldspec.model.value import Value

_COUNT = re.compile(r"[-+]?(0x[0-9A-Fa-f]{1,16}|[0-9]{1,20})")
_QUANTITY = re.compile(r"([-+]?[0-9]{1,20}(?:\.[0-9]{1,20})?) ?([^0-9 ].*)")


def body(device: Device, example: Example) -> tuple[Field, ...]:
    """The fields of an example's body; none where a reference of the example dangles."""
    link = device.links.get(example.link)
    if example.error:
        record = device.records.get(link.error.record) if link is not None and link.error is not None else None
        return record.fields if record is not None else ()
    message = device.messages.get(example.message)
    if message is None:
        return ()
    return message.request.fields if example.direction == "request" else message.response.fields


def numbers(device: Device, example: Example) -> Iterator[tuple[str, Value, int]]:
    """The path, the kind of value and the count of every number that an example is written with."""
    link = device.links.get(example.link)
    heads = {part.name: part.value for part in link.parts(example.direction)} if link is not None else {}
    for name, held in example.values.items():
        value = heads.get(name)
        if value is not None:
            count = in_counts(value, held)
            if count is not None:
                yield name, value, count
    yield from _of_fields(device, body(device, example), "", example.values)


def _of_fields(
    device: Device, fields: tuple[Field, ...], path: str, written: Mapping[str, object]
) -> Iterator[tuple[str, Value, int]]:
    for field in fields:
        held = written.get(field.name)
        for item in held if isinstance(held, list) else [held]:
            record = device.records.get(field.record)
            if record is not None and isinstance(item, dict):
                yield from _of_fields(device, record.fields, f"{path}{field.name}.", item)
            elif field.value is not None:
                count = in_counts(field.value, item)
                if count is not None:
                    yield f"{path}{field.name}", field.value, count


def in_counts(value: Value, held: object) -> int | None:
    """A written value in counts, or None where it is a name, a text or a list, or cannot be understood."""
    if isinstance(held, bool):
        return None
    if isinstance(held, int):
        return held
    if isinstance(held, str) and _COUNT.fullmatch(held):
        return int(held, 16) if "x" in held else int(held)
    match = _QUANTITY.fullmatch(held) if isinstance(held, str) else None
    if match is None or match[2] != value.unit:
        return None
    return value.from_unit(Decimal(match[1]))
