"""Many records at once: a buffer of frames or log entries of a fixed size, as one column per field.

`arrays` needs only Python. `decode_many`, `records`, `view`, `dtype`, `bits` and `in_unit` need NumPy.

    columns = decode_many(Telegram111Response, captured)
    speed = in_unit(Telegram111Response, "speed_actual_b", columns["speed_actual_b"])
    enabled = bits(StatusWord1Positioning, columns["status_word_1"])["operation_enabled"]

A column has the raw values: numbers of enums, words of flags, counts. A field that is a list has a second
dimension, and a record within the record has columns of its own.
"""

from __future__ import annotations

from array import array
from struct import unpack
from sys import byteorder

from ._columns import NUMPY_TYPES, straight
from ._columns import Column as Column
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any, ClassVar, Protocol, TypeAlias

    import numpy as np

    from ._flags import Flags
    from ._typing import Data

    class Record(Protocol):
        """A generated class of records of one size."""

        _SIZE: ClassVar[int]

        @staticmethod
        def _columns() -> tuple[Column, ...]: ...

        @classmethod
        def decode(cls, data: Data) -> object: ...

    Columns: TypeAlias = dict[str, Any]
    Arrays: TypeAlias = dict[str, "array[Any] | list[bytes] | Arrays"]

BLOCK = 16384
"""Records that are taken at once, so that they stay in the processor's cache."""

_SIGNS = bytes(0xFF if byte > 0x7F else 0 for byte in range(256))


def arrays(record: type[Record], data: Data) -> Arrays:
    """The columns of all records as `array.array`, with Python alone; bytes and texts as lists of bytes.

    Floating-point numbers of 16 bits are in an array of 32-bit numbers, because `array` lacks them. The elements of a
    list follow each other. Raises CodecError for bytes left over, and for what `decode` refuses.
    """
    number = _number(record, data)
    buffer = data if isinstance(data, bytes) else bytes(data)
    return _arrays(record, buffer, 0, record._SIZE, number, record)


def _arrays(record: type[Record], data: bytes, base: int, size: int, number: int, whole: type[Record]) -> Arrays:
    columns: Arrays = {}
    for column in record._columns():
        if column.record is not None:
            parts = [
                _arrays(column.record, data, base + column.offset + element * column.size, size, number, whole)
                for element in range(column.count or 1)
            ]
            columns[column.name] = parts[0] if not column.count else _interleaved(parts, number)
            continue
        values = _array(column, data, base, size, number)
        if column.tests or column.text:
            _test_each(column, values, data, size, whole)
        if column.name:
            columns[column.name] = values
    return columns


def _array(column: Column, data: bytes, base: int, size: int, number: int) -> array[Any] | list[bytes]:
    """The elements of a column: its bytes are taken out one place after the other, with a step, and put together."""
    width, count = column.size, column.count or 1
    if column.letter == "s":
        starts = range(base + column.offset, len(data), size)
        return [data[offset + width * item : offset + width * (item + 1)] for offset in starts for item in range(count)]
    whole = width + column.padding
    bytes_of_place = b""
    joined = bytearray(whole * count * number)
    for element in range(count):
        for place, offset in enumerate(column.places(element)):
            bytes_of_place = data[base + offset :: size]
            joined[element * whole + _place(place, whole) :: whole * count] = bytes_of_place
        if column.padding and column.letter.islower() and not column.magnitude:
            signs = bytes_of_place.translate(_SIGNS)
            for place in range(width, whole):
                joined[element * whole + _place(place, whole) :: whole * count] = signs
    if column.letter == "e":
        return array("f", unpack(f"={count * number}e", joined))
    values: array[Any] = array(column.letter.upper() if column.magnitude else column.letter)
    values.frombytes(joined)
    if column.magnitude:
        half = column.half
        return array(column.letter, [bits if bits < half else half - bits for bits in values])
    return values


