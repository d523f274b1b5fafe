"""Frames are explained byte by byte, from the layout alone."""

from __future__ import annotations

import math
import struct
from decimal import Decimal
from typing import Literal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from explanation_rows import sent, shared_parts
from fieldspec.codec.explain.explanation import Explanation, ExplanationRow, explained
from fieldspec.codec.explain.values import decimal_text
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.checksums import checksum as checksum_of
from fieldspec.codec.reference.frames import Decoded
from fieldspec.language.model.escape import CAN_REMOTE
from fieldspec.language.model.raw_numbers import SinglePrecision
from fieldspec.language.model.texts import Example
from layouts import TEST_SPECS, all_layouts, newest

LAYOUTS = all_layouts()
EXAMPLES = [
    pytest.param(layout, example, id=f"{layout.device.id}@{layout.device.version}-{example.id}")
    for layout in LAYOUTS
    for example in layout.device.examples.values()
]
WIDGET, GIZMO, GLIDER = (newest(TEST_SPECS, device) for device in ("widget", "gizmo", "glider-x"))


def of_example(layout: DeviceLayout, example: Example, frame: bytes | None = None) -> Explanation:
    asked = layout.device.examples.get(example.reply_to)
    request = asked.frame if asked else b""
    data = example.frame if frame is None else frame
    return explained(layout, example.link, example.direction, data, example.message, request)


def of(name: str, layout: DeviceLayout = WIDGET) -> Explanation:
    return of_example(layout, layout.device.examples[name])


def row(explanation: Explanation, path: str) -> ExplanationRow:
    (match,) = [entry for entry in (*explanation.rows, *explanation.registers) if entry.path == path]
    return match


def same(left: object, other: object) -> bool:
    """Whether two values are equal, with not-a-number equal to itself."""
    if isinstance(left, dict) and isinstance(other, dict):
        return list(left) == list(other) and all(same(left[key], other[key]) for key in left)
    if isinstance(left, list) and isinstance(other, list):
        return len(left) == len(other) and all(map(same, left, other))
    if isinstance(left, float) and isinstance(other, float):
        return left == other or (math.isnan(left) and math.isnan(other))
    return type(left) is type(other) and left == other


def assert_agrees(layout: DeviceLayout, example: Example, frame: bytes) -> None:
    explanation = of_example(layout, example, frame)
    assert sent(explanation, shared_parts(layout, example.link, example.direction)) == frame
    decoded = decode(layout, example, frame)
    if isinstance(decoded, CodecError):
        assert decoded.reason in explanation.reasons
    else:
        assert explanation.reasons == ()
        # The reference keeps the bit of a remote request in the code, which a spec does not state.
        is_can = layout.links[example.link].link.is_can
        head = {name: number & ~CAN_REMOTE if is_can else number for name, number in decoded.head.items()}
        assert same(explanation.values, {**head, **decoded.values})
        assert explanation.error == decoded.error


def decode(layout: DeviceLayout, example: Example, frame: bytes) -> Decoded | CodecError:
    try:
        return codec(layout).links[example.link].decode(frame, example.direction, example.message)
    except CodecError as error:
        return error


def encode(layout: DeviceLayout, link: str, message: str, values: dict[str, object]) -> bytes:
    return codec(layout).links[link].encode("request", message, values)


def test_there_are_examples() -> None:
    assert len(EXAMPLES) > 100


@pytest.mark.proof(250)
@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_an_example_and_its_beginnings_and_what_trails_it_are_explained_as_the_reference_decodes_them(
    layout: DeviceLayout, example: Example
) -> None:
    assert_agrees(layout, example, example.frame)
    for length in range(len(example.frame)):
        assert_agrees(layout, example, example.frame[:length])
    for behind in (b"\0", b"0", example.frame):
        assert_agrees(layout, example, example.frame + behind)


def mended(layout: DeviceLayout, example: Example, frame: bytes) -> bytes:
    """A frame with the checksum of its bytes, if it has its delimiters and room for a checksum."""
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    try:
        data = codec(layout).links[example.link].parts(frame, example.direction)
    except CodecError:
        return frame
    if (checksum := shape.checksum) is None or len(data) < shape.header_size + shape.trailer_size:
        return frame
    at = checksum.at(len(data))
    order: Literal["big", "little"] = "big" if checksum.order == "big" else "little"
    number = checksum_of(checksum.algorithm, data[checksum.start : checksum.stop])
    data = data[:at] + number.to_bytes(checksum.size, order) + data[at + checksum.size :]
    inner = data if link.link.transmission == "binary" else data.hex().upper().encode()
    return shape.start + inner + shape.end


