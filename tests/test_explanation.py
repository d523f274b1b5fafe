"""Frames are explained byte by byte, from the layout alone."""

from __future__ import annotations

import math
from decimal import Decimal
from typing import Literal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fieldspec.explain.explanation import Explanation, ExplanationRow, closest, explained, recognised
from fieldspec.explain.values import decimal_text
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.texts import Example
from fieldspec.reference import CodecError, codec
from fieldspec.reference.frames import ALGORITHMS, Decoded
from laid_out import MADE_UP, all_layouts, newest

LAYOUTS = all_layouts()
EXAMPLES = [
    pytest.param(laid, example, id=f"{laid.device.id}@{laid.device.version}-{example.id}")
    for laid in LAYOUTS
    for example in laid.device.examples.values()
]
WIDGET = newest(MADE_UP, "widget")
GIZMO = newest(MADE_UP, "gizmo")
GLIDER = newest(MADE_UP, "glider-x")


def of_example(laid: DeviceLayout, example: Example, frame: bytes | None = None) -> Explanation:
    asked = laid.device.examples.get(example.reply_to)
    request = asked.frame if asked else b""
    held = example.frame if frame is None else frame
    return explained(laid, example.link, example.direction, held, example.message, request)


def of(name: str, laid: DeviceLayout = WIDGET) -> Explanation:
    return of_example(laid, laid.device.examples[name])


def row(found: Explanation, path: str) -> ExplanationRow:
    (one,) = [held for held in (*found.rows, *found.registers) if held.path == path]
    return one


def sent(found: Explanation) -> bytes:
    """The bytes of all rows, as they are sent, where each row starts at the end of the one before it."""
    data = b""
    for one in found.rows:
        assert one.offset == len(data)
        data += one.characters.encode("latin-1") or one.raw
        assert one.offset + one.length == len(data)
    return data


def same(one: object, other: object) -> bool:
    """Equal, where not-a-number equals itself."""
    if isinstance(one, dict) and isinstance(other, dict):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, float) and isinstance(other, float) and math.isnan(one):
        return math.isnan(other)
    return type(one) is type(other) and one == other


def assert_agrees(laid: DeviceLayout, example: Example, frame: bytes) -> None:
    found = of_example(laid, example, frame)
    assert sent(found) == frame
    decoded = decode(laid, example, frame)
    if isinstance(decoded, CodecError):
        assert decoded.reason in found.reasons
    else:
        assert found.reasons == ()
        assert same(found.values, {**decoded.head, **decoded.values})
        assert found.error == decoded.error


def decode(laid: DeviceLayout, example: Example, frame: bytes) -> Decoded | CodecError:
    try:
        return codec(laid).links[example.link].decode(frame, example.direction, example.message)
    except CodecError as error:
        return error


def encode(laid: DeviceLayout, link: str, message: str, values: dict[str, object]) -> bytes:
    return codec(laid).links[link].encode("request", message, values)


def test_there_are_examples() -> None:
    assert len(EXAMPLES) > 100


@pytest.mark.parametrize(("laid", "example"), EXAMPLES)
def test_every_example_is_explained_as_the_reference_decodes_it(laid: DeviceLayout, example: Example) -> None:
    assert_agrees(laid, example, example.frame)


@pytest.mark.parametrize(("laid", "example"), EXAMPLES)
def test_every_beginning_of_an_example_is_explained(laid: DeviceLayout, example: Example) -> None:
    for length in range(len(example.frame)):
        assert_agrees(laid, example, example.frame[:length])


@pytest.mark.parametrize(("laid", "example"), EXAMPLES)
def test_examples_with_bytes_behind_them_are_explained(laid: DeviceLayout, example: Example) -> None:
    for behind in (b"\0", b"0", example.frame):
        assert_agrees(laid, example, example.frame + behind)


