"""Proves that every example means what its bytes say, once for all versions that share it."""

from __future__ import annotations

import math
import struct
from collections import deque
from collections.abc import Iterator, Sequence
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.layout.observation import is_same_device, observed_layout, read_of_layout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.layout.values import MeaningError, Raw, raw_values
from fieldspec.codec.reference.frames import Decoded, DeviceCodec, FrameCodec
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.caches import ByIdentity, ObjectsKey
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.checks.layout_conditions import has_layout
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Example


@dataclass(frozen=True, slots=True)
class _Proofs:
    """The codec of a device that knows what has been read of it, and the examples that it has proven sound."""

    layout: DeviceLayout
    codec: DeviceCodec
    sound: ByIdentity[Example, None] = field(default_factory=ByIdentity)

    def findings(self, example: Example) -> list[Diagnostic]:
        """The findings of an example."""
        if example in self.sound:
            return []
        findings = [*example_proven(self.layout, self.codec, example)]
        if not findings:
            self.sound[example] = None
        return findings


_LAST: deque[_Proofs] = deque(maxlen=16)


def _proofs(device: Device) -> _Proofs:
    """The proofs of a device: earlier ones if all of its examples are sound there, and would read the same of it."""
    for earlier in reversed(_LAST):
        is_sound = all(example in earlier.sound for example in device.examples.values())
        if is_sound and is_same_device(read_of_layout(earlier.layout), device):
            return earlier
    from fieldspec.codec.reference.frames import codec

    layout = observed_layout(device_layout(device))
    proofs = _Proofs(layout, codec(layout))
    _LAST.append(proofs)
    return proofs


class FindingsCache:
    """Caches the findings of a device's examples, over its versions and with prints put back.

    Versions share the objects that do not differ. So two devices with the same objects give an example the same
    meaning.
    """

    def __init__(self) -> None:
        self._proofs: dict[ObjectsKey, _Proofs | None] = {}

    def findings(self, device: Device, sound: bool = False) -> list[Diagnostic]:
        """The findings of a device's examples; none where it has no layout. A `sound` device is known to have one."""
        if not device.examples:
            return []  # nobody waits for the reference and its library
        meaning = _meaning(device)
        if meaning not in self._proofs:
            self._proofs[meaning] = _proofs(device) if sound or has_layout(device) else None
        proofs = self._proofs[meaning]
        if proofs is None:
            return []
        proven = [(example, proofs.findings(example)) for example in device.examples.values()]
        common = _commonly_wrong(proven)
        return [
            replace(finding, help=_COMMON)
            if finding.code == "checksum_correct" and _frames_of(example) in common
            else finding
            for example, own in proven
            for finding in own
        ]


_COMMON = (
    "the checksums of all examples in this direction of the link are wrong: compare `covers`, `algorithm` or "
    "`checksum`, `digits` and `byte_order` of the part with the manual first"
)


def _frames_of(example: Example) -> tuple[str, str]:
    return example.link, example.direction


def _commonly_wrong(proven: Sequence[tuple[Example, Sequence[Diagnostic]]]) -> set[tuple[str, str]]:
    """The links and directions with several examples, each of which has a wrong checksum."""
    verdicts: dict[tuple[str, str], list[bool]] = {}
    for example, own in proven:
        if not example.refused:
            wrong = any(finding.code == "checksum_correct" for finding in own)
            verdicts.setdefault(_frames_of(example), []).append(wrong)
    return {frames for frames, own in verdicts.items() if len(own) > 1 and all(own)}


def _meaning(device: Device) -> ObjectsKey:
    """All objects that decide what the values in a frame are; what the values are for does not count."""
    sections = (device.links, device.messages, device.records, device.enums, device.flags)
    return ObjectsKey(content for section in sections for content in section.values())


