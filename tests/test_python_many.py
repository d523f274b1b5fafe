"""Many records at once against one at a time: with NumPy, and with Python alone."""

from __future__ import annotations

from array import array
from typing import Any

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from layouts import SPECS, TEST_SPECS, all_layouts, newest
from python_package import built, codec_error, module_of, outcome, raws, record_class, runtime
from random_values import bytes_of, values_of

MANY = runtime("many")
CodecError = codec_error()
HIWIN, WIDGET = module_of(newest(SPECS, "hiwin-e")), module_of(newest(TEST_SPECS, "widget"))
TELEGRAM = HIWIN.Telegram111Response
FRAME = bytes.fromhex("04 BF 91 00 00 07 00 00 00 00 FF FF CF C7 10 00 00 00 00 00 00 00 00 00")


def fixed(layout: DeviceLayout) -> list[RecordLayout]:
    """The records, and data of messages, that have columns."""
    data = [side for message in layout.messages.values() for side in message.bodies]
    return [
        record
        for record in (*layout.records.values(), *data)
        if hasattr(record_class(module_of(layout), record), "_SIZE")
    ]


LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts() if fixed(layout)}
EACH = pytest.mark.parametrize("name", LAYOUTS)


def of_record(value: Any, path: tuple[int, ...] = ()) -> dict[tuple[int, ...], list[Any]]:
    """The numbers and bytes of one record by the places of their fields; those of lists one after the other."""
    values: dict[tuple[int, ...], list[Any]] = {}
    if isinstance(value, dict):
        for place, field in enumerate(value.values()):
            values |= of_record(field, (*path, place))
        return values
    for element in value if isinstance(value, (list, tuple)) else [value]:
        if isinstance(element, dict):
            for key, field in of_record(element, path).items():
                values[key] = values.get(key, []) + field
        else:
            data = element.encode("ascii") if isinstance(element, str) else element
            field = data.rstrip(b"\0") if isinstance(data, bytes) else data
            values[path] = [*values.get(path, []), int(field) if isinstance(field, bool) else field]
    return values


def of_columns(columns: dict[str, Any], at: int, path: tuple[int, ...] = ()) -> dict[tuple[int, ...], list[Any]]:
    """The same for the record at a place of columns."""
    values: dict[tuple[int, ...], list[Any]] = {}
    for place, column in enumerate(columns.values()):
        if isinstance(column, dict):
            values |= of_columns(column, at, (*path, place))
        else:
            values[(*path, place)] = numpy.ravel(column[at]).tolist()
    return values


@pytest.mark.proof(8)
@EACH
@examples(60)
@given(data=st.data())
def test_columns_hold_what_each_record_holds(name: str, data: st.DataObject) -> None:
    layout = LAYOUTS[name]
    record = data.draw(st.sampled_from(fixed(layout)))
    module = module_of(layout)
    drawn = [
        built(module, layout, record, values) for values in data.draw(st.lists(values_of(layout, record), max_size=5))
    ]
    frames = [record.encode() for record in drawn if not outcome(record.encode)[0]]
    cls, whole = record_class(module, record), b"".join(frames)
    columns = MANY.decode_many(cls, whole)
    for at, frame in enumerate(frames):
        assert str(of_columns(columns, at)) == str(of_record(raws(cls.decode(frame), record)))


@pytest.mark.proof(8)
@EACH
@examples(60)
@given(data=st.data())
def test_what_one_record_refuses_the_columns_refuse_at_its_place(name: str, data: st.DataObject) -> None:
    layout = LAYOUTS[name]
    record = data.draw(st.sampled_from(fixed(layout)))
    cls = record_class(module_of(layout), record)
    size = record.size or 0
    frames = [
        frame[:size].ljust(size, b"\0") for frame in data.draw(st.lists(bytes_of(record), min_size=1, max_size=4))
    ]
    each = (refused(cls.decode, frame, number * size) for number, frame in enumerate(frames))
    expected = next((error for error in each if error), None)
    assert refused(lambda whole: MANY.decode_many(cls, whole), b"".join(frames)) == expected
    assert refused(lambda whole: MANY.arrays(cls, whole), b"".join(frames)) == expected


def refused(decode: Any, data: bytes, at: int = 0) -> Any:
    """The reason why the bytes at an offset are refused; None where they are valid."""
    try:
        decode(data)
    except CodecError as error:
        return error.reason, error.detail, None if error.offset is None else error.offset + at
    return None