def _place(place: int, width: int) -> int:
    """The place of a byte in a number of the machine, by its place from the least significant one."""
    return place if byteorder == "little" else width - 1 - place


def _interleaved(records: list[Arrays], number: int) -> Arrays:
    """The columns of records in a list, whose elements then follow each other."""
    columns: Arrays = {}
    for name, first in records[0].items():
        parts: list[Any] = [part[name] for part in records]
        if isinstance(first, dict):
            columns[name] = _interleaved(parts, number)
            continue
        share = len(first) // number if number else 0
        joined = (item for row in range(number) for part in parts for item in part[row * share : (row + 1) * share])
        columns[name] = list(joined) if isinstance(first, list) else array(first.typecode, joined)
    return columns


def _test_each(column: Column, values: array[Any] | list[bytes], data: bytes, size: int, whole: type[Record]) -> None:
    if isinstance(values, list):
        right = not column.text or all(map(bytes.isascii, values))
    else:
        right = all(any(low <= value <= high for low, high in column.tests) for value in {*values})
    if not right:
        _refuse(whole, data, size)


def decode_many(record: type[Record], data: Data) -> Columns:
    """The columns of all records as NumPy arrays in the byte order of the machine; bytes and texts have the type `S`.

    Raises CodecError for bytes left over, and for the first record that `decode` refuses.
    """
    import numpy

    number = _number(record, data)
    raw = numpy.frombuffer(data, dtype(record)) if number else numpy.empty(0, dtype(record))
    columns = _empty(record, number)
    for start in range(0, number, BLOCK):
        _fill(record, raw[start : start + BLOCK], columns, slice(start, start + BLOCK))
    if not _allowed(record, columns):
        _refuse(record, bytes(data), record._SIZE)
    return _named(columns)


def _empty(record: type[Record], number: int, *lists: int) -> Columns:
    import numpy

    columns: Columns = {}
    for place, column in enumerate(record._columns()):
        shape = (number, *lists, column.count) if column.count else (number, *lists)
        key = column.name or f" {place}"
        if column.record is not None:
            columns[key] = _empty(column.record, number, *shape[1:])
        else:
            kind = f"S{column.size}" if column.letter == "s" else NUMPY_TYPES[column.letter]
            columns[key] = numpy.empty(shape, kind)
    return columns


def _fill(record: type[Record], raw: np.ndarray[Any, Any], columns: Columns, rows: slice) -> None:
    """Copies a block of records into the columns."""
    for place, column in enumerate(record._columns()):
        key = column.name or f" {place}"
        if column.record is not None:
            _fill(column.record, raw[key], columns[key], rows)
        else:
            columns[key][rows] = straight(column, raw[key])


def _allowed(record: type[Record], columns: Columns) -> bool:
    import numpy

    for place, column in enumerate(record._columns()):
        values = columns[column.name or f" {place}"]
        if column.record is not None:
            if not _allowed(column.record, values):
                return False
        elif column.text:
            if values.size and int(numpy.ascontiguousarray(values).view("u1").max(initial=0)) > 127:
                return False
        elif column.tests:
            is_inside = numpy.zeros(values.shape, bool)
            for low, high in column.tests:
                is_inside |= (values >= low) & (values <= high)
            if not is_inside.all():
                return False
    return True


def _named(columns: Columns) -> Columns:
    return {
        name: _named(column) if isinstance(column, dict) else column
        for name, column in columns.items()
        if not name.startswith(" ")
    }


def dtype(record: type[Record]) -> np.dtype[Any]:
    """The NumPy type of a record on the wire. Numbers with exchanged words are lists of words.

    Numbers of 3, 5, 6 or 7 bytes are lists of bytes, and those with a sign and a magnitude are their bits.
    """
    import numpy

    names, formats, offsets = [], [], []
    for place, column in enumerate(record._columns()):
        names.append(column.name or f" {place}")
        offsets.append(column.offset)
        formats.append(_format(column))
    size = record._SIZE
    return numpy.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": size})