CHECKS = {"wrong_checksum": "checksum_correct", "wrong_length": "length_byte_correct"}


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
        help = _length_help(frames, example, error) if error.reason == "wrong_length" else _mend(code)
        yield Diagnostic(code, f"the frame is invalid: {error}", example.place["frame"], help=help)
        return
    if decoded.message is not None and decoded.message.name != example.message:
        text = f"the frame is a {decoded.message.name}, not a {example.message}"
        yield Diagnostic("meaning_matches_bytes", text, example.place["message"], help="name the right message")
        return
    if decoded.error != example.exception_response:
        kind = "an exception response" if decoded.error else "not an exception response"
        text = f"the frame is {kind}"
        help = "add or remove `exception_response: true`"
        yield Diagnostic("meaning_matches_bytes", text, example.place["frame"], help=help)
        return
    try:
        expected = raw_values(layout, example)
    except MeaningError as error:
        yield Diagnostic("meaning_matches_bytes", str(error), example.place["values"], help="see the message's fields")
        return
    yield from _compare_meaning(example, decoded, expected)
    missing = {name: value for name, value in _stated(layout, decoded).items() if name not in expected}
    if missing:
        text = f"the values do not contain {', '.join(missing)}"
        help = f"add `{spec_text(missing)[1:-1]}` if the manual means that"
        yield Diagnostic("meaning_matches_bytes", text, example.place["values"], help=help)
    else:
        yield from _bytes(reference, example, decoded, expected)


def _mend(code: str) -> str:
    if code == "meaning_matches_bytes":
        return "compare the bytes with the message's fields"
    return "if the manual prints these bytes, state the right ones here and the printed ones in an erratum"


def _length_help(frames: FrameCodec, example: Example, error: CodecError) -> str:
    """What to do about a wrong length: a right checksum proves the bytes, so that the spec describes them wrongly."""
    lengths = frames.link.frame(example.direction).lengths
    length = next((part for part in lengths if part.offset == error.offset), None)
    if not frames.has_right_checksum(example.frame, example.direction):
        fix = "state under `measures` what the length counts; " if length is not None else ""
        return fix + _mend("length_byte_correct")
    if length is None:
        return "the checksum is correct, so the bytes are too: compare them with the message's fields"
    return (
        f"the checksum is correct, so the bytes are too: state under `measures` what {length.name} counts; if no"
        f" `measures` says it, remove the role `length`, so that users supply {length.name}"
    )


def _characters(layout: DeviceLayout, example: Example) -> Iterator[Diagnostic]:
    if example.characters and example.characters.encode("latin-1", "replace") != example.frame:
        label = Label(example.place["frame"], f"these bytes read {_hex_text(example.frame)}")
        text = f"the characters are {_hex_text(example.characters.encode('latin-1', 'replace'))}"
        help = "correct the misprinted row, and write an erratum"
        yield Diagnostic("characters_match_bytes", text, example.place["characters"], (label,), help)


def _hex_text(data: bytes) -> str:
    return data.decode("latin-1").replace("\r", "\\r").replace("\n", "\\n")


def _refused(reference: DeviceCodec, example: Example) -> Iterator[Diagnostic]:
    try:
        reference.links[example.link].decode(example.frame, example.direction, example.message)
    except CodecError as error:
        if error.reason != example.refused:
            text = f"the frame is invalid, but for another reason: {error}"
            code = CHECKS.get(error.reason, "meaning_matches_bytes")
            yield Diagnostic(code, text, example.place["refused"], help=_mend(code))
        return
    text = "the frame is valid"
    yield Diagnostic("meaning_matches_bytes", text, example.place["refused"], help="state its meaning instead")


def _compare_meaning(example: Example, decoded: Decoded, expected: dict[str, Raw]) -> Iterator[Diagnostic]:
    """The values in the spec against the values of the bytes."""
    for name, value in {**decoded.head, **decoded.values}.items():
        if name in expected and not _is_same_value(expected[name], value):
            path, want, decoded_value = _difference(name, expected[name], value)
            text = f"{path} is {spec_text(decoded_value)} in the bytes, but {spec_text(want)} in the values"
            span = example.place["values"]
            label = Label(example.place["frame"], "these bytes")
            yield Diagnostic("meaning_matches_bytes", text, span, (label,), "correct one of them")


