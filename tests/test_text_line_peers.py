"""Generated codecs of an instrument with lines of text talk with pyvisa over a pseudo-terminal."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
import pyvisa

from layouts import TEST_SPECS, newest
from python_package import link_of, module_of
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


@pytest.mark.parametrize("text", ["W+0012.34", "W+0012,345,01,8001", "W 0012.345,01,8001", "W+0012.345,01,80f1"])
def test_what_is_no_canonical_line_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="unknown_value|incomplete|wrong_length"):
        LINES.decode_response(text.encode() + b"\r\n", WEIGHER.WeighRequest())
