"""Requests and responses are paired, streams are cut into frames, and preferences say what belongs to a device."""

from __future__ import annotations

import struct
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from external_tools import require_tool
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts, load
from fieldspec.targets.wireshark.backend import dissector
from layouts import SPECS, TEST_SPECS, newest
from wireshark_output.dissection import Packet, pcap, prefix_of, tshark

TC100, ESC11, STATION = newest(SPECS, "tc100"), newest(SPECS, "esc11"), newest(TEST_SPECS, "station")
HIWIN_E = newest(SPECS, "hiwin-e")
READ_REQUEST = bytes.fromhex("01 03 10 00 00 01 80 CA")
READ_RESPONSE = bytes.fromhex("01 03 02 00 01 79 84")
MOVE = bytes.fromhex("01 06 20 1E 00 03 A2 0D")
USER0 = 147
PORT = 2300


def columns(layout: DeviceLayout, capture: bytes, names: Sequence[str], *options: str) -> list[list[str]]:
    """Some fields of each packet; those of several frames in a packet are joined by commas."""
    prefix = prefix_of(layout)
    fields = [option for name in names for option in ("-e", name if name.startswith("_") else f"{prefix}.{name}")]
    run = tshark([layout], capture, "-2", "-T", "fields", *fields, *options)
    return [line.split("\t") for line in run.stdout.splitlines()]


def line(frames: Sequence[bytes]) -> bytes:
    """A capture of a serial line, one frame in each packet, ten milliseconds from packet to packet."""
    parts = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, USER0)]
    for number, frame in enumerate(frames):
        parts += [struct.pack("<IIII", 0, number * 10_000, len(frame), len(frame)), frame]
    return b"".join(parts)


def stream(pieces: Sequence[tuple[str, bytes]], port: int = PORT) -> bytes:
    """A capture of a TCP connection without its beginning. A piece goes in the direction of requests or responses."""
    parts = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 1)]
    sent = {"request": 1, "response": 1}
    for number, (direction, payload) in enumerate(pieces):
        other = "response" if direction == "request" else "request"
        ports = (40000, port) if direction == "request" else (port, 40000)
        hosts = (b"\x0a\0\0\1", b"\x0a\0\0\2") if direction == "request" else (b"\x0a\0\0\2", b"\x0a\0\0\1")
        tcp = struct.pack(">HHIIBBHHH", *ports, sent[direction], sent[other], 0x50, 0x18, 8192, 0, 0) + payload
        sent[direction] += len(payload)
        head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(tcp), number, 0, 64, 6, 0) + b"".join(hosts)
        frame = bytes(12) + b"\x08\0" + head + tcp
        parts += [struct.pack("<IIII", 0, number * 1000, len(frame), len(frame)), frame]
    return b"".join(parts)


def test_a_response_is_read_with_its_request_and_shows_the_time_between_them() -> None:
    packets = [Packet(40000, PORT, "request", READ_REQUEST), Packet(40000, PORT, "response", READ_RESPONSE)]
    names = ["frame.direction", "frame.response_in", "frame.request_in", "frame.time", "action_status"]
    rows = columns(TC100, pcap(packets), names, "-o", f"tc100.rtu_udp:{PORT}")
    assert rows == [["request", "2", "", "", ""], ["response", "", "1", "0.001000000", "1"]]


def test_a_line_tells_directions_by_its_frames() -> None:
    rows = columns(
        TC100,
        line([READ_REQUEST, READ_RESPONSE, MOVE, MOVE, READ_REQUEST, READ_REQUEST, READ_RESPONSE]),
        ["frame.direction", "frame.request_in", "motion_command"],
        "-o",
        f"tc100.rtu_line:{USER0}",
    )
    assert [row[0] for row in rows] == ["request", "response"] * 2 + ["request", "request", "response"]
    assert [row[1] for row in rows] == ["", "1", "", "3", "", "", "6"]
    assert [row[2] for row in rows] == ["", "", "3", "3", "", "", ""]


