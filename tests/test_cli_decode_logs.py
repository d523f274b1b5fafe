"""`fieldspec decode` explains each line of a log, a response with the request before it, and reports bad lines."""

from __future__ import annotations

import gc
import io
import json
import os
import subprocess
import sys
import tracemalloc
from argparse import Namespace
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import pytest

from command_line import TEST_SPECS, CommandLine
from fieldspec.codec.explain.readings import FrameOptions
from fieldspec.command.frames.frame_hints import FrameHints
from fieldspec.command.verbs.decode import LONGEST_LINE, FramePrinter, Log
from layouts import newest

READ = "01 03 10 00 00 02 C0 CB"
ANSWER = "01 03 04 12 34 FF FF BF 35"
SHORT_ANSWER = "01 03 02 12 34 B5 33"
WRITE = "01 06 20 00 00 05 42 09"
WRITE_6 = "01 06 20 00 00 06 02 08"
TO_ALL = "00 06 20 00 00 05 43 D8"
STOP = "00 06 20 00 20 46"
STOPPED = "00 06 20 00 41 67"
UNKNOWN = "01 7F 41 C0"
REFUSED = "01 FF 01 A0 30"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def explained(run: CommandLine, *lines: str) -> list[Any]:
    """The frames of a log as data."""
    result = run("decode", "widget", "-", "--format", "json", stdin="\n".join(lines).encode())
    return [json.loads(line) for line in result.lines]


@pytest.mark.parametrize(
    ("log", "expected"),
    [
        (
            [READ, ANSWER],
            [(1, "request", "read_registers", "only"), (2, "response", "read_registers", "request")],
        ),
        (
            ["# a comment", f"[12:00:01.123] TX: {WRITE}", "", f"[12:00:01.130] RX: {WRITE}"],
            [(2, "request", "write_register", "mark"), (4, "response", "write_register", "request")],
        ),
        (
            [WRITE, WRITE],
            [(1, "request", "write_register", "likeliest"), (2, "response", "write_register", "request")],
        ),
        (
            [WRITE, WRITE_6],
            [(1, "request", "write_register", "likeliest"), (2, "request", "write_register", "likeliest")],
        ),
        (
            [f"> {WRITE}", f"> {WRITE}", f"< {WRITE}"],
            [
                (1, "request", "write_register", "mark"),
                (2, "request", "write_register", "mark"),
                (3, "response", "write_register", "request"),
            ],
        ),
        (
            [f"< {WRITE}"],
            [(1, "response", "write_register", "mark")],
        ),
        (
            [TO_ALL, TO_ALL],
            [(1, "request", "write_register", "likeliest"), (2, "request", "write_register", "likeliest")],
        ),
        (
            [STOP, STOPPED, STOP, STOPPED],
            [
                (1, "request", "stop", "likeliest"),
                (2, "response", "stop", "request"),
                (3, "request", "stop", "likeliest"),
                (4, "response", "stop", "request"),
            ],
        ),
        (
            ["> 2026/01/31 12:00:01.000123  length=8 from=0 to=7", WRITE, "< 2026/01/31 12:00:01.1  length=8", WRITE],
            [(2, "request", "write_register", "mark"), (4, "response", "write_register", "request")],
        ),
        (
            [r":010310000002EA\r\n", r":010304 1234FFFFB4\r\n"],
            [(1, "request", "read_registers", "only"), (2, "response", "read_registers", "request")],
        ),
        (
            [UNKNOWN, REFUSED],
            [(1, "request", None, "closest"), (2, "response", None, "request")],
        ),
    ],
    ids=lambda case: " / ".join(case) if isinstance(case[0], str) else "",
)
def test_each_frame_is_read_by_the_frames_before_it(
    run: CommandLine, log: list[str], expected: list[tuple[int, str, str, str]]
) -> None:
    summaries = [
        (frame["line"], frame["direction"], frame["message"], frame["chosen"]) for frame in explained(run, *log)
    ]
    assert summaries == expected


