"""Generated codecs of an instrument with lines of text talk with pyvisa over a pseudo-terminal."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from typing import Any

import pytest
import pyvisa

from fieldspec.codec.reference import CodecError, codec
from fieldspec.testing import simulation
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of
from serial_lines import SECONDS, Line, serial_line

WEIGHER = module_of(newest(TEST_SPECS, "weigher"))
LINES = link_of(WEIGHER, "lines")


def answer(frame: bytes, limits: dict[int, int], weight: int) -> bytes:
    """What an instrument with a weight on it, in grams, answers to a request."""
    match LINES.decode_request(frame).message:
        case WEIGHER.WeighRequest():
            response: Any = WEIGHER.WeighResponse(weight, WEIGHER.Stability.STABLE, WEIGHER.Lamps(0x8001))
        case WEIGHER.SetLimitRequest() as asked:
            limits[asked.number] = asked.limit
            response = WEIGHER.SetLimitResponse(asked.number)
        case WEIGHER.MeasureRequest() as asked:
            state, lamps = WEIGHER.Stability.STABLE, WEIGHER.Lamps(0)
            response = WEIGHER.MeasureResponse(weight, -asked.channel, "T\xfcr", state, lamps)
        case WEIGHER.ReadLabelsRequest() as asked:
            response = WEIGHER.ReadLabelsResponse(f"W\xe4ger {asked.key}", "A\U0001f600", ["\xe4", ""])
        case _:
            point = WEIGHER.Checkpoint(250)
            response = WEIGHER.ReadCountersResponse(10**18 - 1, -2, [point, point], [2024])
    data = LINES.encode_response(response)
    assert isinstance(data, bytes)
    return data


@contextmanager
def instrument(limits: dict[int, int], weight: int) -> Iterator[Any]:
    """An instrument on a line, as pyvisa sees it."""
    ended = threading.Event()

    def serve(line: Line) -> None:
        framer = LINES.request_framer()
        while not ended.is_set():
            for frame in framer.feed(line.receive(0.02)):
                line.send(answer(frame, limits, weight))

    with serial_line() as (near, path):
        thread = threading.Thread(target=serve, args=(Line(near),), daemon=True)
        thread.start()
        manager = pyvisa.ResourceManager("@py")
        try:
            opened: Any = manager.open_resource(f"ASRL{path}::INSTR")
            opened.read_termination = opened.write_termination = "\r\n"
            opened.timeout = 1000 * SECONDS
            yield opened
        finally:
            manager.close()
            ended.set()
            thread.join(SECONDS)


def test_pyvisa_reads_the_numbers_that_the_generated_codec_sends() -> None:
    limits: dict[int, int] = {}
    with instrument(limits, -12345) as opened:
        weight, state, lamps = opened.query("W").removeprefix("W").split(",")
        assert (float(weight), int(state), int(lamps, 16)) == (-12.345, 1, 0x8001)
        assert opened.query_ascii_values("W", converter=lambda text: float(text.lstrip("W")))[:2] == [-12.345, 1.0]
        assert opened.query("LB,00012500TOP\0\0\0") == "LB"
        assert limits == {11: 12500}
        counters = opened.query("C")
        assert counters.startswith("C" + "9" * 18 + "fffe,0250,0250")


def test_pyvisa_reads_the_texts_that_the_generated_codec_sends() -> None:
    with instrument({}, 0) as opened:
        opened.write("T  Nr 7", encoding="ascii")
        data = opened.read_raw()
        title, user, places = data[1:13], data[13:25], (data[25:30], data[30:35])
        assert title.decode("latin-1").rstrip(" ") == "W\xe4ger Nr 7"
        assert user.decode("utf-16-le").partition("\0")[0] == "A\U0001f600"
        assert [place.decode("utf-8").partition(";")[0] for place in places] == ["\xe4", ""]
        assert data[35:] == b"\r\n"


@pytest.mark.parametrize("weight", [0, 5, -5, 100, -12345, 999999, 99999999])
def test_pyvisa_reads_the_lines_of_changing_width_that_the_generated_codec_sends(weight: int) -> None:
    with instrument({}, weight) as opened:
        opened.write("M7")
        line, _, rest = opened.read(encoding="utf-8").removeprefix("M").partition(";")
        number, drift, title = line.split(",")
        assert (Decimal(number), int(drift), title, rest) == (Decimal(weight).scaleb(-2), -7, "T\xfcr", "010")
        assert number == str(Decimal(weight).scaleb(-2))


def test_pyvisa_reads_and_writes_the_parameters_of_a_simulated_device_as_text() -> None:
    with simulation("weigher", ports={"lines": "pty"}, folder=str(TEST_SPECS)) as device:
        manager = pyvisa.ResourceManager("@py")
        opened: Any = manager.open_resource(f"ASRL{device.places['lines']}::INSTR")
        opened.read_termination = opened.write_termination = "\r\n"
        opened.timeout = 1000 * SECONDS
        assert opened.query("P1") == "P1=30000"
        assert opened.query("Q2=-0120") == "Q2"
        assert opened.query("P0002") == "P2=-120"
        assert device.value("parameters/settings/zero_offset") == -120
        device.set(**{"parameters/settings/zero_offset": 4999})
        assert opened.query("P2").partition("=")[2] == "4999"
        manager.close()


NUMBERS = {
    "12.5": 1250,
    "+012.50": 1250,
    "12": 1200,
    "-0.4": -40,
    "-0.00": 0,
    "+9": 900,
    "000012.05": 1205,
    "999999.99": 99999999,
    "-12345.67": -1234567,
}
"""How a weight may be sent, and its count."""


@pytest.mark.parametrize("text", NUMBERS)
def test_numbers_are_read_as_decimal_reads_them(text: str) -> None:
    frame = f"M{text},7,;010\r\n".encode()
    read = LINES.decode_response(frame, WEIGHER.MeasureRequest(1)).message
    assert read.weight == NUMBERS[text] == Decimal(text).scaleb(2)
    expected = codec(newest(TEST_SPECS, "weigher")).links["lines"].decode(frame, "response", "measure")
    assert expected.values["weight"] == read.weight


REFUSED_LINES = {
    "M12.,7,;010": 1,
    "M.5,7,;010": 1,
    "M12.505,7,;010": 1,
    "M 12,7,;010": 1,
    "M--1,7,;010": 1,
    "M1e3,7,;010": 1,
    "M,7,;010": 1,
    "M1000000.00,7,;010": 1,
    "M-123456.78,7,;010": 1,
    "M1234567,7,;010": 1,
    "M1,7.0,;010": 3,
    "M1,7,123456789;010": 5,
    "M1,7,A\0;010": 5,
    "M1,7,;01F": 8,
    "M1,7,;01": 8,
    "M1,7,;500": 6,
    "M1,7": 4,
    "M1": 2,
}
"""Lines that are refused, and the byte that is wrong."""


@pytest.mark.parametrize("text", REFUSED_LINES)
def test_a_line_of_another_form_is_refused_at_its_value(text: str) -> None:
    frame = text.encode() + b"\r\n"
    with pytest.raises(codec_error()) as refused:
        LINES.decode_response(frame, WEIGHER.MeasureRequest(1))
    with pytest.raises(CodecError) as expected:
        codec(newest(TEST_SPECS, "weigher")).links["lines"].decode(frame, "response", "measure")
    place = refused.value.reason, refused.value.offset
    assert place == (expected.value.reason, expected.value.offset)
    assert place[1] == REFUSED_LINES[text]


REFUSED_LABELS = {
    "end_missing": (13, b"T" + b"A".ljust(12) + "ABCDEF".encode("utf-16-le") + b"a;   b;   "),
    "half_a_character": (13, b"T" + b"A".ljust(12) + b"\x00\xd8A\0\0\0".ljust(12, b"\0") + b"a;   b;   "),
    "zero_in_the_text": (1, b"T" + b"A\0B".ljust(12) + bytes(12) + b"a;   b;   "),
    "overlong_character": (30, b"T" + b"A".ljust(12) + bytes(12) + b"a;   \xc0\x80;  "),
}
"""Texts that nobody can send, and the byte at which they are refused."""


@pytest.mark.parametrize("name", REFUSED_LABELS)
def test_bytes_that_are_no_text_are_refused_where_the_text_begins(name: str) -> None:
    at, content = REFUSED_LABELS[name]
    frame = content + b"\r\n"
    with pytest.raises(codec_error()) as refused:
        LINES.decode_response(frame, WEIGHER.ReadLabelsRequest("A"))
    with pytest.raises(CodecError) as expected:
        codec(newest(TEST_SPECS, "weigher")).links["lines"].decode(frame, "response", "read_labels")
    assert (refused.value.reason, refused.value.offset) == ("unknown_value", at)
    assert (expected.value.reason, expected.value.offset) == ("unknown_value", at)


@pytest.mark.parametrize("key", ["A\xe4", " A", "A\0", "ABCDEFG"])
def test_texts_that_would_be_read_as_others_are_not_sent(key: str) -> None:
    with pytest.raises(codec_error()):
        LINES.encode_request(WEIGHER.ReadLabelsRequest(key))


OTHER_LINES = {
    "W+0012,345,01,8001": 1,
    "W 0012.345,01,8001": 1,
    "W+012.3450,01,8001": 1,
    "W+0012.345, 1,8001": 11,
    "W+0012.345,01,80f1": 14,
}
"""Lines in another form than the device's, and the byte at which they are refused."""


@pytest.mark.parametrize("text", OTHER_LINES)
def test_a_line_in_another_form_is_refused_where_the_number_begins(text: str) -> None:
    frame = text.encode() + b"\r\n"
    with pytest.raises(codec_error()) as refused:
        LINES.decode_response(frame, WEIGHER.WeighRequest())
    with pytest.raises(CodecError) as expected:
        codec(newest(TEST_SPECS, "weigher")).links["lines"].decode(frame, "response", "weigh")
    assert (refused.value.reason, refused.value.offset) == ("unknown_value", OTHER_LINES[text])
    assert (expected.value.reason, expected.value.offset) == ("unknown_value", OTHER_LINES[text])