def mended(laid: DeviceLayout, example: Example, frame: bytes) -> bytes:
    """A frame with the check that its bytes ask for, where it has marks and room for one."""
    link = laid.links[example.link]
    check = link.frame(example.direction).checksum
    try:
        data = codec(laid).links[example.link].parts(frame)
    except CodecError:
        return frame
    shape = link.frame(example.direction)
    if check is None or len(data) < shape.head_size + shape.tail_size:
        return frame
    at = check.at(len(data))
    order: Literal["big", "little"] = "big" if check.order == "big" else "little"
    number = ALGORITHMS[check.algorithm](data[check.start : check.stop])
    data = data[:at] + number.to_bytes(check.size, order) + data[at + check.size :]
    inner = data if link.link.encoding == "binary" else data.hex().upper().encode()
    return link.link.start + inner + link.link.end


def test_characters_of_a_part_that_is_cut_off_by_others_have_a_row() -> None:
    laid, example = next(param.values for param in EXAMPLES if param.values[1].id == "words-write")
    assert_agrees(laid, example, example.frame[:3] + b"*" + example.frame[4:])


@settings(deadline=None)
@given(st.data())
def test_damaged_examples_are_explained_as_far_as_the_reference_takes_them(data: st.DataObject) -> None:
    # A number, as a failing test prints what it draws, and the text of a layout takes all memory.
    laid, example = EXAMPLES[data.draw(st.integers(0, len(EXAMPLES) - 1))].values
    frame = bytearray(example.frame)
    for _ in range(data.draw(st.integers(1, 3))):
        frame[data.draw(st.integers(0, len(frame) - 1))] = data.draw(st.integers(0, 255))
    assert_agrees(laid, example, bytes(frame))
    assert_agrees(laid, example, mended(laid, example, bytes(frame)))


@settings(deadline=None)
@given(st.sampled_from(LAYOUTS), st.binary(max_size=40), st.data())
def test_any_bytes_are_explained(laid: DeviceLayout, frame: bytes, data: st.DataObject) -> None:
    link = data.draw(st.sampled_from(sorted(laid.links)))
    direction = data.draw(st.sampled_from(["request", "response"]))
    message = data.draw(st.sampled_from(["", *laid.messages]))
    request = data.draw(st.binary(max_size=20))
    assert sent(explained(laid, link, direction, frame, message, request)) == frame


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
    assert decimal_text(Decimal(number)) == text


def test_a_value_is_given_raw_and_exactly_in_its_unit() -> None:
    found = row(of("nest-request"), "nest.origin.x")
    assert (found.number, found.value) == (-1000, "-100.0 mm")


def test_a_member_is_named_with_its_label() -> None:
    found = row(of("nest-request"), "nest.colors[0]")
    assert [(meaning.name, meaning.label) for meaning in found.meanings] == [("red", "红")]


def test_a_sentinel_is_named() -> None:
    found = row(of("nest-request"), "nest.color")
    assert (found.number, found.meanings[0].name, found.value) == (255, "unchanged", "")


def test_set_bits_and_fields_of_bits_are_named() -> None:
    found = row(of("nest-request"), "nest.words[1]")
    named = [(meaning.bits, meaning.name) for meaning in found.meanings]
    assert (found.number, named) == (0x8024, [("2", "brake"), ("4..5", "level=high"), ("15", "reserved_15")])


def test_bits_without_a_name_are_not_passed_over() -> None:
    found = row(explained(WIDGET, "packet", "response", bytes.fromhex("00 06 20 00 24 4A"), "stop"), "status")
    assert [(meaning.bits, meaning.text) for meaning in found.meanings] == [("2", "not listed"), ("5", "not listed")]


def test_offsets_of_characters_count_characters() -> None:
    found = row(of("read-request-ascii"), "word_count")
    assert (found.offset, found.length, found.characters, found.raw) == (9, 4, "0002", b"\0\2")


def test_a_right_check_is_called_right() -> None:
    assert row(of("read-request"), "crc").verdict == "right"


def test_a_wrong_check_says_what_it_should_be() -> None:
    found = row(of("wrong-crc"), "crc")
    assert (found.verdict, found.reason) == ("wrong: should be C0 CB", "wrong_check")


def test_a_wrong_length_says_what_it_should_be() -> None:
    found = row(of("wrong-length"), "length")
    assert (found.verdict, found.reason) == ("wrong: should be 6", "wrong_length")


def test_a_wrong_mark_says_what_it_should_be() -> None:
    found = row(explained(WIDGET, "ascii", "request", b":010310000002EA\n\n"), "end")
    assert (found.verdict, found.reason) == ("wrong: should be 0D 0A", "wrong_mark")


