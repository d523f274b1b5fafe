"""Why a value cannot be encoded. Each function returns None for a value that can be.

The generated `encode` methods test all fields in one expression. Only where that fails do they call these functions,
field by field, to find the wrong one.
"""

from __future__ import annotations

from struct import Struct

from ._absent import bits_at, is_among
from ._error import CodecError, wrong_bits
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Container
    from typing import Any, TypeAlias

    from ._typing import Others

    BoundedBits: TypeAlias = tuple[str, int | tuple[tuple[int, int, int], ...], tuple[tuple[int, int], ...], str]

_F16, _F32, _F64 = Struct(">e"), Struct(">f"), Struct(">d")


def refused_code(code: int, expected: int) -> CodecError | None:
    """The only code of exception responses."""
    if code == expected:
        return None
    return CodecError("unknown_code", f"an exception response has the code {expected:#04x}")


def refused_broadcast(name: str, value: Any, address: int, message: str) -> CodecError | None:
    """Any unit address but the broadcast address."""
    if value != address or not isinstance(value, int):
        return None
    return CodecError("out_of_range", f"{name} is {int(value)}: {message} cannot be broadcast")


def refused_bits(name: str, number: int, other_name: str, size: int) -> CodecError | None:
    """A number of bits that are packed into that number of bytes."""
    return None if (number + 7) // 8 == size else wrong_bits(name, int(number), other_name, size)


def refused_number(
    name: str,
    value: Any,
    low: int,
    high: int,
    ranges: tuple[tuple[int, int], ...] = (),
    other_values: Others = (),
    members: Container[int] | None = None,
    enum: str = "",
) -> CodecError | None:
    """A whole number from `low` to `high`, in `ranges`, or one of `other_values`; for an enum, one of `members`."""
    if not isinstance(value, int):
        return CodecError("wrong_type", f"{name} is a whole number, not {value!r}")
    if members is not None and value not in members and not is_among(value, other_values):
        return CodecError("unknown_value", f"{name} is {int(value)}, which {enum} does not list")
    fits = low <= value <= high
    if fits and (
        not ranges or is_among(value, other_values) or any(minimum <= value <= maximum for minimum, maximum in ranges)
    ):
        return None
    allowed = ", ".join(f"{a}" if a == b else f"{a}..{b}" for a, b in ranges or ((low, high),))
    return CodecError("out_of_range", f"{name} is {int(value)}, not in {allowed}")


def refused_flags(
    name: str, value: Any, high: int, ranges: tuple[tuple[int, int], ...] = (), bits: tuple[BoundedBits, ...] = ()
) -> CodecError | None:
    """A word of flags, in which each of some `bits` is in its range."""
    raw = getattr(value, "raw", None)
    if raw is None:
        return CodecError("wrong_type", f"{name} is a word of flags, not {value!r}")
    refusal = refused_number(name, raw, 0, high, ranges)
    if refusal is not None:
        return refusal
    for title, place, images, allowed in bits:
        number = bits_at(raw, place)
        if not any(low <= number <= maximum for low, maximum in images):
            return CodecError("out_of_range", f"{title} of {name} is not in {allowed}")
    return None


def refused_half(
    name: str, value: Any, ranges: tuple[tuple[float, float], ...] = (), other_values: Others = ()
) -> CodecError | None:
    """A floating-point number of 16 bits, as `refused_float` says it of 32."""
    return _refused_real(name, value, _F16, ranges, other_values)


def refused_float(
    name: str, value: Any, ranges: tuple[tuple[float, float], ...] = (), other_values: Others = ()
) -> CodecError | None:
    """A floating-point number of 32 bits, in `ranges`, or one of `other_values`; without ranges any one, NaN too."""
    return _refused_real(name, value, _F32, ranges, other_values)


def refused_double(
    name: str, value: Any, ranges: tuple[tuple[float, float], ...] = (), other_values: Others = ()
) -> CodecError | None:
    """A floating-point number of 64 bits, as `refused_float` says it of 32."""
    return _refused_real(name, value, _F64, ranges, other_values)


def _refused_real(
    name: str, value: Any, struct: Struct, ranges: tuple[tuple[float, float], ...], other_values: Others
) -> CodecError | None:
    if not isinstance(value, (int, float)):
        return CodecError("wrong_type", f"{name} is a number, not {value!r}")
    try:
        # A Struct raises its own error for a whole number that none of its numbers comes near.
        struct.pack(float(value))
    except OverflowError:
        return CodecError("out_of_range", f"{name} is {value}, more than {8 * struct.size} bits can hold")
    if not ranges or any(minimum <= value <= maximum for minimum, maximum in ranges) or is_among(value, other_values):
        return None
    allowed = ", ".join(f"{a}" if a == b else f"{a}..{b}" for a, b in ranges)
    return CodecError("out_of_range", f"{name} is {value}, not in {allowed}")


def refused_text(name: str, value: Any, size: int) -> CodecError | None:
    """Characters of ASCII, at most `size`; a zero would end the text where it is read."""
    if not isinstance(value, str):
        return CodecError("wrong_type", f"{name} is a text, not {value!r}")
    if not value.isascii():
        return CodecError("unknown_value", f"{name} holds characters that are not ASCII")
    if "\0" in value:
        return CodecError("unknown_value", f"{name} holds a zero, which ends a text")
    if len(value) > size:
        return CodecError("wrong_length", f"{name} has {size} characters, not {len(value)}")
    return None


def refused_bytes(name: str, value: Any, size: int, minimum: int | None = None) -> CodecError | None:
    """Exactly `size` bytes, or from the `minimum` on."""
    if not isinstance(value, (bytes, bytearray)):
        return CodecError("wrong_type", f"{name} is bytes, not {value!r}")
    if not (size if minimum is None else minimum) <= len(value) <= size:
        return CodecError("wrong_length", f"{name} has {size} bytes, not {len(value)}")
    return None


def refused_record(name: str, value: Any, record: type) -> CodecError | None:
    """A record whose fields can all be encoded."""
    if not isinstance(value, record):
        return CodecError("wrong_type", f"{name} is a {record.__name__}, not {value!r}")
    try:
        value.encode()  # type: ignore[attr-defined]
    except CodecError as error:
        return error
    return None


def refused_list(
    name: str, values: Any, minimum: int, maximum: int, refused: Callable[..., CodecError | None], *limits: Any
) -> CodecError | None:
    """`minimum` to `maximum` elements, none of which the function refuses with its `limits`."""
    if not isinstance(values, (list, tuple)):
        return CodecError("wrong_type", f"{name} is a list, not {values!r}")
    if not minimum <= len(values) <= maximum:
        allowed = f"{minimum}" if minimum == maximum else f"{minimum} to {maximum}"
        return CodecError("wrong_length", f"{name} has {allowed} elements, not {len(values)}")
    for number, value in enumerate(values):
        error = refused(f"{name}[{number}]", value, *limits)
        if error is not None:
            return error
    return None


def unfit(name: str) -> CodecError:
    """The error for a record with a value of a type that cannot be encoded."""
    return CodecError("wrong_type", f"{name} holds a value of a type that it cannot have")
