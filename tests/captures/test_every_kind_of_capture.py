"""Captures of every kind have the frames and values that were put into them, and those that tshark sees in them."""

from __future__ import annotations

import random
import struct
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import pytest

from bounded import HANGING
from captures.network_captures import (
    FORMS,
    NETWORKS,
    PORT,
    REGISTERS,
    UNIT,
    Exchange,
    Segment,
    capture,
    connection,
    exchanges,
    late,
    out_of_order,
    overlapping,
    sent_again,
    turns,
)
from captures.test_decode_in_bulk import decode
from external_tools import require_tool

COUNT = 120
EXCEPTIONS = {1: "illegal_function", 2: "illegal_data_address", 3: "illegal_data_value"}


class Frame(NamedTuple):
    """What a frame says. An answer has the address and the count where it prints them."""

    is_request: bool
    transaction: int
    unit: int
    code: int
    exception: int
    address: int | None
    count: int | None
    words: tuple[int, ...]


def truth(talk: Sequence[Exchange]) -> set[Frame]:
    """The frames of exchanges."""
    result = set()
    for exchange in talk:
        words = struct.unpack(f">{2 * len(exchange.floats)}H", exchange.content)
        is_write = exchange.code == 16
        head = (exchange.transaction, UNIT, exchange.code)
        place = (exchange.address, len(words))
        result.add(Frame(True, *head, 0, *place, words if is_write else ()))
        if exchange.exception:
            result.add(Frame(False, *head, exchange.exception, None, None, ()))
        else:
            result.add(Frame(False, *head, 0, *(place if is_write else (None, None)), () if is_write else words))
    return result


def own_frames(frames: Sequence[dict[str, Any]]) -> set[Frame]:
    """The frames of the table."""
    numbers = {name: number for number, name in EXCEPTIONS.items()}
    result = set()
    for frame in frames:
        data = frame["bytes"]
        code, exception = data[7] & 0x7F, numbers.get(frame["exception"], 0)
        words = struct.unpack(f">{len(frame['data']) // 2}H", frame["data"]) if frame["data"] else ()
        is_request = frame["direction"] == "request"
        place = (frame["address"], frame["count"]) if is_request or (code == 16 and not exception) else (None, None)
        is_content = is_request == (code == 16)
        result.add(
            Frame(
                is_request, struct.unpack(">H", data[:2])[0], frame["unit_address"], code, exception, *place,
                words if is_content else (),
            )
        )  # fmt: skip
    return result


Value = tuple[int, str, float | str]


def own_values(frames: Sequence[dict[str, Any]], values: Sequence[dict[str, Any]]) -> set[Value]:
    """Transactions, registers and values."""
    transactions = {frame["frame"]: struct.unpack(">H", frame["bytes"][:2])[0] for frame in frames}
    return {
        (transactions[value["frame"]], value["register"], value["text"] if value["value"] is None else value["value"])
        for value in values
    }