@EACH
def test_the_plain_arrays_hold_the_same_as_the_columns(name: str) -> None:
    layout = LAYOUTS[name]
    for record in fixed(layout):
        cls = record_class(module_of(layout), record)
        size = record.size or 0
        frames = [bytes((byte + place) % 128 for place in range(size)) for byte in range(250)]
        whole = b"".join(frame for frame in frames if not refused(cls.decode, frame))
        assert flat(MANY.arrays(cls, whole)) == flat(MANY.decode_many(cls, whole))


def flat(columns: dict[str, Any]) -> dict[str, Any]:
    """Columns as plain lists; the dimensions are left out."""
    columns_by_name: dict[str, Any] = {}
    for name, column in columns.items():
        if isinstance(column, dict):
            columns_by_name[name] = flat(column)
        else:
            values = (
                column.tolist() if isinstance(column, array) else numpy.ravel(column).tolist() if len(column) else []
            )
            columns_by_name[name] = str(
                [value.rstrip(b"\0") if isinstance(value, bytes) else value for value in values]
            )
    return columns_by_name


@pytest.mark.parametrize("decode", [MANY.decode_many, MANY.arrays, MANY.view, MANY.records])
def test_bytes_left_over_are_refused_with_their_number(decode: Any) -> None:
    with pytest.raises(CodecError) as caught:
        decode(TELEGRAM, FRAME * 3 + b"\1\2\3\4\5")
    assert (caught.value.reason, caught.value.offset) == ("incomplete", 72)
    assert caught.value.detail == "77 bytes are 3 of 24 bytes, and 5 left over"


@pytest.mark.parametrize("decode", [MANY.decode_many, MANY.arrays])
def test_no_bytes_are_no_records(decode: Any) -> None:
    columns = decode(TELEGRAM, b"")
    assert [*columns] == [*TELEGRAM.__match_args__]
    assert {len(column) for column in columns.values()} == {0}


def test_more_records_than_one_block_are_all_there() -> None:
    number = MANY.BLOCK * 2 + 3
    columns = MANY.decode_many(TELEGRAM, FRAME * number)
    assert {len(column) for column in columns.values()} == {number}
    assert (columns["position_actual_a"] == -12345).all()
    assert columns["position_actual_a"].dtype.isnative


def test_a_view_copies_nothing() -> None:
    buffer = bytearray(FRAME * 2)
    seen = MANY.view(TELEGRAM, buffer)
    buffer[0:2] = b"\x12\x34"
    assert seen["status_word_1"].tolist() == [0x1234, 0x04BF]


def test_native_records_hold_the_same_as_the_view() -> None:
    native = MANY.records(TELEGRAM, FRAME * 2)
    assert native["position_actual_a"].dtype.isnative
    assert native["position_actual_a"].tolist() == [-12345, -12345]


def test_bits_are_columns_by_name() -> None:
    column = MANY.decode_many(TELEGRAM, FRAME * 2)["status_word_1"]
    word = HIWIN.StatusWord1Positioning(0x04BF)
    assert {name: bits.tolist() for name, bits in MANY.bits(type(word), column).items()} == {
        name: [bit, bit] for name, bit in word.flags().items()
    }


def test_counts_become_values_in_the_unit() -> None:
    columns = MANY.decode_many(TELEGRAM, FRAME.replace(b"\x10\0\0\0\0\0\0\0\0\0", b"\x10\0\x20\0\0\0\0\0\0\0") * 2)
    expected = TELEGRAM.decode(
        FRAME.replace(b"\x10\0\0\0\0\0\0\0\0\0", b"\x10\0\x20\0\0\0\0\0\0\0")
    ).speed_actual_b_percent
    assert MANY.in_unit(TELEGRAM, "speed_actual_b", columns["speed_actual_b"]).tolist() == [expected, expected]
    with pytest.raises(KeyError, match="fault_code is not a field"):
        MANY.in_unit(TELEGRAM, "fault_code", columns["fault_code"])


def test_records_of_different_lengths_are_refused() -> None:
    with pytest.raises(TypeError, match="ExchangeRequest has no columns; decode one after the other"):
        MANY.decode_many(WIDGET.ExchangeRequest, b"")


def test_a_sentinel_becomes_no_number_in_a_column_in_the_unit() -> None:
    counts = numpy.array([0, 150, 0xFFFF], "u2")
    quantities = MANY.in_unit(WIDGET.Everything, "half", counts)
    assert numpy.isnan(quantities).tolist() == [False, False, True]
    assert quantities[:2].tolist() == [0.0, 1.5]
