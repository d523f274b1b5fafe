"""Why a simulated device does not carry out a request that it has received."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.accepted import Condition, passes, range_conditions
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.frames import FrameCodec
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.device import Device
from fieldspec.language.model.value import Value

if TYPE_CHECKING:
    from typing import Any

_CONDITIONS: ByIdentity[Device, ByIdentity[Value, tuple[Condition, ...]]] = ByIdentity(limit=8)
"""The conditions of values of the last devices."""

DAMAGED = ("wrong_mark", "not_hex", "wrong_checksum")
_REASONS = {
    "unknown_code": "unknown_code",
    "incomplete": "count_invalid",
    "wrong_length": "count_invalid",
    "wrong_measure": "count_invalid",
}


def refusal_reason(frames: FrameCodec, frame: bytes, error: CodecError) -> str:
    """The reason for which a request that cannot be decoded is refused."""
    shape = frames.link.request
    coded = shape.role("code")
    parts = frames.original_parts(frame, "request")
    code = coded.read(parts[coded.offset : coded.offset + coded.size]) if coded is not None else None
    announced = frames.link.message_with_code(code) if code is not None else None
    selector = announced.request.selector if announced is not None else None
    if selector is not None and error.offset == shape.header_size + selector.offset:
        return "format_invalid"
    return _REASONS.get(error.reason, "value_invalid")


def first_out_of_range(device: Device, record: RecordLayout, values: Mapping[str, Any]) -> str:
    """The name of the first field of a record whose value is beyond its range; empty where none is."""
    judged = (_out_of_range(device, field, values) for field in record.fields)
    return next((name for name in judged if name), "")


def _out_of_range(device: Device, field: FieldLayout, values: Mapping[str, Any]) -> str:
    """The name of a field whose value, or one of its bits, is beyond its range; empty for all others."""
    value, raw = field.value, values.get(field.name)
    if value is None or not isinstance(raw, int) or isinstance(raw, bool):
        return ""
    of_device = _CONDITIONS.get_or_compute(device, lambda _: ByIdentity())
    conditions = of_device.get_or_compute(value, lambda value: range_conditions(device, value))
    return "" if all(passes(own.test, raw) for own in conditions) else field.name


def recognised_message(frames: FrameCodec, frame: bytes) -> str:
    """The only message whose request a frame without a code may be; empty where none or several may."""
    fitting = []
    for name in frames.link.carried("request"):
        try:
            frames.decode(frame, "request", name)
        except CodecError:
            continue
        fitting.append(name)
    return fitting[0] if len(fitting) == 1 else ""


def refusal_words(frames: FrameCodec, frame: bytes, message: str, error: CodecError) -> tuple[str, str]:
    """The reason why a request is refused, and what is wrong with it. `message` names it where frames have no code."""
    is_unnamed = frames.link.request.role("code") is None and not message
    text = "its bytes fit no message, or several" if is_unnamed else error.detail
    return refusal_reason(frames, frame, error), text
