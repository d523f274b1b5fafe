"""Proves that every example means what its bytes say, once for all versions that share it."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from typing import Any

from fieldspec.checks.layout_conditions import has_layout
from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.layout.device import DeviceLayout, device_layout
from fieldspec.layout.values import MeaningError, Raw, raw_values
from fieldspec.model.device import Device
from fieldspec.model.texts import Example
from fieldspec.reference.frames import Decoded, DeviceCodec
from fieldspec.reference.records import CodecError

Meaning = tuple[int, ...]


class FindingsCache:
    """What is found of the examples of a device at its versions, and with prints put back.

    What is built of the same rows is the same object, so that devices which give examples the same meaning are known by
    the objects that they hold.
    """

    def __init__(self) -> None:
        self._laid: dict[Meaning, tuple[DeviceLayout, DeviceCodec] | None] = {}
        self._known: dict[tuple[Meaning, int], list[Diagnostic]] = {}
        self._devices: list[Device] = []  # as long as they are there, no other objects have their identities

    def findings(self, device: Device, sound: bool = False) -> list[Diagnostic]:
        """The findings of a device's examples; none of one that cannot be laid out, as a `sound` one is known to be."""
        if not device.examples:
            return []  # nobody waits for the reference and its library
        meaning = _meaning(device)
        if meaning not in self._laid:
            self._devices.append(device)
            self._laid[meaning] = _layout_and_codec(device) if sound or has_layout(device) else None
        laid = self._laid[meaning]
        if laid is None:
            return []
        return [found for example in device.examples.values() for found in self._of(meaning, laid, device, example)]

    def _of(
        self, meaning: Meaning, laid: tuple[DeviceLayout, DeviceCodec], device: Device, example: Example
    ) -> list[Diagnostic]:
        key = meaning, id(example)
        if key not in self._known:
            self._devices.append(device)
            self._known[key] = [*example_proven(*laid, example)]
        return self._known[key]


def _layout_and_codec(device: Device) -> tuple[DeviceLayout, DeviceCodec]:
    from fieldspec.reference.frames import codec

    layout = device_layout(device)
    return layout, codec(layout)


def _meaning(device: Device) -> Meaning:
    """The identities of all objects that decide what the values in a frame are; what they are for does not count."""
    held = (device.links, device.messages, device.records, device.enums, device.flags)
    return tuple(id(one) for named in held for one in named.values())


CHECKS = {"wrong_check": "check_code_correct", "wrong_length": "length_byte_correct"}


def example_proven(layout: DeviceLayout, reference: DeviceCodec, example: Example) -> Iterator[Diagnostic]:
    """Findings of one example: characters against bytes, bytes against meaning, meaning against bytes."""
    yield from _characters(layout, example)
    if example.refused:
        yield from _refused(reference, example)
        return
    frames = reference.links[example.link]
    try:
        decoded = frames.decode(example.frame, example.direction, example.message)
    except CodecError as error:
        code = CHECKS.get(error.reason, "meaning_matches_bytes")
        yield Diagnostic(code, f"the frame is refused: {error}", example.place["frame"], help=_mend(code))
        return
    if decoded.message is not None and decoded.message.name != example.message:
        text = f"the frame is a {decoded.message.name}, not a {example.message}"
        yield Diagnostic("meaning_matches_bytes", text, example.place["message"], help="name the right message")
        return
    if decoded.error != example.exception_response:
        kind = "an error reply" if decoded.error else "no error reply"
        text = f"the frame is {kind}"
        yield Diagnostic("meaning_matches_bytes", text, example.place["frame"], help="give or remove `error: true`")
        return
    try:
        written = raw_values(layout, example)
    except MeaningError as error:
        yield Diagnostic("meaning_matches_bytes", str(error), example.place["values"], help="see the message's fields")
        return
    yield from _compare_meaning(layout, example, decoded, written)
    yield from _bytes(reference, example, decoded, written)


def _mend(code: str) -> str:
    if code == "meaning_matches_bytes":
        return "compare the bytes with the message's fields"
    return "where the manual prints these bytes, give the right ones here and the printed ones in an erratum"


