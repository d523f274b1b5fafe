"""What is taken for granted of a list where it does not say it: with the evidence, and the option that decides."""

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
    """What the user says of a list: empty where the list is to show it itself.

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
"""What a user says who gives no option."""
