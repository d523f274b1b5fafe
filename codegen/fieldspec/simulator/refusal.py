"""A request that a simulated device refuses, and where its response says why."""

from __future__ import annotations

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import LinkLayout
from fieldspec.model.link import ExceptionResponse
from fieldspec.model.value import Value


class Refusal(Exception):
    """A refused request. `reason` is a word of the key `refuse` of behaviours, `detail` is for the log."""

    def __init__(self, reason: str, detail: str = "") -> None:
        super().__init__(f"{reason}: {detail}" if detail else reason)
        self.reason, self.detail = reason, detail


def reason_place(layout: DeviceLayout, link: LinkLayout, exception: ExceptionResponse) -> tuple[str, Value]:
    """The name and the value of what says why: the part that marks the response, or the free field of its record."""
    if exception.part:
        parts = (part for part in link.response.header if part.name == exception.part)
        return next((part.name, part.value) for part in parts if part.value is not None)
    fields = layout.records[exception.record].fields
    return next((field.name, field.value) for field in fields if field.value is not None and field.value.const is None)
