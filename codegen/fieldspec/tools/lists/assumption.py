"""The assumptions about a list: with the evidence, and the option that decides."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Assumption:
    """A reading that was taken. `option` decides otherwise; empty where there is none."""

    subject: str
    reading: str
    evidence: str
    option: str = ""

    def text(self) -> str:
        """The assumption in a line."""
        decides = f"; {self.option} decides" if self.option else ""
        return f"{self.subject}: {self.reading} ({self.evidence}{decides})"


@dataclass(frozen=True, slots=True)
class Refusal:
    """A row, or a cell of it, that was not taken, with the reason. `row` is its number in the file."""

    row: int
    heading: str
    cell: str
    reason: str

    def text(self) -> str:
        """The refusal in a line."""
        place_text = f", {self.heading} `{self.cell[:60]}`" if self.heading else ""
        return f"row {self.row}{place_text}: {self.reason}"


@dataclass(frozen=True, slots=True)
class Options:
    """The user's options for a list: empty if the list itself decides.

    `base` is the notation of addresses, `decimal` the sign before a fraction, `gain` whether a factor multiplies or
    divides counts, `bounds` whether they are counts or in the unit, `length` the unit of lengths, `address_unit` what
    addresses count, `order` the order of the bytes of two words. `node` is the node of a bus that the device is.
    """

    base: str = ""
    decimal: str = ""
    gain: str = ""
    bounds: str = ""
    length: str = ""
    address_unit: str = ""
    order: str = ""
    node: str = ""


STATED_NOTHING = Options()
"""The options of a user without options."""