def test_characters_of_a_part_that_is_cut_off_by_others_have_a_row() -> None:
    layout, example = next(param.values for param in EXAMPLES if param.values[1].id == "words-write")
    assert_agrees(layout, example, example.frame[:3] + b"*" + example.frame[4:])


@settings(deadline=None)
@given(st.data())
def test_damaged_examples_are_explained_as_far_as_the_reference_takes_them(data: st.DataObject) -> None:
    # A number, as a failing test prints what it draws, and the text of a layout takes all memory.
    layout, example = EXAMPLES[data.draw(st.integers(0, len(EXAMPLES) - 1))].values
    frame = bytearray(example.frame)
    for _ in range(data.draw(st.integers(1, 3))):
        frame[data.draw(st.integers(0, len(frame) - 1))] = data.draw(st.integers(0, 255))
    assert_agrees(layout, example, bytes(frame))
    assert_agrees(layout, example, mended(layout, example, bytes(frame)))


@settings(deadline=None)
@given(st.sampled_from(LAYOUTS), st.binary(max_size=40), st.data())
def test_any_bytes_are_explained(layout: DeviceLayout, frame: bytes, data: st.DataObject) -> None:
    link = data.draw(st.sampled_from(sorted(layout.links)))
    direction = data.draw(st.sampled_from(["request", "response"]))
    message = data.draw(st.sampled_from(["", *layout.messages]))
    request = data.draw(st.binary(max_size=20))
    explanation = explained(layout, link, direction, frame, message, request)
    assert sent(explanation, shared_parts(layout, link, direction)) == frame


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ("20.00", "20.00"),
        ("-0.000001", "-0.000001"),
        ("0.0000001", "0.0000001"),
        ("50.0000000000000000000000000000", "50"),
        ("0.0061035156250000", "0.00610352"),
        ("24.99989997595548629760742187500", "24.9999"),
        ("-199.99999990686774253845214843750", "-199.9999999"),
        ("24.99999990686774253845214843750", "24.9999999"),
        ("1000000000", "1000000000"),
        ("0", "0"),
    ],
)
def test_a_number_is_exact_where_it_is_short_and_else_shows_that_it_is_rounded(number: str, text: str) -> None:
    assert decimal_text(Decimal(number), Decimal(1)) == text


def test_a_value_is_shown_raw_and_exactly_in_its_unit() -> None:
    field_row = row(of("nest-request"), "nest.origin.x")
    assert (field_row.number, field_row.value) == (-1000, "-100.0 mm")


def test_a_member_is_named_with_its_label() -> None:
    field_row = row(of("nest-request"), "nest.colors[0]")
    assert [(meaning.name, meaning.label) for meaning in field_row.meanings] == [("red", "红")]


def test_a_sentinel_is_named() -> None:
    field_row = row(of("nest-request"), "nest.color")
    assert (field_row.number, field_row.meanings[0].name, field_row.value) == (255, "unchanged", "")


def test_set_bits_and_fields_of_bits_are_named() -> None:
    field_row = row(of("nest-request"), "nest.words[1]")
    named = [(meaning.bits, meaning.name) for meaning in field_row.meanings]
    assert (field_row.number, named) == (0x8024, [("2", "brake"), ("4..5", "level=high"), ("15", "reserved_15")])


def test_bits_without_a_name_are_shown() -> None:
    field_row = row(explained(WIDGET, "packet", "response", bytes.fromhex("00 06 20 00 24 4A"), "stop"), "status")
    assert {meaning.bits: meaning.text for meaning in field_row.meanings} == {"2": "not listed", "5": "not listed"}


def test_offsets_of_characters_count_characters() -> None:
    field_row = row(of("read-request-ascii"), "word_count")
    assert (field_row.offset, field_row.length, field_row.characters, field_row.raw) == (9, 4, "0002", b"\0\2")


def test_a_right_checksum_is_called_right() -> None:
    assert row(of("read-request"), "crc").verdict == "right"


def test_a_wrong_checksum_is_shown_with_the_right_one() -> None:
    field_row = row(of("wrong-crc"), "crc")
    assert (field_row.verdict, field_row.reason) == ("wrong: should be C0 CB", "wrong_checksum")


