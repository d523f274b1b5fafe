"""Why a simulated device does not carry out a request that it has received."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.accepted import Condition, passes, range_conditions
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference.frames import FrameCodec
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.device import Device

if TYPE_CHECKING:
    from typing import Any

_CONDITIONS: ByIdentity[Device, ByIdentity[RecordLayout, list[tuple[str, tuple[Condition, ...]]]]] = ByIdentity(limit=8)
"""The conditions of the fields of records of the last devices."""

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
    """The name of the first field of a record whose value, or one of its bits, is beyond its range; empty for none."""
    of_device = _CONDITIONS.get_or_compute(device, lambda _: ByIdentity())
    for name, conditions in of_device.get_or_compute(record, lambda record: _conditions(device, record)):
        raw = values.get(name)
        if isinstance(raw, int) and not isinstance(raw, bool):
            for condition in conditions:
                if not passes(condition.test, raw):
                    return name
    return ""


def _conditions(device: Device, record: RecordLayout) -> list[tuple[str, tuple[Condition, ...]]]:
    """The fields of a record with the conditions of their ranges, but for fields without any."""
    fields = ((field.name, field.value) for field in record.fields)
    pairs = [(name, range_conditions(device, value)) for name, value in fields if value is not None]
    return [(name, conditions) for name, conditions in pairs if conditions]


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
