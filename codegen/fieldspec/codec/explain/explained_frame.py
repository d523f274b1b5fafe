"""The meaning of every byte of a frame."""

from __future__ import annotations

from fieldspec.codec.explain.registers import RegisterRows
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.values import ACCEPTED
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import dataclass, field


@dataclass(frozen=True, slots=True)
class Explanation:
    """The meaning of every byte of a frame.

    `rows` cover every byte of the frame once, in order. `registers` are the registers that the frame reads or writes,
    by address; their bytes, if the frame carries them, are in `rows` too. `accessed` are the addresses of the first and
    the last word or bit that a message with `accesses` reads or writes; None where the frame does not tell. `message`
    is empty if the message is unknown. `error` marks an exception response. `values` are the raw values of the header,
    without the length, and of the fields in the body, by name. `errata` are the ids of those about the message and
    about the link as a whole.
    """

    link: str
    direction: str
    message: str
    error: bool
    frame: bytes
    rows: tuple[ExplanationRow, ...]
    register_rows: RegisterRows = field(repr=False)
    values: dict[str, Raw] = field(repr=False)
    errata: tuple[str, ...] = ()
    accessed: tuple[int, int] | None = None

    @property
    def registers(self) -> tuple[ExplanationRow, ...]:
        """The rows of the registers. They are made on demand, because most readings of a frame are dropped."""
        return self.register_rows.rows

    @property
    def reasons(self) -> tuple[str, ...]:
        """The reasons for which a codec refuses the frame, as its errors name them; empty if it accepts the frame."""
        return tuple(row.reason for row in self.rows if row.reason not in ACCEPTED)