def _characters(layout: DeviceLayout, example: Example) -> Iterator[Diagnostic]:
    if example.characters and example.characters.encode("latin-1", "replace") != example.frame:
        label = Label(example.place["frame"], f"these bytes read {_hex_text(example.frame)}")
        text = f"the characters are {_hex_text(example.characters.encode('latin-1', 'replace'))}"
        help = "put the row right that is misprinted, and write an erratum"
        yield Diagnostic("characters_match_bytes", text, example.place["characters"], (label,), help)


def _hex_text(data: bytes) -> str:
    return data.decode("latin-1").replace("\r", "\\r").replace("\n", "\\n")


def _refused(reference: DeviceCodec, example: Example) -> Iterator[Diagnostic]:
    try:
        reference.links[example.link].decode(example.frame, example.direction, example.message)
    except CodecError as error:
        if error.reason != example.refused:
            text = f"the frame is refused, but as {error}"
            code = CHECKS.get(error.reason, "meaning_matches_bytes")
            yield Diagnostic(code, text, example.place["refused"], help=_mend(code))
        return
    text = "the frame is not refused"
    yield Diagnostic("meaning_matches_bytes", text, example.place["refused"], help="give its meaning instead")


def _compare_meaning(
    layout: DeviceLayout, example: Example, decoded: Decoded, written: dict[str, Raw]
) -> Iterator[Diagnostic]:
    """The values in the spec against those of the bytes. What a field measures need not be written."""
    head = layout.links[example.link].frame(example.direction).head
    told = {part.name for part in head if part.role == "code" or (part.value and part.value.const is not None)}
    actual = {**decoded.head, **decoded.values}
    for name, value in actual.items():
        if name in written:
            if not _same(written[name], value):
                text = f"{name} is {_text(value)} in the bytes and {_text(written[name])} in the values"
                span = example.place["values"]
                label = Label(example.place["frame"], "these bytes")
                yield Diagnostic("meaning_matches_bytes", text, span, (label,), "put one of them right")
        elif name not in told and not _implied(decoded, name):
            text = f"the values do not say what {name} is"
            help = f"add `{name}: {_text(value)}` if the manual means that"
            yield Diagnostic("meaning_matches_bytes", text, example.place["values"], help=help)


def _implied(decoded: Decoded, name: str) -> bool:
    """Whether a value need not be written: it measures another one, is constant, or is reserved."""
    field = decoded.body.named(name) if decoded.body else None
    if field is None:
        return False
    constant = field.value is not None and field.value.const is not None
    return field.field.measures is not None or field.field.reserved or constant


def _same(written: Any, actual: Any) -> bool:
    """Whether what is written is in what is there; reserved fields of records need not be written."""
    if isinstance(written, dict) and isinstance(actual, dict):
        return all(name in actual and _same(value, actual[name]) for name, value in written.items())
    if isinstance(written, list) and isinstance(actual, list):
        return len(written) == len(actual) and all(map(_same, written, actual))
    if isinstance(written, float) and isinstance(actual, float):
        return _rounded(written) == _rounded(actual)
    return bool(written == actual)


def _rounded(number: float) -> bytes:
    """A number as the bytes of the nearest one of 32 bits: what is written in decimals is rarely exact."""
    try:
        return struct.pack("<f", number)
    except OverflowError:
        return struct.pack("<f", math.copysign(math.inf, number))


def _bytes(reference: DeviceCodec, example: Example, decoded: Decoded, written: dict[str, Raw]) -> Iterator[Diagnostic]:
    """The bytes of the written values against those in the spec."""
    link = reference.links[example.link]
    shape = link.link.frame(example.direction)
    part = shape.role("code")
    code = decoded.head[part.name] if part is not None else None
    given = {name: value for name, value in written.items() if part is None or name != part.name}
    measured = [] if decoded.body is None else [f.name for f in decoded.body.fields if f.field.measures]
    try:
        data = link.encode(
            example.direction,
            example.message,
            {name: value for name, value in given.items() if name not in measured},
            error=example.exception_response,
            code=code,
        )
    except CodecError as error:
        text = f"the values cannot be encoded: {error}"
        yield Diagnostic("meaning_matches_bytes", text, example.place["values"], help="compare them with the fields")
        return
    if data != example.frame:
        text = f"the values encode to {data.hex(' ').upper()}"
        label = Label(example.place["frame"], "these bytes")
        span = example.place["values"]
        yield Diagnostic("meaning_matches_bytes", text, span, (label,), "put one of them right")


def _text(value: Any) -> str:
    return value.hex(" ") if isinstance(value, bytes) else str(value)