def test_characters_that_are_not_hexadecimal_end_the_explanation() -> None:
    found = explained(WIDGET, "ascii", "request", b":0103xx000002EA\r\n")
    assert [(one.path, one.characters) for one in found.rows] == [
        ("start", ":"),
        ("station", "01"),
        ("function", "03"),
        ("", "xx000002EA"),
        ("end", "\r\n"),
    ]


def test_a_value_out_of_its_range_is_pointed_out_and_taken() -> None:
    found = explained(WIDGET, "packet", "request", bytes.fromhex("00 07 07 01 23 06 38"))
    assert (row(found, "count").verdict, found.reasons) == ("wrong: should be 0..5", ())


def test_a_station_out_of_range_is_pointed_out() -> None:
    found = row(explained(WIDGET, "packet", "request", bytes.fromhex("00 06 08 00 20 2E")), "address")
    assert found.verdict == "wrong: should be 0..7, 32..39"


def test_a_broadcast_is_named() -> None:
    assert row(of("write-to-all"), "station").meanings[0].name == "broadcast"


def test_a_refusal_names_the_request_that_is_refused() -> None:
    found = of("read-refused")
    assert (found.message, found.error, row(found, "function").number) == ("read_registers", True, 0x83)
    assert row(found, "exception_code").meanings[0].name == "illegal_data_address"


def test_the_request_says_which_message_a_response_belongs_to() -> None:
    asked = WIDGET.device.examples["stop-request"].frame
    answer = WIDGET.device.examples["stop-response"].frame
    assert explained(WIDGET, "packet", "response", answer).reasons == ("unknown_code",)
    assert explained(WIDGET, "packet", "response", answer, request=asked).message == "stop"


def test_a_number_of_a_parameter_names_it_and_its_value_is_read_as_it() -> None:
    found = of("write-one-request")
    parameter = WIDGET.device.parameters["parameters"].numbered(2)
    assert parameter is not None
    assert row(found, "number").meanings[0].name == parameter.name
    assert row(found, "value").meanings[0].name == parameter.name
    assert row(found, "value").source == "; ".join(source.text() for source in parameter.sources)


def test_a_response_that_does_not_repeat_its_request_is_pointed_out() -> None:
    asked = WIDGET.device.examples["write-request"].frame
    answer = bytes.fromhex("10 10 20 02 00 02 E8 89")
    found = explained(WIDGET, "rtu", "response", answer, request=asked)
    assert row(found, "address").verdict == "wrong: should be 8193"
    assert row(of("write-response"), "address").verdict == "right"


def test_a_read_request_names_the_registers_that_it_reads() -> None:
    found = of("read-request").registers
    assert [(one.address, one.words, one.raw) for one in found] == [(0x1000, 1, b""), (0x1001, 1, b"")]
    assert (found[0].path, found[0].source) == ("status_word", "7.1 L131")


def test_a_response_holds_the_registers_that_its_request_asks_for() -> None:
    found = of("read-response")
    assert [(one.address, one.raw) for one in found.registers] == [(0x1000, b"\x12\x34"), (0x1001, b"\xff\xff")]
    assert found.registers[0].offset == 3
    assert explained(WIDGET, "rtu", "response", found.frame).registers == ()


def test_the_bytes_of_registers_lie_where_their_rows_say() -> None:
    found = [of_example(laid, example) for laid in LAYOUTS for example in laid.device.examples.values()]
    held = [(one.frame, row) for one in found for row in one.registers if row.raw]
    assert len({row.offset for _, row in held}) > 2
    for frame, row in held:
        assert frame[row.offset : row.offset + row.length] == (row.characters.encode("ascii") or row.raw)


def test_registers_of_characters_are_found_among_the_characters() -> None:
    (first, _) = of("read-response-ascii").registers
    assert (first.offset, first.length, first.characters) == (7, 4, "1234")


def test_registers_of_a_table_are_named_by_element_and_field() -> None:
    request = encode(WIDGET, "rtu", "write_registers", {"station": 1, "address": 0x9020, "values": [1, 0, 250]})
    found = explained(WIDGET, "rtu", "request", request).registers
    assert [(one.path, one.value) for one in found] == [("points[2].mode", ""), ("points[2].position", "2.50 mm")]