@pytest.mark.parametrize(
    ("log", "expected"),
    [
        (["F0 03 20 00 00 00"] * 2, [("request", "telegram_3", "likeliest"), ("request", "telegram_3", "likeliest")]),
        (
            ["TX: F0 03 20 00 00 00", "RX: 00 03 20 00 00 00"],
            [("request", "telegram_3", "mark"), ("response", "telegram_3", "request")],
        ),
        (
            ["04 01 FF FF FF FE 00 00 05 DC 20 00 00 00", "00 03 00 24 00 00 00 00 00 00"],
            [("request", "telegram_11", "only"), ("response", "telegram_11", "request")],
        ),
        (
            ["07 01 00 01 23 17 00 00", "07 01 00 06 01 0B B8"],
            [("request", "read_parameter", "only"), ("response", "read_parameter", "request")],
        ),
    ],
)
def test_a_frame_without_a_code_answers_only_a_certain_request(
    run: CommandLine, log: list[str], expected: list[tuple[str, str, str]]
) -> None:
    result = run("decode", "glider-x", "-", "--format", "json", stdin="\n".join(log).encode())
    assert [
        (frame["direction"], frame["message"], frame["chosen"]) for frame in map(json.loads, result.lines)
    ] == expected


def test_a_response_names_the_line_of_its_request(run: CommandLine) -> None:
    result = run("decode", "widget", stdin=f"\n{READ}\n# between\n{ANSWER}\n".encode())
    assert result.code == 0
    assert result.lines[0].startswith("line 2: read_registers request, rtu, Widget 2.0")
    assert "this answers the request in line 2" in result.lines


@pytest.mark.parametrize("log", ["", "\n\n", "# nothing else\n"])
def test_a_log_without_frames_says_so(run: CommandLine, log: str) -> None:
    result = run("decode", "widget", stdin=log.encode())
    assert (result.code, result.out, result.err) == (0, "", "fieldspec: standard input has no frames\n")


def test_a_response_that_does_not_answer_says_so(run: CommandLine) -> None:
    result = run("decode", "widget", stdin=f"{READ}\n{SHORT_ANSWER}\n".encode())
    assert "this does not answer the request in line 1" in result.lines


def test_registers_of_a_response_are_those_of_the_request_before_it(run: CommandLine) -> None:
    _, answer, later = explained(run, READ, ANSWER, ANSWER)
    assert [register["address"] for register in answer["registers"]] == [0x1000, 0x1001]
    assert later["registers"] == []


def test_lines_that_cannot_be_read_are_reported_and_do_not_stop_the_run(run: CommandLine) -> None:
    result = run("decode", "widget", stdin=f"hello\n{READ}\n01 xx\n{READ}\n".encode())
    assert result.code == 1
    assert result.err.splitlines() == [
        "fieldspec: line 1: there are no bytes in it",
        "fieldspec: line 3: `xx` is not a byte in hexadecimal digits",
    ]
    assert [line for line in result.lines if line.startswith("line ")] == [
        f"line {number}: read_registers request, rtu, Widget 2.0: Read registers" for number in (2, 4)
    ]


@pytest.mark.parametrize(
    ("log", "code"),
    [(b"", 0), (b"# nothing\n\n", 0), (READ.encode(), 0), (b"01 03 10 00 00 02 C0 CC\n" + READ.encode(), 1)],
)
def test_the_exit_code_tells_whether_anything_was_wrong(run: CommandLine, log: bytes, code: int) -> None:
    assert run("decode", "widget", "-", stdin=log).code == code


def test_notes_and_errata_are_printed_once_in_a_log(run: CommandLine) -> None:
    frame = newest(TEST_SPECS, "widget").device.examples["nest-request"].frame
    result = run("decode", "widget", stdin=f"{frame.hex()}\n".encode() * 3)
    assert result.out.count("note on nest.alarms[1]: alarm does not list 30583.") == 1


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le"])
def test_logs_of_windows_shells_are_read(run: CommandLine, encoding: str) -> None:
    result = run("decode", "widget", stdin=f"{READ}\r\n{ANSWER}\r\n".encode(encoding))
    assert (result.code, result.err) == (0, "")
    assert sum(line.startswith("line ") for line in result.lines) == 2