def test_packets_of_a_line_without_codes_in_responses_are_paired() -> None:
    examples = ESC11.device.examples
    pairs = [
        (examples[example.reply_to], example)
        for example in examples.values()
        if example.reply_to and not example.refused
    ]
    pairs = [(request, response) for request, response in pairs if not request.refused and request.message]
    frames = [example.frame for pair in pairs for example in pair]
    rows = columns(ESC11, line(frames), ["frame.direction", "frame.message"], "-o", f"esc11.serial_line:{USER0}")
    assert len(pairs) > 20
    assert rows == [[name, pair[0].message] for pair in pairs for name in ("request", "response")]


def test_exception_responses_with_a_code_of_their_own_are_paired_with_their_requests() -> None:
    layout = newest(TEST_SPECS, "scanner")
    refusal = bytes.fromhex("3E 46 46 30 32 46 46 0D")
    requests = [
        example.frame
        for example in layout.device.examples.values()
        if (example.link, example.direction, example.message) == ("terminal", "request", "read_state")
    ]
    names = ["frame.direction", "frame.message", "frame.request_in", "refusal.reason"]
    rows = columns(layout, line([requests[0], refusal, refusal]), names, "-o", f"scanner.terminal_line:{USER0}")
    assert rows == [["request", "read_state", "", ""], ["response", "read_state", "1", "2"], ["response", "", "", "2"]]


def test_a_stream_is_cut_into_frames_wherever_its_packets_end() -> None:
    requests = READ_REQUEST + MOVE + READ_REQUEST
    pieces = [("request", requests[:3]), ("request", requests[3:12]), ("request", requests[12:])]
    rows = columns(TC100, stream(pieces), ["frame.message", "rtu.crc"], "-o", f"tc100.rtu_tcp:{PORT}")
    messages = [name for row in rows for name in row[0].split(",") if name]
    assert messages == ["read_registers", "write_register", "read_registers"]


def test_transactions_pair_responses_in_any_order() -> None:
    def request(transaction: int, address: int) -> bytes:
        return struct.pack(">HHHBBHH", transaction, 0, 6, 1, 3, address, 1)

    def response(transaction: int) -> bytes:
        return struct.pack(">HHHBBBH", transaction, 0, 5, 1, 3, 2, 0)

    pieces = [("request", request(7, 0) + request(8, 1)), ("response", response(8)), ("response", response(7))]
    rows = columns(STATION, stream(pieces), ["frame.request_in", "tcp.transaction"], "-o", f"station.tcp_tcp:{PORT}")
    assert rows == [["", "7,8"], ["1", "8"], ["1", "7"]]


def test_ports_of_the_spec_are_attached_until_the_preference_says_otherwise() -> None:
    capture = stream([("request", struct.pack(">HHHBBHH", 7, 0, 6, 1, 3, 0, 1))], 502)
    assert columns(STATION, capture, ["tcp.transaction"]) == [["7"]]
    assert columns(STATION, capture, ["tcp.transaction"], "-o", f"station.tcp_tcp:{PORT}") == [[""]]


def test_process_data_of_profinet_are_read_by_the_numbers_of_their_frames() -> None:
    example = next(
        example
        for example in HIWIN_E.device.examples.values()
        if (example.link, example.message, example.direction) == ("cyclic", "telegram_3", "request")
    )
    capture = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 1)]
    for number in (0x8001, 0x8002):
        frame = bytes(12) + b"\x88\x92" + struct.pack(">H", number) + b"\x80\x80" + example.frame
        frame += bytes(40 - len(example.frame)) + bytes.fromhex("00 00 35 00")
        capture += [struct.pack("<IIII", 0, 0, len(frame), len(frame)), frame]
    names = ["frame.message", "telegram_3.speed_setpoint_b", "control_word_1.on"]
    options = ("-o", "hiwin_e.cyclic_pn_request:0x8001", "-o", "hiwin_e.cyclic_pn_offset:2")
    rows = columns(HIWIN_E, b"".join(capture), names, *options)
    assert rows[0][0] == "telegram_3"
    assert (
        int(rows[0][1])
        == explained(HIWIN_E, "cyclic", "request", example.frame, "telegram_3").values["speed_setpoint_b"]
    )
    assert rows[1] == ["", "", ""]


def test_units_that_are_not_chosen_are_left_to_others() -> None:
    packets = [Packet(40000, PORT, "request", READ_REQUEST)]
    options = ("-o", f"tc100.rtu_udp:{PORT}", "-o")
    assert columns(TC100, pcap(packets), ["rtu.station"], *options, "tc100.units:1-2") == [["1"]]
    assert columns(TC100, pcap(packets), ["rtu.station"], *options, "tc100.units:2-5,7") == [[""]]