def _format(column: Column) -> Any:
    shape: tuple[int, ...] = (column.count,) if column.count else ()
    sign = ">" if column.order == "big" else "<"
    if column.record is not None:
        kind: Any = dtype(column.record)
    elif column.letter == "s":
        kind = f"S{column.size}"
    elif column.padding:
        kind, shape = "u1", (*shape, column.size)
    elif column.swapped:
        kind, shape = f"{sign}u2", (*shape, column.size // 2)
    else:
        kind = f"{sign}{f'u{column.size}' if column.magnitude else NUMPY_TYPES[column.letter]}"
    return (kind, shape) if shape else kind


def view(record: type[Record], data: Data) -> np.ndarray[Any, Any]:
    """The records in the buffer itself, in constant time: nothing is copied, and nothing is tested.

    Raises CodecError for bytes left over.
    """
    import numpy

    number = _number(record, data)
    return numpy.frombuffer(data, dtype(record)) if number else numpy.empty(0, dtype(record))


def records(record: type[Record], data: Data) -> np.ndarray[Any, Any]:
    """A copy of the records in the byte order of the machine, as one structured array; nothing is tested.

    Raises CodecError for bytes left over.
    """
    copy: np.ndarray[Any, Any] = view(record, data).astype(dtype(record).newbyteorder("="))
    return copy


def bits(word: type[Flags], column: np.ndarray[Any, Any]) -> Columns:
    """The bits of a column of words by name, as columns of booleans; fields of several bits as numbers."""
    return {
        name: _number_of_bits(word, name, column, first, maximum) if maximum > 1 else (column & (1 << first)) != 0
        for name, (first, maximum) in word._BITS.items()
    }


def _number_of_bits(
    word: type[Flags], name: str, column: np.ndarray[Any, Any], first: int, maximum: int
) -> np.ndarray[Any, Any]:
    """The numbers in a field of bits; signed numbers have 64 bits."""
    numbers: np.ndarray[Any, Any] = column >> first & maximum
    if name in word._RUNS:
        numbers = sum((column >> place & ones) << weight for place, ones, weight in word._RUNS[name])  # type: ignore[assignment]
    return (numbers ^ maximum // 2 + 1).astype("i8") - (maximum // 2 + 1) if name in word._SIGNED else numbers


def in_unit(record: type[Record], name: str, column: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """A column of counts in the unit of its field, as floating-point numbers. Raises KeyError for other fields.

    A count that stands for an absent value becomes NaN.
    """
    for candidate in record._columns():
        if candidate.name == name and candidate.ratio is not None:
            a, b, c = candidate.ratio
            quantities = column.astype("f8")
            if a != 1:
                quantities *= a
            if b:
                quantities += b
            if c != 1:
                quantities /= c
            for count in candidate.absent:
                low, high = (count.start, count.stop - 1) if isinstance(count, range) else (count, count)
                quantities[(column >= low) & (column <= high)] = float("nan")
            return quantities
    raise KeyError(f"{name} is not a field of {record.__name__} that counts in parts of a unit")


def _number(record: type[Record], data: Data) -> int:
    """The number of records. Raises CodecError for bytes left over."""
    if not hasattr(record, "_columns"):  # its length varies, or all of it is reserved, or a number is sent as digits
        raise TypeError(f"{record.__name__} has no columns; decode one after the other")
    size = len(data) if isinstance(data, (bytes, bytearray)) else memoryview(data).nbytes
    left = size % record._SIZE
    if left:
        detail = f"{size} bytes are {size // record._SIZE} of {record._SIZE} bytes, and {left} left over"
        raise CodecError("incomplete", detail, size - left)
    return size // record._SIZE


def _refuse(record: type[Record], data: bytes, size: int) -> None:
    """Raises the error of the first record that cannot be decoded."""
    offset = 0
    try:
        for offset in range(0, len(data), size):
            record.decode(data[offset : offset + size])
    except CodecError as error:
        raise error.shifted(offset) from None
