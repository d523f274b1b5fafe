"""`fieldspec decode --to`: what becomes of captures, logs and rows, good and bad ones."""

from __future__ import annotations

import io
import json
import re
import struct
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import pytest
from pyarrow import csv, ipc, parquet

from captures.conversations import RTAC, SOCKETCAN, USER_0, Segment, ethernet, pcap, pcapng, rtu, tcp_poll
from fieldspec.cli import main
from fieldspec.command.bulk.bulk_decoding import numbers_of
from fieldspec.command.console.usage import UsageError
from fieldspec.tools.captures.decoding import DeviceDecoder
from layouts import TEST_SPECS

READ = rtu(1, 4, 0, 0, 0, 2)
ANSWER = rtu(1, 4, 4, 0x43, 0x66, 0, 0)  # 230 volts


def run(*arguments: str, specs: Path = TEST_SPECS) -> tuple[int, str, str]:
    """Runs a verb, by default on the made-up devices. Returns the exit code and the output."""
    out, error = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(error):
        code = main([*arguments, "--specs", str(specs)])
    return code, out.getvalue(), error.getvalue()


def decode(tmp_path: Path, content: bytes, *options: str, device: str = "wattmeter@1", name: str = "input") -> Any:
    """Decodes one file. Returns the exit code, what is printed, and the rows of both tables."""
    path = tmp_path / name
    path.write_bytes(content)
    out = tmp_path / "out"
    code, text, _ = run("decode", device, str(path), "--to", "parquet", "--out", str(out), *options)
    return code, text, rows(out, "frames"), rows(out, "values")


def rows(out: Path, table: str) -> list[dict[str, Any]]:
    """The rows of all parts of a table."""
    return [row for path in sorted((out / table).glob("*.parquet")) for row in parquet.read_table(path).to_pylist()]


@pytest.mark.parametrize("form", [pcap, pcapng])
def test_a_capture_of_modbus_tcp_becomes_frames_and_values(tmp_path: Path, form: Any) -> None:
    code, _, frames, values = decode(tmp_path, form(map(ethernet, tcp_poll(3))))
    assert code == 0
    assert [frame["verdict"] for frame in frames] == 6 * ["ok"]
    assert [frame["request"] for frame in frames] == [None, 1, None, 3, None, 5]
    assert {frame["delay"] for frame in frames if frame["request"]} == {1_000_000}
    assert [frame["address"] for frame in frames] == 6 * [0]
    assert frames[1]["data"] == struct.pack(">4H", 0, 1, 2, 3)
    assert frames[1]["stream"] == "tcp 10.0.0.1:49152 10.0.0.2:502"
    assert [(value["frame"], value["register"]) for value in values[:2]] == [(2, "voltages[1]"), (2, "voltages[2]")]
    assert values[0]["unit"] == "V"


SERIAL = {
    "one frame in each packet": (pcap([READ, ANSWER], USER_0), ()),
    "pieces of frames": (pcap([READ[:3], READ[3:] + ANSWER[:1], ANSWER[1:]], USER_0), ("--link", "rtu")),
    "all in one packet": (pcap([READ + ANSWER], USER_0), ("--link", "rtu")),
    "with the header of RTAC": (pcap([bytes(12) + READ, bytes(12) + ANSWER], RTAC), ()),
    "a log without marks": (f"{READ.hex(' ')}\n{ANSWER.hex(' ')}\n".encode(), ()),
    "a log with marks": (f"10:00:00.000 TX: {READ.hex(' ')}\n10:00:00.010 RX: {ANSWER.hex(' ')}\n".encode(), ()),
    "a log in UTF-16": (f"\ufeff{READ.hex(' ')}\r\n{ANSWER.hex(' ')}\r\n".encode("utf-16-le"), ()),
}


@pytest.mark.parametrize("name", SERIAL)
def test_frames_of_a_serial_line_are_found_and_paired(tmp_path: Path, name: str) -> None:
    content, options = SERIAL[name]
    code, text, frames, values = decode(tmp_path, content, *options)
    assert code == 0, text
    assert [(frame["direction"], frame["request"]) for frame in frames] == [("request", None), ("response", 1)]
    assert [(value["register"], value["value"], value["unit"]) for value in values] == [("voltages[1]", 230.0, "V")]


