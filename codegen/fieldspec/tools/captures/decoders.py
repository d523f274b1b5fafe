"""Decodes one kind of value in many frames at once: raw values, quantities, names and verdicts as columns."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from fieldspec.codec.explain.values import number_of as number_of_bytes
from fieldspec.codec.layout.accepted import accepted
from fieldspec.codec.layout.decision import MARK
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    Precision,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    is_array,
    is_octets,
    number_of,
    sign_of,
)
from fieldspec.language.model.text_form import decoded_text
from fieldspec.language.model.value import Value
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, Texts, Verdicts, number_at
from fieldspec.tools.captures.meanings import Counts, Meanings, passing
from fieldspec.tools.captures.text_list import TextList
from fieldspec.tools.captures.verdicts import (
    OK,
    OUT_OF_RANGE,
    UNKNOWN_VALUE,
)

UNSEEN = -2
MOST_INDEXED = 16
"""The bits of the widest number whose meanings are in a table, by its bits."""


@dataclass(frozen=True, slots=True)
class ValueColumns:
    """Decoded values. `raw` and `quantity` count only where `has_raw` and `has_quantity` are true."""

    raw: Numbers
    has_raw: Mask
    quantity: npt.NDArray[np.float64]
    has_quantity: Mask
    text: Texts
    verdict: Verdicts

    @staticmethod
    def empty(rows: int) -> ValueColumns:
        """Columns without any value yet."""
        return ValueColumns(
            np.zeros(rows, np.int64),
            np.zeros(rows, np.bool_),
            np.zeros(rows, np.float64),
            np.zeros(rows, np.bool_),
            np.full(rows, -1, np.int32),
            np.zeros(rows, np.int8),
        )

    def put(self, rows: Numbers, own: ValueColumns) -> None:
        """Writes decoded values into some rows."""
        for name in ("raw", "has_raw", "quantity", "has_quantity", "text", "verdict"):
            getattr(self, name)[rows] = getattr(own, name)


class Decoder:
    """Decodes the values of one definition. Equal definitions share a decoder, as their `key` is equal.

    `is_lenient`: what starts something does not answer what was written, so that only its type binds what is read.
    """

    def __init__(
        self, device: Device, texts: TextList, value: Value, order: str, swapped: bool, reserved: bool, is_lenient: bool
    ) -> None:
        self.device, self.texts, self.value = device, texts, value
        self.order, self.swapped, self.reserved, self.is_lenient = order, swapped, reserved, is_lenient
        self.encoding = value.encoding
        self.is_unsigned_wide = number_of(self.encoding) == Whole(64, Sign.NONE)
        self.is_named = _is_named(value) and not reserved
        has_meanings = self.is_named or bool(value.sentinels) or value.const is not None
        self.has_table = has_meanings and _is_indexed(self.encoding) and not reserved
        self.has_quantity = not is_array(self.encoding) and not value.enum and not value.flags
        scale = value.scale.as_integer_ratio()
        offset = value.offset.as_integer_ratio()
        self.factor = scale[0] * offset[1]
        self.summand = offset[0] * scale[1]
        self.divisor = scale[1] * offset[1]
        self._table: tuple[Texts, Verdicts, Mask] | None = None
        self._meanings = Meanings(device, value, texts)

    def decode(self, buffer: Bytes, offsets: Numbers) -> ValueColumns:
        """The values whose bytes begin at some places."""
        encoding = self.encoding
        match encoding:
            case Text() | Octets():
                return self._characters(buffer, offsets)
            case Real():
                return self._floats(reals_of(encoding.precision, self._raw(buffer, offsets)))
            case Digits():
                return self._digits_of(buffer, offsets)
            case Whole() | Truth():
                return self._integers(self._raw(buffer, offsets))
            case _:
                assert_never(encoding)

    def of_bits(self, bits: Numbers) -> ValueColumns:
        """The values of single bits, which are 0 or 1."""
        return self._integers(bits)

    def _raw(self, buffer: Bytes, offsets: Numbers) -> Numbers:
        return number_at(buffer, offsets, self.value.size, self.order, sign_of(self.encoding), self.swapped)

    def _integers(self, raw: Numbers) -> ValueColumns:
        result = ValueColumns.empty(len(raw))
        result.raw[:] = raw
        result.has_raw[:] = True
        is_unsigned_high = (raw < 0) if self.is_unsigned_wide else None
        wide = raw.view(np.uint64).astype(np.float64) if is_unsigned_high is not None else raw.astype(np.float64)
        if self.has_quantity:
            result.has_quantity[:] = True
            result.quantity[:] = self._scaled(wide)
        if is_unsigned_high is not None and is_unsigned_high.any():
            result.has_raw[is_unsigned_high] = False
        if self.has_table:
            self._by_table(raw, result)
        elif not self.reserved:
            self._by_number(raw, result)
        if is_unsigned_high is not None and is_unsigned_high.any():
            nameless = is_unsigned_high & (result.text < 0)
            result.text[nameless] = self._digits(raw[nameless])
        if self.is_lenient:
            result.verdict[self._is_of_type(raw)] = OK
        return result

    def _is_of_type(self, raw: Numbers) -> Mask:
        """Whether numbers are what a trigger can be read as."""
        result = np.ones(len(raw), np.bool_)
        for condition in accepted(self.device, self.value.as_answer(True)).reading:
            result &= passing(condition.test, raw)
        return result

    def _scaled(self, wide: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """The nearest number to raw * scale + offset, as the product is exact up to 2^53."""
        if self.divisor == self.factor and not self.summand:
            return wide
        return np.asarray((wide * float(self.factor) + float(self.summand)) / float(self.divisor))

    def _digits(self, raw: Numbers) -> Texts:
        return np.array([self.texts.place(str(number)) for number in raw.view(np.uint64).tolist()], np.int32)

    def _by_table(self, raw: Numbers, result: ValueColumns) -> None:
        """Looks names and verdicts up by the raw value. The table is filled as values appear."""
        size = 1 << 8 * self.value.size
        if self._table is None:
            self._table = np.full(size, UNSEEN, np.int32), np.zeros(size, np.int8), np.zeros(size, np.bool_)
        texts, verdicts, quantities = self._table
        places = self._bits(raw)
        numbers = texts[places]
        is_new = numbers == UNSEEN
        if is_new.any():
            new = np.zeros(size, np.bool_)
            new[places[is_new]] = True
            of_place = np.zeros(size, np.int64)
            of_place[places[is_new]] = raw[is_new]
            texts[new], verdicts[new], quantities[new] = self._meanings.of(of_place[new])
            numbers = texts[places]
        result.text[:] = numbers
        result.verdict[:] = verdicts[places]
        result.has_quantity[:] = quantities[places]

    def _bits(self, raw: Numbers) -> Numbers:
        """The bits of numbers, as whole numbers."""
        sign, highest = sign_of(self.encoding), 1 << 8 * self.value.size - 1
        match sign:
            case Sign.NONE | Sign.COMPLEMENT:
                return raw & 2 * highest - 1
            case Sign.MAGNITUDE:
                return np.where(raw < 0, highest - raw, raw)
            case _:
                assert_never(sign)

    def _by_number(self, raw: Numbers, result: ValueColumns) -> None:
        """The same for wide values. Each distinct word is named once."""
        if self.value.flags:
            distinct, places = np.unique(raw, return_inverse=True)
            own = self._meanings.of(self._counts(np.asarray(distinct, np.int64)))
            texts, verdicts, quantities = (column[places] for column in own)
        else:
            texts, verdicts, quantities = self._meanings.of(self._counts(raw))
        result.text[:], result.verdict[:] = texts, verdicts
        np.logical_and(result.has_quantity, quantities, out=result.has_quantity)

    def _counts(self, raw: Numbers) -> Counts:
        return raw.view(np.uint64) if self.is_unsigned_wide else raw

    def _floats(self, exact: npt.NDArray[np.float64]) -> ValueColumns:
        result = ValueColumns.empty(len(exact))
        result.quantity[:] = exact
        result.has_quantity[:] = True
        if self.reserved:
            return result
        value = self.value
        if value.ranges is not None:
            is_within = np.zeros(len(exact), np.bool_)
            for low, high in value.ranges.intervals:
                is_within |= (exact >= low) & (exact <= high)
            result.verdict[~is_within] = OUT_OF_RANGE
        for sentinel in value.sentinels:
            is_sentinel = np.isnan(exact) if sentinel.is_nan else exact == sentinel.value
            result.verdict[is_sentinel] = OK
            result.text[is_sentinel] = self.texts.place(sentinel.name)
            result.has_quantity[is_sentinel] = False
        if self.is_lenient:
            result.verdict[:] = OK
        return result

    def _digits_of(self, buffer: Bytes, offsets: Numbers) -> ValueColumns:
        """The values of digits: invalid bytes are a text with a verdict."""
        table = buffer[np.minimum(offsets[:, None] + np.arange(self.value.size), len(buffer) - 1)]
        pieces = [row.tobytes() for row in table]
        numbers = {piece: number_of_bytes(self.value, piece, self.order, self.swapped) for piece in set(pieces)}
        raw = [number if isinstance(number := numbers[piece], int) else 0 for piece in pieces]
        result = self._integers(
            np.array(raw, np.uint64).view(np.int64) if self.value.low == 0 else np.array(raw, np.int64)
        )
        for row, piece in enumerate(pieces):
            if not isinstance(numbers[piece], int):
                result.has_raw[row] = result.has_quantity[row] = False
                result.text[row] = self.texts.place(piece.hex(" ").upper())
                result.verdict[row] = OK if self.reserved else UNKNOWN_VALUE
        return result

    def _characters(self, buffer: Bytes, offsets: Numbers) -> ValueColumns:
        result = ValueColumns.empty(len(offsets))
        table = buffer[np.minimum(offsets[:, None] + np.arange(self.value.image_size), len(buffer) - 1)]
        for row, data in enumerate(table):
            result.text[row], result.verdict[row] = self._character_text(data.tobytes())
        return result

    def _character_text(self, data: bytes) -> tuple[int, int]:
        data = data[: data.rindex(MARK)] if self.value.is_marked else data
        has_no_text = is_octets(self.encoding) or self.reserved
        text = None if has_no_text else decoded_text(self.value, self.order, data)
        if text is None:
            return self.texts.place(data.hex(" ").upper()), OK if has_no_text else UNKNOWN_VALUE
        return self.texts.place(text), OK


def _is_named(value: Value) -> bool:
    """Whether some of its numbers have names."""
    encoding = value.encoding
    match encoding:
        case Truth():
            return True
        case Whole() | Digits():
            return bool(value.enum or value.flags)
        case Real() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


def _is_indexed(encoding: Encoding) -> bool:
    """Whether it has so few numbers that a table has a row for each of them, by its bits."""
    match encoding:
        case Whole() | Truth():
            return encoding.bits <= MOST_INDEXED
        case Real() | Digits() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


def reals_of(precision: Precision, bits: Numbers) -> npt.NDArray[np.float64]:
    """The floating-point numbers of some bits."""
    with np.errstate(invalid="ignore"):  # a signalling NaN
        match precision:
            case Precision.HALF:
                return bits.astype(np.uint16).view(np.float16).astype(np.float64)
            case Precision.SINGLE:
                return bits.astype(np.uint32).view(np.float32).astype(np.float64)
            case Precision.DOUBLE:
                return bits.view(np.float64)
            case _:
                assert_never(precision)


class Decoders:
    """The decoders of a device, one for each definition, with their places."""

    def __init__(self, device: Device, texts: TextList) -> None:
        self.device, self.texts = device, texts
        self.items: list[Decoder] = []
        self._places: dict[object, int] = {}

    def place(self, value: Value, order: str, swapped: bool, reserved: bool = False, is_lenient: bool = False) -> int:
        """The place of the decoder of a definition."""
        bare = replace(value, default=None, unit="", scale_text="")
        key = (repr(bare), order, swapped, reserved, is_lenient)
        if key not in self._places:
            self._places[key] = len(self.items)
            self.items.append(Decoder(self.device, self.texts, value, order, swapped, reserved, is_lenient))
        return self._places[key]
