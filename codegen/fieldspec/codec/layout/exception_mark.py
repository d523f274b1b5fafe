"""The constant in the data of a response that says that it is an exception response."""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.subcodes import constant_at

if TYPE_CHECKING:
    from typing import Literal

    from fieldspec.codec.layout.record import FieldLayout, RecordLayout
    from fieldspec.language.model.link import ExceptionResponse


@dataclass(frozen=True, slots=True)
class ExceptionMark:
    """The unsigned `number` of `size` bytes that exception responses have `offset` bytes after the header."""

    offset: int
    size: int
    order: str
    number: int

    @property
    def end(self) -> int:
        """The bytes of data that are needed to read it."""
        return self.offset + self.size

    @property
    def pattern(self) -> bytes:
        """The bytes of the number."""
        order: Literal["big", "little"] = "little" if self.order == "little" else "big"
        return self.number.to_bytes(self.size, order)

    def is_in(self, data: bytes) -> bool:
        """Whether some data belong to an exception response."""
        return data[self.offset : self.end] == self.pattern


def reason_field(record: RecordLayout) -> FieldLayout | None:
    """The field of an exception response that says why: the first one with an enum, else the first that varies.

    None where all fields are constants.
    """
    free = [field for field in record.fields if field.value is not None and field.value.const is None]
    return next((field for field in free if field.value is not None and field.value.enum), free[0] if free else None)


def word_order_of(field: FieldLayout) -> str:
    """The order of the words of a field: that of the bytes in each, or the opposite one."""
    return {"big": "little", "little": "big"}[field.order] if field.swapped else field.order


def exception_mark(exception: ExceptionResponse | None, record: RecordLayout | None) -> ExceptionMark | None:
    """The mark in the data of exception responses; None where they are marked before the body, or not at all."""
    field = record.named(exception.field) if exception is not None and record is not None else None
    constant = constant_at(field.field, field.offset, field.order, word_order_of(field)) if field is not None else None
    return ExceptionMark(*constant[0], constant[1]) if constant is not None else None