@pytest.mark.parametrize("form", [pcap, pcapng])
def test_frames_of_a_can_bus_are_read_as_socketcan_records_them(tmp_path: Path, form: Any) -> None:
    packets = [
        "00000605 08000000 4041600000000000",
        "00000585 08000000 4B41600037020000",
        "00000705 01000000 0500000000000000",  # a heartbeat, filled up to eight bytes
        "00000605 08000000 4041600000000000",
        "00000585 08000000 8041600000000206",
        "40000605 08000000 0000000000000000",  # a remote request, which the device does not have
        "20000605 08000000 0000000000000000",  # an error
        "00000605 0C040000 404160000000000000000000",  # CAN FD
    ]
    content = form(map(bytes.fromhex, packets), SOCKETCAN)
    _, text, frames, values = decode(tmp_path, content, "--link", "sdo", device="axis")
    assert [frame["verdict"] for frame in frames] == ["ok", "ok", "wrong_const", "ok", "ok", "wrong_mark"]
    assert [frame["request"] for frame in frames if frame["verdict"] == "ok"] == [None, 1, None, 4]
    assert [frame["unit_address"] for frame in frames if frame["verdict"] == "ok"] == 4 * [5]
    assert frames[2]["bytes"].hex() == "000007050100000005"
    assert frames[4]["exception"] == "unknown_object"
    assert ("upload.data", "37 02 00 00") in [(value["register"], value["text"]) for value in values]
    assert "errors of CAN buses: 1" in text
    assert "frames of CAN FD: 1" in text


def test_rows_of_registers_become_values(tmp_path: Path) -> None:
    place = "2024-05-01 12:00:00,input_registers"
    text = f"time,space,address,value\n{place},0,0x4366\n{place},1,0\n"
    code, _, frames, values = decode(tmp_path, text.encode(), name="rows.csv")
    assert code == 0
    assert [(value["register"], value["value"]) for value in values] == [("voltages[1]", 230.0)]
    assert frames[0]["time"].isoformat() == "2024-05-01T12:00:00+00:00"


def test_a_killed_run_goes_on_and_ends_with_the_same_tables(tmp_path: Path) -> None:
    content = pcap(map(ethernet, tcp_poll(1500)))
    decode(tmp_path, content, "--part-frames", "1000000")
    whole = {table: rows(tmp_path / "out", table) for table in ("frames", "values")}
    again = tmp_path / "again"
    again.mkdir()
    code = stopped_after_first_part(again, content)
    assert code == "stopped"
    assert decode(again, content, "--part-frames", "500")[0] == 0
    assert {table: rows(again / "out", table) for table in ("frames", "values")} == whole


STOP_BATCH = 40_000


def stopped_after_first_part(folder: Path, content: bytes, part_frames: str = "500") -> str:
    """Runs until the first part is noted, as a kill would end it."""
    from fieldspec.command.bulk import bulk_decoding
    from fieldspec.tools.captures import capture_files

    class Stop(BaseException):
        pass

    note, batch = bulk_decoding._Job._note, capture_files.BATCH

    def stop(self: Any, *arguments: Any) -> None:
        note(self, *arguments)
        raise Stop

    bulk_decoding._Job._note = stop  # type: ignore[method-assign]
    capture_files.BATCH = STOP_BATCH
    try:
        decode(folder, content, "--part-frames", part_frames)
    except Stop:
        return "stopped"
    finally:
        bulk_decoding._Job._note = note  # type: ignore[method-assign]
        capture_files.BATCH = batch
    return "finished"


def test_texts_are_forgotten_between_parts_without_a_trace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    content = pcap([READ, ANSWER, READ, ANSWER] * 20, USER_0)
    whole = decode(tmp_path, content)[2:]
    monkeypatch.setattr("fieldspec.tools.captures.conversion.MOST_TEXTS", 0)
    monkeypatch.setattr("fieldspec.tools.captures.capture_files.BATCH", 300)
    decoders: list[DeviceDecoder] = []
    reset = DeviceDecoder.reset
    monkeypatch.setattr(DeviceDecoder, "reset", lambda decoder: (decoders.append(decoder), reset(decoder)))
    again = tmp_path / "again"
    again.mkdir()
    assert decode(again, content, "--part-frames", "10")[2:] == whole
    assert len(list((again / "out" / "frames").iterdir())) > 3
    assert len(decoders) > 3


