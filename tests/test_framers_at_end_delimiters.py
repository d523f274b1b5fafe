"""Framers of frames that an end delimiter ends, where messages share a code, texts vary, or both delimiters are one."""

from __future__ import annotations

import importlib
import json
import subprocess
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts, load
from fieldspec.targets.js.backend import shared
from fieldspec.targets.python.backend import PACKAGE, files
from fieldspec.targets.python.backend import shared as python_modules
from javascript_modules import module_code
from python_package import link_of, write
from random_devices.framer_judge import SCRIPT
from random_devices.python_judge import module_of_device

SPEC = """
device:
  id: ender
  name: Ender
  vendor: Nobody
  manual: {title: The ends of nothing, file: ender.txt, sha256: "%s", lines: 99}
links:
  - name: shared
    source: 1 L1
    byte_order: big
    end: "0D"
    request: &marked [{name: mark, role: code, type: u8}, {name: data, role: body}]
    response: *marked
  - name: summed
    source: 1 L2
    byte_order: big
    end: "0D"
    request: &summed
      - {name: mark, role: code, type: u8}
      - {name: data, role: body}
      - {name: sum, role: checksum, algorithm: xor8}
    response: *summed
  - name: alike
    source: 1 L3
    byte_order: big
    transmission: hex_ascii
    start: "7E"
    end: "7E"
    request: &counted
      - {name: size, role: length, type: u8, measures: {from: mark}}
      - {name: mark, role: code, type: u8}
      - {name: data, role: body}
    response: *counted
  - name: silent
    source: 1 L4
    byte_order: big
    word_order: little
    request: &timed
      - {name: mark, role: code, type: u8}
      - {name: data, role: body}
      - {name: sum, role: checksum, algorithm: crc16_modbus, byte_order: little}
    response: *timed
messages:
  - name: one
    code: 65
    links: [shared, alike]
    source: 2 L1
    request: [{name: sub, type: u8, const: 1}]
    response: [{name: sub, type: u8, const: 1}, {name: value, type: u8}]
  - name: some
    code: 65
    links: [shared, alike]
    source: 2 L2
    request: [{name: sub, type: u8, const: 2}, {name: values, type: u8, range: 0..70, repeat: 1..24}]
    response: [{name: sub, type: u8, const: 2}, {name: values, type: u8, range: 0..70, repeat: 1..24}]
  - name: pairs
    code: 65
    links: [shared]
    source: 2 L3
    request: [{name: sub, type: u8, const: 3}]
    response: [{name: sub, type: u8, const: 3}, {name: pairs, record: pair, repeat: 1..24}]
  - name: label
    code: 66
    links: [summed]
    source: 2 L4
    request: []
    response: [{name: text, type: text, length: 12, varies: true}]
  - name: blocks
    code: 67
    links: [silent]
    source: 2 L5
    request: []
    response:
      - {name: count, type: u32, measures: {items: blocks}}
      - {name: size, type: u16, byte_order: little}
      - {name: blocks, type: u8, repeat: 0..40}
records:
  - {name: pair, source: 2 L6, fields: [{name: low, type: u8, digits: upper_hex, length: 2}, {name: high, type: u8}]}
"""


@cache
def ender() -> DeviceLayout:
    """The made-up device of this file."""
    project = load({"ender/device.yaml": SPEC.replace("%s", "1" * 64).encode()})
    assert [finding.message for finding in project.findings] == []
    return layouts(project.devices["ender"])[0]


@cache
def ender_module() -> ModuleType:
    return module_of_device(ender(), 0)


SINGLE, SOME, OTHERS = b"A\x01Z\r", b"A\x0241424344\r", b"A\x02\x00\x0d\x07\r"
PAIRS = b"A\x034\x31\x0d4\x32\x0d\r"
LABELS = [b"B" + text + bytes([check]) + b"\r" for text, check in ((b"AB", 0x41), (b"O", 0x0D), (b"\r!", 0x6E))]


def streams(folder: Path, jobs: list[tuple[str, str, list[bytes | None]]]) -> list[tuple[list[list[bytes]], int]]:
    """What the framers of Python and of JavaScript return for some pieces; the same, as a test of both."""
    results = []
    for link, direction, pieces in jobs:
        framer = getattr(link_of(ender_module(), link), f"{direction}_framer")()
        frames = [framer.idle() if piece is None else framer.feed(piece) for piece in pieces]
        results.append((frames, framer.dropped))
    write(folder, {**shared(), "device/module.js": module_code(ender())})
    rows: list[dict[str, Any]] = [
        {
            "framer": f"{link}{direction.capitalize()}Framer",
            "pieces": [None if piece is None else piece.hex() for piece in pieces],
        }
        for link, direction, pieces in jobs
    ]
    (folder / "streams.json").write_text(json.dumps(rows), "utf-8")
    command = [require_tool("node"), str(SCRIPT), str(folder / "device/module.js"), str(folder / "streams.json")]
    others = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert [
        ([[bytes.fromhex(frame) for frame in frames] for frames in other["frames"]], other["dropped"])
        for other in others
    ] == results
    return results