def test_packets_are_filtered_by_the_name_of_a_register_and_by_the_name_of_a_value() -> None:
    packets = [Packet(40000, PORT, "request", frame) for frame in (READ_REQUEST, MOVE)]
    for condition in ("tc100.motion_command == 3", 'tc100.motion_command == "homing"'):
        options = ["-d", f"udp.port=={PORT},tc100_rtu", "-Y", condition, "-T", "fields", "-e", "frame.number"]
        assert tshark([TC100], pcap(packets), *options).stdout.split() == ["2"]


def test_each_dissector_is_a_program_of_old_and_of_new_lua() -> None:
    compilers = [require_tool("luac5.2"), require_tool("luac5.4")]
    with tempfile.TemporaryDirectory(prefix="fieldspec-lua-") as folder:
        for layout in (TC100, ESC11, HIWIN_E, newest(TEST_SPECS, "hostile")):
            script = Path(folder) / f"{layout.device.id}-{layout.device.version}.lua"
            script.write_text(dissector(layout), "utf-8")
            for compiler in compilers:
                run = subprocess.run([compiler, "-p", str(script)], capture_output=True, text=True, check=False)
                assert (run.returncode, run.stderr) == (0, "")


def test_texts_of_a_spec_stay_texts() -> None:
    text = dissector(newest(TEST_SPECS, "hostile"))
    assert text.isascii()
    with tempfile.TemporaryDirectory(prefix="fieldspec-lua-") as folder:
        script = Path(folder) / "hostile.lua"
        script.write_text(text, "utf-8")
        options = ["-G", "fields", "-X", f"lua_script:{script}"]
        run = subprocess.run([require_tool("tshark"), *options], capture_output=True, text=True, check=True)
    rows = [row.split("\t") for row in run.stdout.splitlines()]
    titles = {row[2]: (row[1], row[-1]) for row in rows if row[0] == "F" and row[2].startswith("hostile.")}
    assert titles["hostile.class"] == ("Class ({{ x }})", '*/ """ </script> \\. \\.')
    assert titles["hostile.errno"] == ("Errno", "EOF new line.")
    assert titles["hostile.eof"] == ("Eof", "\N{ROBOT FACE}.")


ENDS = """
device:
  id: endings
  name: Endings
  vendor: Nobody
  manual: {title: The ends of nothing, file: endings.txt, sha256: "%s", lines: 99}
links:
  - name: shared
    source: 1 L1
    byte_order: big
    end: "0D"
    request: &marked [{name: mark, role: code, type: u8}, {name: data, role: body}]
    response: *marked
messages:
  - name: single
    code: 65
    source: 2 L1
    request: [{name: sub, type: u8, const: 1}]
    response: [{name: sub, type: u8, const: 1}, {name: value, type: u8}]
  - name: pairs
    code: 65
    source: 2 L2
    request: [{name: sub, type: u8, const: 2}, {name: numbers, type: u16, repeat: 1..24}]
    response: [{name: sub, type: u8, const: 2}, {name: numbers, type: u16, repeat: 1..24}]
"""


def test_a_frame_with_an_open_list_ends_at_the_first_end_delimiter_with_which_it_is_a_frame() -> None:
    project = load({"endings/device.yaml": ENDS.replace("%s", "1" * 64).encode()})
    layout = layouts(project.devices["endings"])[0]
    pairs, single = b"A\x02\x0d\x01\x02\x03\r", b"A\x01\r"
    requests = pairs + single + pairs + pairs
    for cuts in ((0,), (0, 3), (0, 5, 9), (0, 7, 12)):
        ends = (*cuts[1:], len(requests))
        pieces = [("request", requests[first:last]) for first, last in zip(cuts, ends, strict=True)]
        rows = columns(layout, stream(pieces), ["frame.message", "pairs.numbers"], "-o", f"endings.shared_tcp:{PORT}")
        assert [name for row in rows for name in row[0].split(",") if name] == ["pairs", "single", "pairs", "pairs"]
        assert [name for row in rows for name in row[1].split(",") if name] == ["3329", "515"] * 3