DAMAGE = {
    "a broken tail": (lambda: pcap(map(ethernet, tcp_poll(3)))[:-5], 5, "bytes lost: truncated"),
    "garbage instead of a record": (lambda: pcap(map(ethernet, tcp_poll(3))) + b"\xff" * 64, 6, "which no packet has"),
    "an unsupported link type": (lambda: pcap([READ], 105), 0, "link type 105"),
    "other traffic": (lambda: pcap([ethernet(Segment(True, 1, b"GET / HTTP/1.1\r\n"), 80)]), 0, "without a frame"),
    "a clock that jumps": (lambda: pcap(map(ethernet, tcp_poll(2)), milliseconds=[9, 8, 7, 10**8]), 4, "jumps back: 2"),
}


@pytest.mark.parametrize("name", DAMAGE)
def test_what_cannot_be_decoded_is_counted_and_shown(tmp_path: Path, name: str) -> None:
    content, count, text = DAMAGE[name]
    _, printed, frames, _ = decode(tmp_path, content())
    assert len(frames) == count
    assert {frame["verdict"] for frame in frames} <= {"ok"}
    assert text in printed


def test_segments_sent_again_or_out_of_order_are_put_in_order(tmp_path: Path) -> None:
    asked = tcp_poll(6)
    requests, answers = asked[::2], asked[1::2]
    segments = [
        *asked[:4],
        requests[2],
        requests[2],
        answers[2],
        requests[4],
        requests[3],
        answers[3],
        answers[4],
        *asked[10:],
    ]
    code, text, frames, _ = decode(tmp_path, pcap(map(ethernet, segments)), "--port", "502")
    assert code == 0, text
    assert [frame["verdict"] for frame in frames] == 12 * ["ok"]
    assert [frame["request"] is not None for frame in frames].count(True) == 6
    assert "segments sent again: 1" in text


def test_a_gap_in_a_stream_joins_no_bytes(tmp_path: Path) -> None:
    asked = tcp_poll(8)
    requests = [segment for segment in asked if segment.is_request]
    split = Segment(True, requests[0].sequence, requests[0].data[:7])
    code, text, frames, _ = decode(tmp_path, pcap(map(ethernet, [split, *requests[2:]])), "--link", "tcp")
    assert code == 1
    assert "gaps in streams: 1" in text
    assert sorted(frame["verdict"] for frame in frames) == ["incomplete", *6 * ["ok"]]


def test_broken_frames_and_garbage_are_rows_of_their_own(tmp_path: Path) -> None:
    broken = bytes([*READ[:-1], READ[-1] ^ 1])
    packets = [READ, ANSWER, broken, b"\x55\xaa\x55", READ, ANSWER]
    code, text, frames, values = decode(tmp_path, pcap(packets, USER_0), "--link", "rtu")
    assert code == 1
    assert sum(frame["verdict"] == "ok" for frame in frames) == 4
    assert b"".join(frame["bytes"] for frame in frames) == b"".join(packets)
    assert len(values) == 2
    assert re.search(r"^no_frame +2 +11$", text, re.MULTILINE)


def test_a_capture_that_begins_in_the_middle_of_an_exchange_says_so(tmp_path: Path) -> None:
    _, _, frames, values = decode(tmp_path, pcap(map(ethernet, tcp_poll(2)[1:])))
    assert [frame["verdict"] for frame in frames] == ["no_request", "ok", "ok"]
    assert {value["frame"] for value in values} == {3}


def test_values_can_be_restricted_to_units(tmp_path: Path) -> None:
    other = [rtu(2, 4, 0, 0, 0, 2), rtu(2, 4, 4, 0x43, 0x66, 0, 0)]
    _, text, frames, values = decode(tmp_path, pcap([READ, ANSWER, *other], USER_0), "--units", "2")
    assert len(frames) == 4
    assert {value["unit_address"] for value in values} == {2}
    assert "unit address" in text


