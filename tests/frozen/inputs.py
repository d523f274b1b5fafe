"""The facts of a layout, and what codecs are asked about each: the same for every Python, version and order of facts.

What is drawn also depends on `random_devices/inputs.py`, and valid bytes are those of the reference. The digest of the
inputs themselves tells such a change from one of an answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, DeviceCodec, codec
from fieldspec.codec.reference.records import encoded
from frozen.dice import Dice
from frozen.edges import edge_data, edge_numbers, places
from random_devices.inputs import (
    header_values,
    number_or_text,
    record_bytes,
    record_values,
    sealed,
    spoiled,
    stored_fields,
)
from random_devices.queries import Query, message_queries, queried_messages, shapes
from random_devices.script_judge import accessed

VALUE_DRAWS, RECORD_DRAWS, FRAME_DRAWS, ACCESS_DRAWS = 330, 690, 146, 17
"""How often something is drawn for a fact, besides its edges. A frame gives four or five inputs each time."""
_EDGES = 160
"""The edges of a record that are tried: so many at most, drawn from all."""
_DAMAGES = 48
"""Single bytes that are damaged in a valid frame."""
_WRONG: tuple[Any, ...] = ("1", 1.5, [1], {"a": 1})
"""Values of types that most fields do not take; a field that does has one more valid value."""
_ODD: tuple[Any, ...] = (None, True, b"\x01")
"""Values that languages treat in ways of their own: what is a number to one of them is none to another."""


@dataclass(frozen=True)
class Fact:
    """What has a digest: its path, and what queries are about."""

    path: str
    kind: str
    names: tuple[str, ...]
    shape: Any = field(default=None, repr=False, compare=False)


@dataclass(frozen=True)
class Input:
    """A question to all codecs.

    `aspect` is decode or encode; encode what has a wrong or odd type, or is absent; or access: explain a frame that
    accesses registers, with the request before it. `number` counts the inputs of a fact.
    """

    aspect: str
    query: Query
    request: bytes = b""
    number: int = 0

    @property
    def text(self) -> str:
        """The question as a text."""
        query = self.query
        if query.values is None:
            message = f" as {query.path[2]}" if query.kind == "frame" and query.path[2] else ""
            request = f" after {self.request.hex()}" if self.request else ""
            return f"{self.aspect} {query.data.hex() or '-'}{message}{request}"
        marks = f" error={query.error:d} code={query.code}" if query.kind == "frame" else ""
        return f"{self.aspect} {query.values!r}{marks}"


def facts(layout: DeviceLayout) -> Iterator[Fact]:
    """All facts of a layout that codecs decode or encode."""
    for link in layout.links.values():
        for direction in ("request", "response"):
            for message in queried_messages(link, direction):
                names = (link.name, direction, message)
                yield Fact("/".join(("frames", *names)), "frame", names)
    for name, record in layout.records.items():
        yield Fact(f"records/{name}", "record", (name,), record)
    for kind, path, shape in shapes(layout):
        folder = "registers" if kind == "register" else "parameters"
        yield Fact("/".join((folder, *path)), kind, path, shape)
    for link in layout.links.values():
        for message in link.messages.values():
            access = layout.device.register_access(message.message) or layout.device.bit_access(message.message)
            if access is not None and link.request.parts:
                names = (link.name, message.name)
                yield Fact("/".join(("accesses", *names)), "access", names, access)


def inputs(layout: DeviceLayout, fact: Fact) -> list[Input]:
    """The inputs of a fact. Those of equal facts in several versions of a device are the same."""
    dice = Dice(f"{layout.device.id}/{fact.path}")
    draw = {"frame": _frame_inputs, "record": _record_inputs, "access": _access_inputs}.get(fact.kind, _value_inputs)
    return [replace(item, number=number) for number, item in enumerate(draw(layout, fact, dice))]


def _value_inputs(layout: DeviceLayout, fact: Fact, dice: Dice) -> Iterator[Input]:
    value, order, swapped, _, size = fact.shape
    query = Query(fact.kind, fact.names, shape=fact.shape)
    for data in edge_data(layout.device, value, order, swapped):
        yield Input("decode", replace(query, data=data.ljust(size, b"\0")))
    for length in {0, 1, size - 1, size + 1, 2 * size} - {size}:
        yield Input("decode", replace(query, data=dice.randbytes(length)))
    for number in range(VALUE_DRAWS):
        data = dice.randbytes(size)
        if number % 3 == 0:
            data = bytes(byte & dice.choice((0x7F, 0x3F, 0x0F, 0x01)) for byte in data)
        yield Input("decode", replace(query, data=data))
    if value.const is None:
        drawn = [number_or_text(layout, value, dice) for _ in range(VALUE_DRAWS // 3)]
        for number in (*edge_numbers(layout.device, value), *drawn):
            yield Input("encode", replace(query, values={fact.names[-1]: number}))
        for aspect, wrong in _types():
            yield Input(aspect, replace(query, values={fact.names[-1]: wrong}))


def _record_inputs(layout: DeviceLayout, fact: Fact, dice: Dice) -> Iterator[Input]:
    record: RecordLayout = fact.shape
    query = Query("record", fact.names, shape=record)
    valid, right = b"", {}
    for _ in range(RECORD_DRAWS):
        yield Input("decode", replace(query, data=record_bytes(record, dice)))
        values = record_values(layout, record, dice)
        yield Input("encode", replace(query, values=values))
        try:
            valid, right = encoded(record, values, layout.device), values
        except CodecError:
            continue
        yield Input("decode", replace(query, data=valid))
        yield Input("decode", replace(query, data=spoiled(valid, dice)))
    for data in (*_with_edges(layout, record, valid, dice), *_damaged(valid, dice)):
        yield Input("decode", replace(query, data=data))
    for values in _with_edge_values(layout, record, dice):
        yield Input("encode", replace(query, values=values))
    for aspect, values in _wrong_values(right):
        yield Input(aspect, replace(query, values=values))


def _frame_inputs(layout: DeviceLayout, fact: Fact, dice: Dice) -> Iterator[Input]:
    link, direction, message = fact.names
    reference: DeviceCodec = codec(layout)
    frames: list[Query] = []
    for _ in range(FRAME_DRAWS):
        for query in message_queries(layout, reference, link, direction, message, dice):
            yield Input("decode" if query.values is None else "encode", query)
            frames += [query] * (query.values is None)
    if message not in layout.links[link].carried(direction):
        return
    record, shape = layout.messages[message].data(direction), layout.links[link].frame(direction)
    asked = "" if shape.role("code") is not None and not layout.links[link].is_guessed(direction, message) else message
    whole = Query("frame", (link, direction, asked))
    code = layout.messages[message].message.code_of(direction) if shape.role("code") is not None else None
    content = Query("frame", fact.names, values={}, code=code, shape=record)
    frame, valid = b"", b""
    for _ in range(9):
        head, values = header_values(layout, link, shape, dice), record_values(layout, record, dice)
        try:
            frame = reference.links[link].encode(direction, message, {**head, **values}, code=code)
            valid = encoded(record, values, layout.device)
        except CodecError:
            continue
        break
    parts = reference.links[link].original_parts(frame, direction) if frame else b""
    behind = len(parts) - shape.trailer_size
    for body in _with_edges(layout, record, valid, dice) if frame else ():
        data = sealed(layout, link, shape, parts[: shape.header_size] + body + parts[behind:], dice)
        yield Input("decode", replace(whole, data=data))
    for data in _damaged(frame, dice):
        yield Input("decode", replace(whole, data=data))
    for changed in _with_edge_values(layout, record, dice):
        yield Input("encode", replace(content, values={**header_values(layout, link, shape, dice), **changed}))
    for part in shape.header:
        if part.is_argument and part.value is not None:
            for number in edge_numbers(layout.device, part.value):
                yield Input("encode", replace(content, values={**head, **values, part.name: number}))
    for aspect, wrong in _wrong_values(values):
        yield Input(aspect, replace(content, values={**head, **wrong}))


def _access_inputs(layout: DeviceLayout, fact: Fact, dice: Dice) -> Iterator[Input]:
    """Requests that access registers, and their responses, whole and damaged."""
    link = layout.links[fact.names[0]]
    asks, answers = (Query("access", (link.name, direction, "")) for direction in ("request", "response"))
    drawn = accessed(layout, link, link.messages[fact.names[1]], fact.shape, dice)
    for request, response in islice(drawn, ACCESS_DRAWS):
        yield Input("access", replace(asks, data=request))
        yield Input("access", replace(asks, data=spoiled(request, dice)))
        if response:
            yield Input("access", replace(answers, data=response), request)
            yield Input("access", replace(answers, data=spoiled(response, dice)), request)


def _with_edges(layout: DeviceLayout, record: RecordLayout, valid: bytes, dice: Dice) -> list[bytes]:
    """Valid data with one value at one of its edges."""
    changed = []
    for offset, value, order, swapped in places(record):
        for data in edge_data(layout.device, value, order, swapped):
            if offset + len(data) <= len(valid):
                changed += [valid[:offset] + data + valid[offset + len(data) :]]
    return dice.sample(changed, min(_EDGES, len(changed)))


def _damaged(valid: bytes, dice: Dice) -> Iterator[bytes]:
    """Valid bytes with one damage each: another length, or another byte."""
    yield from (b"", valid[:1], valid[:-1], valid[1:], valid + b"\0", valid + dice.randbytes(3), valid + valid)
    for offset in (
        range(len(valid)) if len(valid) <= _DAMAGES else sorted({dice.randrange(len(valid)) for _ in range(_DAMAGES)})
    ):
        changed = valid[offset] ^ dice.choice((0x01, 0x80, 0xFF, 0x10, 0x20))
        yield valid[:offset] + bytes((changed,)) + valid[offset + 1 :]


def _with_edge_values(layout: DeviceLayout, record: RecordLayout, dice: Dice) -> list[dict[str, Any]]:
    """Values of which one is at an edge, where this is a value of the record itself."""
    changed = []
    for chosen in {id(chosen): chosen for chosen in (record, *record.chosen.values())}.values():
        for own in stored_fields(record, chosen):
            if own.value is not None and not own.is_list:
                changed += [(own.name, number) for number in edge_numbers(layout.device, own.value)]
    drawn = dice.sample(changed, min(_EDGES, len(changed)))
    return [{**record_values(layout, record, dice), name: number} for name, number in drawn]


def _types() -> Iterator[tuple[str, Any]]:
    yield from (("wrong", value) for value in _WRONG)
    yield from (("odd", value) for value in _ODD)


def _wrong_values(values: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Values of which one is missing, unknown or of a wrong type, and none at all; each with its aspect."""
    yield "absent", {}
    yield "absent", {**values, "no_such_field": 1}
    for name in values:
        yield "absent", {other: value for other, value in values.items() if other != name}
        for aspect, wrong in _types():
            yield aspect, {**values, name: wrong}