def test_a_wrong_length_is_shown_with_the_right_one() -> None:
    field_row = row(of("wrong-length"), "length")
    assert (field_row.verdict, field_row.reason) == ("wrong: should be 6", "wrong_length")


def test_a_wrong_delimiter_is_shown_with_the_right_one() -> None:
    field_row = row(explained(WIDGET, "ascii", "request", b":010310000002EA\n\n"), "end")
    assert (field_row.verdict, field_row.reason) == ("wrong: should be 0D 0A", "wrong_mark")


def test_characters_that_are_not_hexadecimal_end_the_explanation() -> None:
    explanation = explained(WIDGET, "ascii", "request", b":0103xx000002EA\r\n")
    assert [(row.path, row.characters) for row in explanation.rows] == [
        ("start", ":"),
        ("station", "01"),
        ("function", "03"),
        ("", "xx000002EA"),
        ("end", "\r\n"),
    ]


def test_a_value_out_of_its_range_is_decoded_with_a_remark() -> None:
    explanation = explained(WIDGET, "packet", "request", bytes.fromhex("00 07 07 01 23 06 38"))
    assert (row(explanation, "count").verdict, explanation.reasons) == ("wrong: should be 0..5", ())


def test_a_unit_address_out_of_range_has_a_remark() -> None:
    field_row = row(explained(WIDGET, "packet", "request", bytes.fromhex("00 06 08 00 20 2E")), "receiver")
    assert field_row.verdict == "wrong: should be 0..7, 32..39"


def test_a_broadcast_is_named() -> None:
    assert row(of("write-to-all"), "station").meanings[0].name == "broadcast"


def test_an_exception_response_names_its_request() -> None:
    explanation = of("read-refused")
    assert (explanation.message, explanation.error) == ("read_registers", True)
    assert row(explanation, "function").number == 0x83
    assert row(explanation, "exception_code").meanings[0].name == "illegal_data_address"


def test_the_request_says_which_message_a_response_belongs_to() -> None:
    asked = WIDGET.device.examples["stop-request"].frame
    answer = WIDGET.device.examples["stop-response"].frame
    assert explained(WIDGET, "packet", "response", answer).reasons == ("unknown_code",)
    assert explained(WIDGET, "packet", "response", answer, request=asked).message == "stop"


def test_a_number_of_a_parameter_names_it_and_its_value_is_read_as_it() -> None:
    explanation = of("write-one-request")
    parameter = WIDGET.device.parameters["parameters"].numbered(2)
    assert parameter is not None
    assert row(explanation, "number").meanings[0].name == parameter.name
    assert row(explanation, "value").meanings[0].name == parameter.name
    assert row(explanation, "value").source == "; ".join(source.text() for source in parameter.sources)


def test_a_response_that_does_not_repeat_its_request_has_a_remark() -> None:
    asked = WIDGET.device.examples["write-request"].frame
    answer = bytes.fromhex("10 10 20 02 00 02 E8 89")
    explanation = explained(WIDGET, "rtu", "response", answer, request=asked)
    assert row(explanation, "address").verdict == "wrong: should be 8193"
    assert row(of("write-response"), "address").verdict == "right"


def test_a_read_request_names_the_registers_that_it_reads() -> None:
    rows = of("read-request").registers
    assert [(row.address, row.words, row.raw) for row in rows] == [(0x1000, 1, b""), (0x1001, 1, b"")]
    assert (rows[0].path, rows[0].source) == ("status_word", "7.1 L131")


def test_a_response_holds_the_registers_that_its_request_asks_for() -> None:
    explanation = of("read-response")
    assert [(row.address, row.raw) for row in explanation.registers] == [(0x1000, b"\x12\x34"), (0x1001, b"\xff\xff")]
    assert explanation.registers[0].offset == 3
    assert explained(WIDGET, "rtu", "response", explanation.frame).registers == ()


def test_the_bytes_of_registers_are_at_the_offsets_of_their_rows() -> None:
    explanations = [of_example(layout, example) for layout in LAYOUTS for example in layout.device.examples.values()]
    rows = [(explanation.frame, row) for explanation in explanations for row in explanation.registers if row.raw]
    assert len({row.offset for _, row in rows}) > 2
    for frame, row in rows:
        assert frame[row.offset : row.offset + row.length] == (row.characters.encode("ascii") or row.raw)


def test_registers_of_characters_are_found_among_the_characters() -> None:
    (first, _) = of("read-response-ascii").registers
    assert (first.offset, first.length, first.characters) == (7, 4, "1234")


