"""A request that a simulated device refuses, and where its response says why."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.exception_mark import reason_field
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.language.model.value import Value


class Refusal(Exception):
    """A refused request. `reason` is a word of the key `refuse` of behaviours, `detail` is for the log."""

    def __init__(self, reason: str, detail: str = "") -> None:
        super().__init__(f"{reason}: {detail}" if detail else reason)
        self.reason, self.detail = reason, detail


def reason_place(layout: DeviceLayout, link: LinkLayout, exception: ExceptionResponse) -> tuple[str, Value]:
    """The name and the value of what says why: the part that marks the response, or a field of its record."""
    if exception.part:
        parts = (part for part in link.response.header if part.name == exception.part)
        return next((part.name, part.value) for part in parts if part.value is not None)
    field = reason_field(layout.records[exception.record])
    assert field is not None
    assert field.value is not None
    return field.name, field.value
