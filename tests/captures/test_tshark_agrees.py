"""tshark, with its own dissector of Modbus, sees in captures what bulk decoding writes into the tables."""

from __future__ import annotations

import random
import struct
import subprocess
from pathlib import Path
from typing import Any

from bounded import HANGING
from captures.conversations import Segment, ethernet, pcap
from captures.test_decode_in_bulk import decode
from external_tools import require_tool

FIELDS = (
    "frame.number", "mbtcp.trans_id", "mbtcp.unit_id", "modbus.func_code", "modbus.exception_code",
    "modbus.reference_num", "modbus.word_cnt", "modbus.regnum16", "modbus.regval_uint16", "modbus.response_time",
    "modbus.request_frame",
)  # fmt: skip


def conversation(chance: random.Random, count: int) -> list[Segment]:
    """Reads and writes of random places, with exceptions, answers that lack, and several frames in one segment."""
    segments: list[Segment] = []
    at = {True: 100, False: 200}

    def send(is_request: bool, data: bytes) -> None:
        segments.append(Segment(is_request, at[is_request], data))
        at[is_request] += len(data)

    for number in range(1, count + 1):
        address, words = chance.randrange(12), chance.randrange(1, 6)
        content = chance.randbytes(2 * words)
        code = chance.choice((3, 4, 4, 16))
        if code == 16:
            body = struct.pack(">BHHB", code, address, words, 2 * words) + content
            answer = struct.pack(">BHH", code, address, words)
        else:
            body, answer = struct.pack(">BHH", code, address, words), bytes([code, 2 * words]) + content
        kind = chance.random()
        answer = bytes([code | 0x80, chance.choice((1, 2, 3))]) if kind < 0.1 else answer
        send(True, struct.pack(">HHHB", number, 0, 1 + len(body), 7) + body)
        if kind < 0.95:
            send(False, struct.pack(">HHHB", number, 0, 1 + len(answer), 7) + answer)
    return segments


def dissected(path: Path) -> list[dict[str, list[str]]]:
    """The fields of each packet, as tshark prints them."""
    options = [option for field in FIELDS for option in ("-e", field)]
    command = [require_tool("tshark"), "-n", "-r", str(path), "-T", "fields", "-E", "separator=;", *options]
    text = subprocess.run(command, capture_output=True, text=True, check=True, timeout=HANGING).stdout
    return [
        dict(zip(FIELDS, (cell.split(",") if cell else [] for cell in line.split(";")), strict=True))
        for line in text.splitlines()
    ]


def test_tshark_sees_the_same_requests_answers_exceptions_and_words(tmp_path: Path) -> None:
    segments = conversation(random.Random(5), 400)
    content = pcap(map(ethernet, segments))
    _, _, frames, values = decode(tmp_path, content)
    own = dissected(tmp_path / "input")
    assert len(frames) == len(own) == len(segments)
    packets = {frame["frame"]: frame["packet"] for frame in frames}
    words = words_of(values)
    for frame, theirs in zip(frames, own, strict=True):
        assert theirs["frame.number"] == [str(frame["packet"])]
        assert theirs["mbtcp.unit_id"] == [str(frame["unit_address"])]
        exception = {"illegal_function": "1", "illegal_data_address": "2", "illegal_data_value": "3"}
        assert theirs["modbus.exception_code"] == ([exception[frame["exception"]]] if frame["exception"] else [])
        if frame["direction"] == "request":
            assert theirs["modbus.reference_num"] == [str(frame["address"])]
            assert theirs["modbus.word_cnt"] == [str(frame["count"])]
        elif not frame["exception"]:  # which tshark pairs with nothing
            assert theirs["modbus.request_frame"] == [str(packets[frame["request"]])]
            assert float(theirs["modbus.response_time"][0]) == frame["delay"] / 1e9
        if theirs["modbus.regval_uint16"] and frame["data"]:
            registers = [int(number) for number in theirs["modbus.regval_uint16"]]
            assert registers == list(struct.unpack(f">{len(registers)}H", frame["data"]))
        for address, word in words.get(frame["frame"], {}).items():
            place = theirs["modbus.regnum16"].index(str(address))
            assert theirs["modbus.regval_uint16"][place] == str(word)


def words_of(values: list[dict[str, Any]]) -> dict[int, dict[int, int]]:
    """By frame and address: the words of values that have a single one."""
    words: dict[int, dict[int, int]] = {}
    for value in values:
        if value["raw"] is not None and value["address"] is not None:
            words.setdefault(value["frame"], {})[value["address"]] = value["raw"] % 0x10000
    return words
