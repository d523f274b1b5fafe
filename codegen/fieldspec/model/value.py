"""How a number, a text or some bytes lie on the wire, and what they mean."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal

from fieldspec.model.fact import Citation
from fieldspec.model.primitive import Primitive
from fieldspec.model.ranges import Ranges


@dataclass(frozen=True, slots=True)
class Sentinel:
    """A value that stands for something else than a quantity."""

    value: int
    name: str
    doc: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True)
class ParameterPart:
    """That a value is the number, the value, or all values, of a set of numbered parameters."""

    set: str
    part: str
    number: str


@dataclass(frozen=True, slots=True)
class Value:
    """A value on the wire: `size` in bytes; value in the unit = raw * scale + offset.

    `ranges`, `default` and `const` are raw counts. `enum` and `flags` are names, empty where there is none.
    """

    type: Primitive
    size: int
    characters: int | None
    byte_order: str
    scale: Decimal
    offset: Decimal
    unit: str
    ranges: Ranges | None
    default: int | str | None
    const: int | None
    enum: str
    flags: str
    parameter: ParameterPart | None
    sentinels: tuple[Sentinel, ...]

    @property
    def scaled(self) -> bool:
        """Whether the value in the unit is another number than the raw one."""
        return self.scale != 1 or self.offset != 0

    def in_unit(self, raw: int) -> Decimal:
        """A raw count in the unit, exactly."""
        return raw * self.scale + self.offset

    def from_unit(self, number: Decimal) -> int | None:
        """The raw count of a value in the unit, or None where it is no whole number of counts."""
        raw = (number - self.offset) / self.scale
        return int(raw) if raw == raw.to_integral_value() else None