def stated_values(layout: DeviceLayout, decoded: Decoded) -> str:
    """The values of a frame as an example states them, without those that follow from others."""
    return spec_text(_stated(layout, decoded))


def _stated(layout: DeviceLayout, decoded: Decoded) -> dict[str, Raw]:
    """The values that an example states: those that do not follow from others."""
    values = {**decoded.head, **decoded.values}
    return {name: value for name, value in values.items() if not _implied(layout, decoded, name)}


def _implied(layout: DeviceLayout, decoded: Decoded, name: str) -> bool:
    """Whether a value may be left out: it is a code, measures another one, is constant, or is reserved."""
    head = layout.links[decoded.link].frame(decoded.direction).header
    if any(
        part.name == name and (part.role == "code" or (part.value and part.value.const is not None)) for part in head
    ):
        return True
    field = decoded.body.named(name) if decoded.body else None
    if field is None:
        return False
    constant = field.value is not None and field.value.const is not None
    return field.field.measures is not None or field.field.reserved or constant


def _is_same_value(expected: Any, actual: Any) -> bool:
    """Whether the bytes hold the expected value; reserved fields of records may be left out of it."""
    if isinstance(expected, dict) and isinstance(actual, dict):
        return all(name in actual and _is_same_value(value, actual[name]) for name, value in expected.items())
    if isinstance(expected, list) and isinstance(actual, list):
        return len(expected) == len(actual) and all(map(_is_same_value, expected, actual))
    if isinstance(expected, float) and isinstance(actual, float):
        return _rounded(expected) == _rounded(actual)
    return bool(expected == actual)


def _difference(path: str, expected: Any, actual: Any) -> tuple[str, Any, Any]:
    """The innermost value that differs, by its path, as it is expected and as it is."""
    pairs: list[tuple[str, Any, Any]] = []
    if isinstance(expected, dict) and isinstance(actual, dict) and expected.keys() <= actual.keys():
        pairs = [(f"{path}.{name}", value, actual[name]) for name, value in expected.items()]
    elif isinstance(expected, list) and isinstance(actual, list) and len(expected) == len(actual):
        pairs = [(f"{path}[{index}]", *pair) for index, pair in enumerate(zip(expected, actual, strict=True))]
    inner = next((pair for pair in pairs if not _is_same_value(pair[1], pair[2])), None)
    return (path, expected, actual) if inner is None else _difference(*inner)


def _rounded(number: float) -> bytes:
    """A number as the bytes of the nearest `f32`: decimals are rarely exact in binary."""
    try:
        return struct.pack("<f", number)
    except OverflowError:
        return struct.pack("<f", math.copysign(math.inf, number))


def _bytes(
    reference: DeviceCodec, example: Example, decoded: Decoded, expected: dict[str, Raw]
) -> Iterator[Diagnostic]:
    """The bytes that the expected values encode to, against those in the spec."""
    link = reference.links[example.link]
    shape = link.link.frame(example.direction)
    part = shape.role("code")
    code = decoded.head[part.name] if part is not None else None
    arguments = {name: value for name, value in expected.items() if part is None or name != part.name}
    measured = [] if decoded.body is None else [f.name for f in decoded.body.fields if f.field.measures]
    try:
        data = link.encode(
            example.direction,
            example.message,
            {name: value for name, value in arguments.items() if name not in measured},
            error=example.exception_response,
            code=code,
        )
    except CodecError as error:
        text = f"the values cannot be encoded: {error}"
        yield Diagnostic("meaning_matches_bytes", text, example.place["values"], help="compare them with the fields")
        return
    if data != link.link.frame(example.direction).as_sent(example.frame):
        text = f"the values encode to {data.hex(' ').upper()}"
        label = Label(example.place["frame"], "these bytes")
        span = example.place["values"]
        yield Diagnostic("meaning_matches_bytes", text, span, (label,), "correct one of them")