def test_a_register_of_which_a_frame_holds_a_part_is_named_without_a_value() -> None:
    request = encode(GIZMO, "packet", "read", {"station": 1, "address": 2})
    (one,) = explained(GIZMO, "packet", "request", request).registers
    assert (one.path, one.number, one.notes) == ("place", None, ("The frame contains only some of its words.",))


def test_words_that_no_register_has_are_shown() -> None:
    request = encode(GIZMO, "packet", "read", {"station": 1, "address": 99})
    (one,) = explained(GIZMO, "packet", "request", request).registers
    assert (one.address, one.words, one.path) == (99, 1, "")


def test_errata_are_named_at_the_fact_that_they_touch() -> None:
    named = 0
    for laid in LAYOUTS:
        explained_ones = [of_example(laid, example) for example in laid.device.examples.values()]
        for erratum in laid.device.errata:
            touched = [(one, whole) for whole in explained_ones for one in whole.rows if one.fact == erratum.fact]
            named += len(touched)
            assert all(erratum.id in (*one.errata, *whole.errata) for one, whole in touched)
    assert named


@pytest.mark.parametrize(("laid", "example"), [one for one in EXAMPLES if not one.values[1].refused])
def test_every_example_is_recognised(laid: DeviceLayout, example: Example) -> None:
    found = recognised(laid, example.frame)
    assert (example.link, example.direction, example.message, example.exception_response) in found


def test_a_frame_that_is_equal_in_both_directions_is_ambiguous() -> None:
    frame = bytes.fromhex("00 06 20 00 00 05 43 D8")
    assert recognised(WIDGET, frame) == [
        ("rtu", "request", "write_register", False),
        ("rtu", "response", "write_register", False),
    ]


def test_a_frame_with_a_wrong_check_is_not_recognised_but_closest_to_what_it_was() -> None:
    frame = WIDGET.device.examples["wrong-crc"].frame
    assert recognised(WIDGET, frame) == []
    assert closest(WIDGET, frame) == [("rtu", "request", "read_registers", False)]


def test_bytes_that_are_no_frame_are_not_recognised() -> None:
    assert recognised(WIDGET, b"") == []
    assert closest(WIDGET, b"no frame at all") == []


def test_a_format_without_a_case_leaves_the_values_unexplained() -> None:
    found = explained(GLIDER, "channel", "response", bytes.fromhex("07 01 00 03 01 00 00"))
    assert (found.rows[-1].path, found.rows[-1].kind, found.rows[-1].raw) == ("values", "unexplained", b"\0\0")
    assert found.reasons == ("unknown_value", "unknown_value")


def test_elements_have_the_size_that_their_format_says() -> None:
    found = explained(GLIDER, "channel", "response", bytes.fromhex("07 01 00 04 02 FF FF FF FF 00 00 00 01"))
    assert [one.number for one in found.rows if one.path.startswith("values[")] == [-1, 1]


def test_two_frames_in_a_row_are_told_apart_by_length_and_check() -> None:
    frame = WIDGET.device.examples["stop-request"].frame
    found = explained(WIDGET, "packet", "request", frame + frame)
    assert found.message == "stop"
    assert found.reasons == ("wrong_length",)
    assert found.rows[-1].raw == frame


def test_registers_of_the_space_that_the_message_reads_are_explained() -> None:
    meter = newest(MADE_UP, "meter")
    assert [held.path for held in of("voltage", meter).registers] == ["voltage"]
    assert [held.path for held in of("station", meter).registers] == ["station"]
    assert of("read-coils", meter).registers == ()


def test_a_float_is_judged_by_its_range_and_a_nan_is_named() -> None:
    probe = newest(MADE_UP, "probe")
    absent = row(explained(probe, "packet", "request", bytes.fromhex("01 00 00 C0 7F 40")), "limit")
    assert (absent.value, absent.verdict, [one.name for one in absent.meanings]) == ("", "", ["no_limit"])
    beyond = row(explained(probe, "packet", "request", bytes.fromhex("01 00 80 96 43 5A")), "limit")
    assert (beyond.value, beyond.verdict) == ("301.0 mm", "wrong: should be 0..300 mm")