def true_values(talk: Sequence[Exchange]) -> set[Value]:
    """The same of the exchanges."""
    result: set[Value] = set()
    for exchange in talk:
        if exchange.exception:
            result.add((exchange.transaction, "exception.exception_code", EXCEPTIONS[exchange.exception]))
        for number, value in enumerate(exchange.floats if not exchange.exception else ()):
            name = "ratio" if exchange.code == 16 else REGISTERS[exchange.address // 2 + number]
            result.add((exchange.transaction, name, value))
    return result


def dissected(path: Path) -> set[Frame]:
    """The frames that tshark sees."""
    options = ["-o", "tcp.reassemble_out_of_order:TRUE", "-T", "pdml", "-J", "tcp mbtcp modbus"]
    command = [require_tool("tshark"), "-n", "-2", "-r", str(path), *options]
    text = subprocess.run(command, capture_output=True, check=True, timeout=HANGING).stdout
    result = set()
    for packet in ElementTree.fromstring(text).iter("packet"):
        fields: dict[str, list[str]] = {}
        for proto in packet.iter("proto"):
            if proto.get("name") in ("tcp", "mbtcp"):
                fields = {} if proto.get("name") == "tcp" else {"tcp.dstport": fields["tcp.dstport"]}
            for field in proto.iter("field"):
                fields.setdefault(field.get("name", ""), []).append(field.get("show", ""))
            if proto.get("name") == "modbus":
                result.add(frame_of(fields))
    return result


def frame_of(fields: dict[str, list[str]]) -> Frame:
    """A frame of tshark."""
    is_request = fields["tcp.dstport"] == [str(PORT)]
    code, exception = int(fields["modbus.func_code"][0]), int(fields.get("modbus.exception_code", ["0"])[0])
    prints = is_request or (code == 16 and not exception)
    place = [int(fields[name][0]) if prints else None for name in ("modbus.reference_num", "modbus.word_cnt")]
    words = tuple(int(text) for text in fields.get("modbus.regval_uint16", ()))
    head = (int(fields["mbtcp.trans_id"][0]), int(fields["mbtcp.unit_id"][0]), code, exception)
    return Frame(is_request, *head, *place, words)


CHANCE = random.Random(30)
TALK = exchanges(CHANCE, COUNT)
NO_TIMES = "pcapng without times"


def streams(head: int) -> dict[str, list[Segment]]:
    """The conversation in many forms, in which the first `head` bytes of each frame are in one segment."""

    def sent(frames: int, cuts: int, first: int = 0, last: int = COUNT, **numbers: int) -> list[Segment]:
        return connection(turns(TALK[first:last], frames, cuts, head, CHANCE), **numbers)

    wrapping = {"client": 2**32 - 700, "server": 2**32 - 1500}
    return {
        "frames alone": sent(1, 0),
        "pieces of frames": sent(1, 1),
        "many pieces of frames": sent(1, 20),
        "frames joined": sent(4, 0),
        "pieces of joined frames": sent(4, 9),
        "frames sent again": sent_again(sent(1, 0), CHANCE),
        "pieces sent again": sent_again(sent(1, 2), CHANCE),
        "pieces that overlap": overlapping(sent(4, 9), CHANCE),
        "pieces out of order": out_of_order(sent(4, 9), CHANCE),
        "pieces out of order and again": sent_again(out_of_order(sent(1, 3), CHANCE), CHANCE),
        "pieces that come seconds later": late(sent(4, 9), CHANCE),
        "numbers that begin anew": sent(4, 9, **wrapping),
        "numbers that begin anew out of order": out_of_order(sent(4, 9, **wrapping), CHANCE),
        "without its beginning": sent(1, 1)[3:],
        "two connections of the same ports": [*sent(1, 0, 0, 60), *sent(1, 1, 60, client=9 * 10**8, server=77)],
    }


STREAMS = streams(1)
OF_TSHARK = streams(8)
"""tshark takes a segment for no frame of Modbus TCP where it has fewer than the first eight bytes of one."""


@pytest.mark.proof(5)
@pytest.mark.parametrize("name", STREAMS)
def test_a_stream_cut_anywhere_has_every_frame_and_value(tmp_path: Path, name: str) -> None:
    decoded(tmp_path, capture(STREAMS[name]))


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", OF_TSHARK)
def test_a_stream_has_the_frames_that_tshark_sees(tmp_path: Path, name: str) -> None:
    frames = decoded(tmp_path, capture(OF_TSHARK[name]))
    assert own_frames(frames) == dissected(tmp_path / "input")


@pytest.mark.proof(4)
@pytest.mark.parametrize("network", NETWORKS)
def test_a_network_has_the_frames_that_tshark_sees(tmp_path: Path, network: str) -> None:
    frames = decoded(tmp_path, capture(OF_TSHARK["pieces of frames"], network))
    assert own_frames(frames) == dissected(tmp_path / "input")


@pytest.mark.proof(4)
@pytest.mark.parametrize("form", FORMS)
def test_a_file_has_the_frames_that_tshark_sees_at_their_times(tmp_path: Path, form: str) -> None:
    frames = decoded(tmp_path, capture(OF_TSHARK["frames alone"], "IPv6", form))
    times = [frame["time"] and frame["time"].timestamp() for frame in frames]
    assert times == [None if form == NO_TIMES else frame["packet"] / 1000 for frame in frames]
    assert own_frames(frames) == dissected(tmp_path / "input")


def test_captures_of_all_these_kinds_at_once_have_every_frame_and_value(tmp_path: Path) -> None:
    for number in range(30):
        name, network, form = (CHANCE.choice(list(kinds)) for kinds in (STREAMS, NETWORKS, FORMS))
        folder = tmp_path / f"{number} {name}, {network}, {form}"
        folder.mkdir()
        decoded(folder, capture(STREAMS[name], network, form))


def decoded(tmp_path: Path, content: bytes) -> list[dict[str, Any]]:
    """Compares the tables of a capture with the truth."""
    code, text, frames, values = decode(tmp_path, content)
    assert (code, {frame["verdict"] for frame in frames}) == (0, {"ok"}), text
    assert len(frames) == 2 * COUNT
    assert own_frames(frames) == truth(TALK)
    assert own_values(frames, values) == true_values(TALK)
    pairs = {frame["request"] for frame in frames if frame["direction"] == "response"}
    assert pairs == {frame["frame"] for frame in frames if frame["direction"] == "request"}
    return frames
