"""Whether a value may take a number."""

from __future__ import annotations

from fieldspec.model.device import Device
from fieldspec.model.primitive import Kind
from fieldspec.model.value import Value


class Legal:
    """What the values of a device may be."""

    def __init__(self, device: Device) -> None:
        self._closed = {
            enum.name: frozenset(member.value for member in enum.members)
            for enum in device.enums.values()
            if not enum.open
        }

    def objection(self, value: Value, number: int, written: bool = False) -> str:
        """Why the value cannot be this number of counts, or an empty text. Sentinels may be anything.

        `written` says that the number is written, for which a value may have a range of its own.
        """
        if written:
            value = value.as_written()
        if value.type.kind is Kind.FLOAT and value.ranges is not None and value.sentinel(number) is None:
            return "" if number in value.ranges else f"lies outside of {value.ranges.text()}"
        if value.type.kind not in (Kind.INTEGER, Kind.BOOLEAN):
            return ""
        if not value.type.low <= number <= value.type.high:
            return f"{value.type.name} does not hold"
        if any(sentinel.value == number for sentinel in value.sentinels):
            return ""
        if value.ranges is not None and number not in value.ranges:
            return f"lies outside of {value.ranges.text()}"
        if value.enum in self._closed and number not in self._closed[value.enum]:
            return f"{value.enum} does not list"
        return ""