def test_registers_of_a_table_are_named_by_element_and_field() -> None:
    request = encode(WIDGET, "rtu", "write_registers", {"station": 1, "address": 0x9020, "values": [1, 0, 250]})
    rows = explained(WIDGET, "rtu", "request", request).registers
    assert [(row.path, row.value) for row in rows] == [("points[2].mode", ""), ("points[2].position", "2.50 mm")]


def test_a_register_that_is_only_partly_in_a_frame_is_named_without_a_value() -> None:
    request = encode(GIZMO, "packet", "read", {"station": 1, "address": 2})
    (row,) = explained(GIZMO, "packet", "request", request).registers
    assert (row.path, row.number, row.notes) == ("place", None, ("The frame contains only some of its words.",))


def test_words_that_no_register_has_are_shown() -> None:
    request = encode(GIZMO, "packet", "read", {"station": 1, "address": 99})
    (row,) = explained(GIZMO, "packet", "request", request).registers
    assert (row.address, row.words, row.path) == (99, 1, "")


def test_errata_are_named_at_the_fact_that_they_concern() -> None:
    named = 0
    for layout in LAYOUTS:
        explained_ones = [of_example(layout, example) for example in layout.device.examples.values()]
        for erratum in layout.device.errata:
            touched = [(row, whole) for whole in explained_ones for row in whole.rows if row.fact == erratum.fact]
            named += len(touched)
            assert all(erratum.id in (*row.errata, *whole.errata) for row, whole in touched)
    assert named


def test_a_format_without_a_case_leaves_the_values_unexplained() -> None:
    explanation = explained(GLIDER, "channel", "response", bytes.fromhex("07 01 00 03 01 00 00"))
    last = explanation.rows[-1]
    assert (last.path, last.kind, last.raw) == ("values", "unexplained", b"\0\0")
    assert explanation.reasons == ("unknown_value", "unknown_value")


def test_elements_have_the_size_that_their_format_says() -> None:
    explanation = explained(GLIDER, "channel", "response", bytes.fromhex("07 01 00 04 02 FF FF FF FF 00 00 00 01"))
    assert [row.number for row in explanation.rows if row.path.startswith("values[")] == [-1, 1]


def test_two_frames_in_a_row_are_one_frame_of_wrong_length() -> None:
    frame = WIDGET.device.examples["stop-request"].frame
    explanation = explained(WIDGET, "packet", "request", frame + frame)
    assert explanation.message == "stop"
    assert explanation.reasons == ("wrong_length",)
    assert explanation.rows[-1].raw == frame


def test_registers_of_the_space_that_the_message_reads_are_explained() -> None:
    meter = newest(TEST_SPECS, "meter")
    assert [register.path for register in of("voltage", meter).registers] == ["voltage"]
    assert [register.path for register in of("station", meter).registers] == ["station"]
    contacts = [f"contact[{number}]" for number in range(1, 10)]
    assert [register.path for register in of("read-coils", meter).registers] == contacts


def test_a_float_is_judged_by_its_range_and_a_nan_is_named() -> None:
    probe = newest(TEST_SPECS, "probe")
    absent = row(explained(probe, "packet", "request", bytes.fromhex("01 00 00 C0 7F 40")), "limit")
    assert (absent.value, absent.verdict, [meaning.name for meaning in absent.meanings]) == ("", "", ["no_limit"])
    beyond = row(explained(probe, "packet", "request", bytes.fromhex("01 00 80 96 43 5A")), "limit")
    assert (beyond.value, beyond.verdict) == ("301.0 mm", "wrong: should be 0..300 mm")


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("50.02", 50.02),
        ("-0.1", -0.1),
        ("123456.79", 123456.789),
        ("25.0", 25.0),
        ("1e-45", 2.0**-149),
        ("3.4028235e+38", (2 - 2**-23) * 2.0**127),
        ("-0.0", -0.0),
        ("nan", math.nan),
        ("-inf", -math.inf),
    ],
)
def test_a_number_of_four_bytes_is_shown_with_the_fewest_digits_that_lead_to_them(text: str, number: float) -> None:
    (nearest,) = struct.unpack("f", struct.pack("f", number))
    assert f"{SinglePrecision(nearest)}" == text


@given(st.floats(width=32, allow_nan=False))
def test_the_digits_of_a_number_of_four_bytes_lead_to_these_bytes(number: float) -> None:
    assert struct.pack("f", float(str(SinglePrecision(number)))) == struct.pack("f", number)
