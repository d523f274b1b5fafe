"""The exception of all codecs, and its messages."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any


class CodecError(ValueError):
    """Bytes or values that a codec refuses.

    `reason` is one of: incomplete, wrong_length, wrong_mark, wrong_checksum, not_hex, unknown_code,
    unknown_value, wrong_const, wrong_measure, out_of_range, wrong_type, read_only,
    no_message.
    `offset` is the byte that is wrong, None for values.
    """

    def __init__(self, reason: str, detail: str, offset: int | None = None) -> None:
        location = "" if offset is None else f" at byte {offset}"
        super().__init__(f"{reason}{location}: {detail}")
        self.reason, self.detail, self.offset = reason, detail, offset

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.reason, self.detail, self.offset)

    def shifted(self, distance: int) -> CodecError:
        """The same error, `distance` bytes further on."""
        return CodecError(self.reason, self.detail, None if self.offset is None else self.offset + distance)


def wrong_length(
    name: str, length: int, minimum: int, maximum: int | None, fixed: int = 0, unit: int = 1
) -> CodecError:
    """The error for `length` bytes where a record has `minimum` to `maximum`, in steps of `unit` above `fixed`."""
    if length < minimum:
        return CodecError("incomplete", f"{name} has at least {minimum} bytes, not {length}", length)
    if maximum is not None and length > maximum:
        return CodecError("wrong_length", f"{name} has at most {maximum} bytes, not {length}", maximum)
    return CodecError("wrong_length", f"{length - fixed} bytes are not a whole number of elements of {unit}", length)


def unknown_member(name: str, raw: int, enum: str, offset: int) -> CodecError:
    """A value that a closed enum does not list."""
    return CodecError("unknown_value", f"{name} is {raw}, which {enum} does not list", offset)


def no_boolean(name: str, raw: int, offset: int) -> CodecError:
    """A boolean that is neither 0 nor 1."""
    return CodecError("unknown_value", f"{name} is {raw}, neither 0 nor 1", offset)


def wrong_const(name: str, raw: int, const: int, offset: int) -> CodecError:
    """A value that is not its constant."""
    return CodecError("wrong_const", f"{name} is {raw}, not {const}", offset)


def wrong_measure(name: str, raw: int, measured: int, offset: int) -> CodecError:
    """A value that is not the size of what it measures."""
    return CodecError("wrong_measure", f"{name} is {raw}, but there are {measured}", offset)


def wrong_presence(name: str, raw: int, other_name: str, elements: int, offset: int | None = None) -> CodecError:
    """A value that does not say that another field is sent, though it is, or the other way round."""
    return CodecError("wrong_measure", f"{name} is {raw}, but there are {elements} of {other_name}", offset)


def wrong_end(name: str, numbers: list[int], mask: int, following: tuple[int, ...] | range) -> CodecError | None:
    """An element that does not say that another one of a list follows, though one does, or the other way round."""
    last = len(numbers) - 1
    for index, raw in enumerate(numbers):
        if (raw & mask in following) != (index < last):
            count = "another one follows" if index < last else "no other one follows"
            return CodecError("wrong_measure", f"element {index} of {name} says {raw}, but {count}")
    return None


def wrong_bits(name: str, raw: int, other_name: str, size: int, offset: int | None = None) -> CodecError:
    """A number of bits that takes another number of bytes than there are."""
    return CodecError(
        "wrong_measure", f"{name} is {raw}, which takes {(raw + 7) // 8} bytes, but {other_name} has {size}", offset
    )