def test_a_file_that_is_no_capture_is_named_and_the_others_are_decoded(tmp_path: Path) -> None:
    folder = tmp_path / "files"
    folder.mkdir()
    (folder / "a.bin").write_bytes(bytes(range(1, 32)) * 9)
    (folder / "b.pcap").write_bytes(pcap([READ, ANSWER], USER_0))
    out = tmp_path / "out"
    code, text, _ = run("decode", "wattmeter@1", str(folder), "--to", "jsonl", "--out", str(out))
    assert code == 1
    assert "a.bin could not be read" in text
    lines = (out / "values" / "00000.jsonl").read_text("utf-8").splitlines()
    assert [json.loads(line)["value"] for line in lines] == [230.0]


@pytest.mark.parametrize("form", ["csv", "arrow"])
def test_other_formats_have_the_same_rows(tmp_path: Path, form: str) -> None:
    path = tmp_path / "input.pcap"
    path.write_bytes(pcap([READ, ANSWER], USER_0))
    out = tmp_path / "out"
    code, _, _ = run("decode", "wattmeter@1", str(path), "--to", form, "--out", str(out))
    assert code == 0
    name = out / "values" / f"00000.{form}"
    table = csv.read_csv(name) if form == "csv" else ipc.open_file(name).read_all()
    assert table.column("register").to_pylist() == ["voltages[1]"]
    assert table.column("value").to_pylist() == [230.0]


REFUSED = {
    "an option of single frames": (("--request", "0104"), "--request explains single frames"),
    "no folder": ((), "name it with --out FOLDER"),
    "ports that are none": (("--out", "out", "--port", "99999"), "not a list of numbers up to 65535"),
    "a missing file": (("--out", "out"), "there is no file"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_wrong_use_is_refused(tmp_path: Path, name: str) -> None:
    options, text = REFUSED[name]
    own = [str(tmp_path / option) if option == "out" else option for option in options]
    code, _, error = run("decode", "wattmeter@1", "missing.pcap", "--to", "csv", *own)
    assert code == 2
    assert text in error


def test_as_many_numbers_as_there_are_ports_are_taken_and_no_more() -> None:
    assert numbers_of("--port", "7,0-65535", 65535) == [7, *range(65536)]
    with pytest.raises(UsageError, match="has too many numbers"):
        numbers_of("--units", "0-65536", 1 << 20)


def test_the_folder_of_another_task_is_refused(tmp_path: Path) -> None:
    decode(tmp_path, pcap([READ, ANSWER], USER_0))
    path = tmp_path / "other"
    path.write_bytes(pcap([READ], USER_0))
    options = ("--to", "parquet", "--out", str(tmp_path / "out"))
    code, _, error = run("decode", "wattmeter@1", str(path), *options)
    assert code == 2
    assert "another task" in error


def test_the_journal_of_another_version_is_refused(tmp_path: Path) -> None:
    decode(tmp_path, pcap([READ, ANSWER], USER_0))
    journal = tmp_path / "out" / "journal.json"
    content = json.loads(journal.read_text(encoding="utf-8"))
    del content["format"]
    journal.write_text(json.dumps(content), encoding="utf-8")
    files = [str(path) for path in tmp_path.iterdir() if path.is_file()]
    code, _, error = run("decode", "wattmeter@1", *files, "--to", "parquet", "--out", str(tmp_path / "out"))
    assert code == 2
    assert "a journal of another version of fieldspec" in error


def test_options_of_tables_need_a_format(tmp_path: Path) -> None:
    code, _, error = run("decode", "wattmeter@1", "01", "--units", "1")
    assert code == 2
    assert "--units goes with --to" in error


def test_a_spreadsheet_takes_no_name_of_a_source_for_a_formula(tmp_path: Path) -> None:
    path = tmp_path / "=1+1.pcap"
    path.write_bytes(pcap([READ, ANSWER], USER_0))
    out = tmp_path / "out"
    run("decode", "wattmeter@1", str(path), "--to", "csv", "--out", str(out))
    cells = (out / "values" / "00000.csv").read_text("utf-8").splitlines()[1].split(",")
    assert cells[0].strip('"') == "'=1+1.pcap"
