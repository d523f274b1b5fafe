"""Why `encode` takes no value for a part of a frame or a field that is there."""

from __future__ import annotations

from fieldspec.layout.frame import FrameLayout
from fieldspec.layout.record import RecordLayout

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