def test_the_answers_of_messages_that_share_a_code_come_out_at_once_and_apart(tmp_path: Path) -> None:
    frames = [SOME, SINGLE, SOME, SOME, SINGLE, SINGLE]
    single = [bytes([byte]) for byte in SOME + SINGLE]
    whole, separate, pieces = streams(
        tmp_path,
        [
            ("shared", "response", [b"".join(frames)]),
            ("shared", "response", [*frames]),
            ("shared", "response", [*single]),
        ],
    )
    assert whole == ([frames], 0)
    assert separate == ([[frame] for frame in frames], 0)
    assert [frame for own in pieces[0] for frame in own] == [SOME, SINGLE]
    assert (pieces[0][len(SOME) - 1], pieces[0][-1]) == ([SOME], [SINGLE])


def test_requests_with_open_lists_that_share_a_code_come_out_apart(tmp_path: Path) -> None:
    frames = [b"A\x02123\r", b"A\x01\r", b"A\x02123\r"]
    ((taken, dropped),) = streams(tmp_path, [("shared", "request", [b"".join(frames)])])
    assert (taken, dropped) == ([frames], 0)


def test_the_shortest_frame_that_the_link_decodes_ends_at_its_delimiter(tmp_path: Path) -> None:
    # A list of bytes may contain the end delimiter; a list of records does not end between two bytes of one.
    binary, records = streams(
        tmp_path, [("shared", "response", [OTHERS + SINGLE]), ("shared", "response", [PAIRS + SINGLE, None])]
    )
    assert binary == ([[b"A\x02\x00\r", SINGLE]], 2)
    assert records == ([[PAIRS, SINGLE], []], 0)


def test_a_checksum_or_a_text_may_have_the_byte_of_the_end_delimiter(tmp_path: Path) -> None:
    stream = b"".join(LABELS)
    whole, single = streams(
        tmp_path,
        [("summed", "response", [stream]), ("summed", "response", [bytes([byte]) for byte in stream])],
    )
    assert whole == ([LABELS], 0)
    assert [frame for own in single[0] for frame in own] == LABELS


@pytest.mark.parametrize("noise", [b"", b"7E", b"~", b"~~", b"\x00~00"])
def test_a_delimiter_may_both_begin_and_end_frames_of_characters(tmp_path: Path, noise: bytes) -> None:
    link, module = link_of(ender_module(), "alike"), ender_module()
    frames = [link.encode_response(message) for message in (module.OneResponse(5), module.SomeResponse([1, 2]))]
    ((taken, dropped),) = streams(tmp_path, [("alike", "response", [noise + b"".join(frames)])])
    assert (taken, dropped) == ([frames], len(noise))


def test_a_frame_of_characters_with_a_wrong_length_is_garbage(tmp_path: Path) -> None:
    frame = link_of(ender_module(), "alike").encode_response(ender_module().OneResponse(5))
    wrong = b"~09" + frame[3:]
    ((taken, dropped),) = streams(tmp_path, [("alike", "response", [wrong + frame])])
    assert (taken, dropped) == ([[frame]], len(wrong))


def test_a_count_of_four_bytes_ends_a_frame_without_silence(tmp_path: Path) -> None:
    link = link_of(ender_module(), "silent")
    frames = [link.encode_response(ender_module().BlocksResponse(7, list(range(size)))) for size in (3, 0, 40)]
    assert frames[0].startswith(bytes.fromhex("43 00 03 00 00 07 00 00 01 02"))
    ((taken, dropped),) = streams(tmp_path, [("silent", "response", [b"".join(frames)])])
    assert (taken, dropped) == ([frames], 0)


class Answering:
    """A transport on which an answer is as soon as a request has been written. `waits` counts reads of nothing."""

    def __init__(self, answer: bytes) -> None:
        self.answer, self.left, self.waits = answer, b"", 0

    def write(self, data: bytes) -> None:
        self.left = self.answer

    def read(self, size: int) -> bytes:
        data, self.left = self.left[:size], self.left[size:]
        self.waits += not data
        return data


def test_a_client_takes_the_answer_with_a_list_without_waiting_for_silence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = python_modules() | files([ender()])
    write(tmp_path, {path.replace(PACKAGE, "devices_of_ender", 1): text for path, text in texts.items()})
    monkeypatch.syspath_prepend(tmp_path)
    module = importlib.import_module("devices_of_ender.ender")
    client = importlib.import_module("devices_of_ender.ender.client")
    transport = Answering(SOME)
    answer = client.Client(transport, link="shared").ask(module.SomeRequest([5]))
    assert answer.message == module.SomeResponse(list(b"41424344"))
    assert transport.waits == 0