def test_bytes_that_are_not_text_are_reported(run: CommandLine) -> None:
    result = run("decode", "widget", stdin=b"\x01\x06\xff\xfe\xe9\n" + READ.encode())
    assert result.err.startswith("fieldspec: line 1: ")
    assert "line 2: " in result.out


def test_an_overlong_line_is_reported_and_the_next_one_is_read(run: CommandLine) -> None:
    result = run("decode", "widget", stdin=b"01 " * LONGEST_LINE + b"\n" + READ.encode())
    assert result.err == f"fieldspec: line 1: it has {LONGEST_LINE} characters or more\n"
    assert result.lines[0].startswith("line 2: ")


def test_a_named_request_answers_every_line(run: CommandLine) -> None:
    log = f"{ANSWER}\n{ANSWER}\n".encode()
    result = run("decode", "widget", "-", "--request", READ, stdin=log)
    assert result.code == 0
    assert result.out.count("status_word") == 2


class Weighed(io.BytesIO):
    """A log that measures the memory in use when two of its lines are read."""

    def __init__(self, log: bytes, lines: tuple[int, int]) -> None:
        super().__init__(log)
        self.lines, self.number = lines, 0
        self.weights: list[int] = []

    def readline(self, size: int | None = -1, /) -> bytes:
        self.number += 1
        if self.number in self.lines:
            gc.collect()  # this empties the caches of the interpreter, too
            self.weights.append(tracemalloc.get_traced_memory()[0])
        return super().readline(size)


def test_memory_does_not_grow_with_the_log() -> None:
    layout = newest(TEST_SPECS, "widget")
    log = Weighed(f"{READ}\n{ANSWER}\n".encode() * 60, (20, 120))
    options = FrameOptions()
    hints = FrameHints(layout, options, Namespace())
    with open(os.devnull, "w", encoding="utf-8") as nothing, redirect_stdout(nothing):
        tracemalloc.start()
        Log(layout, options, None, FramePrinter(layout, "text"), hints, strict=False).explain(log)
        tracemalloc.stop()
    early, late = log.weights
    assert late - early < 2000


def test_each_frame_is_printed_as_soon_as_it_is_read() -> None:
    command = [
        sys.executable,
        "-m",
        "fieldspec",
        "decode",
        "widget",
        "-",
        "--specs",
        str(TEST_SPECS),
        "--format",
        "json",
    ]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        for frame in (READ, ANSWER):
            process.stdin.write(f"{frame}\n".encode())
            process.stdin.flush()
            assert json.loads(process.stdout.readline())["frame"] == frame.replace(" ", "")
        process.stdin.close()
    assert process.returncode == 0


def test_the_reader_of_the_output_may_close_the_pipe(tmp_path: Path) -> None:
    log = tmp_path / "log.txt"
    log.write_bytes(f"{READ}\n{ANSWER}\n".encode() * 2000)
    command = [sys.executable, "-m", "fieldspec", "decode", "widget", "-", "--specs", str(TEST_SPECS)]
    with log.open("rb") as stdin:
        process = subprocess.Popen(command, stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.readline()
    process.stdout.close()
    assert (process.stderr.read(), process.wait()) == (b"", 141)  # the frames that follow could be wrong
    process.stderr.close()


@pytest.mark.parametrize(("transaction", "code"), [(6, 1), (7, 0)])
@pytest.mark.parametrize("marks", [("", ""), ("TX: ", "RX: ")])
def test_a_response_that_repeats_another_number_is_wrong(
    run: CommandLine, marks: tuple[str, str], transaction: int, code: int
) -> None:
    frame = ["--link", "checked", "--format", "hex"]
    request = run("encode", "gateway", "echo", "destination=1", "origin=2", "transaction=7", "data=1,2", *frame)
    values = ["destination=2", "origin=1", "status=0", f"transaction={transaction}", "data=1,2"]
    response = run("encode", "gateway", "echo", "--direction", "response", *values, *frame)
    log = "\n".join(mark + result.lines[0] for mark, result in zip(marks, (request, response), strict=True))
    result = run("decode", "gateway", "--link", "checked", stdin=log.encode())
    assert result.code == code
    assert ("transaction does not repeat the request: should be 7" in result.lines) == (code == 1)
