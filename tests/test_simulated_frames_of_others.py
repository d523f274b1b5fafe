"""Frames that public protocols print, on a simulated device whose spec a stranger wrote."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest

from fieldspec.cli import main
from layouts import TEST_SPECS
from simulators import SPECS, Unit

CAMERA = """
device: {id: camera, name: Camera, vendor: Nobody, manual: {title: Of it, url: "https://example.com", read: 2026-11-30}}
links:
  - name: tcp
    source: "1"
    transmission: binary
    byte_order: big
    end: FF
    request:
      - {name: address, type: u8, range: 0x81..0x87}
      - {name: command, role: code, type: u24}
      - {name: body, role: body}
    response: [{name: address, type: u8, range: 0x90..0xF0}, {name: body, role: body}]
messages:
  - {name: read_power, code: 0x090400, source: "2", request: [], response: [{name: power, type: u8, const: 2}]}
"""


@pytest.fixture
def folder(tmp_path: Path) -> str:
    (tmp_path / "camera").mkdir()
    (tmp_path / "camera" / "device.yaml").write_text(CAMERA, "utf-8")
    return str(tmp_path)


def test_a_part_of_a_response_repeats_the_request_only_within_its_own_range(folder: str) -> None:
    unit = Unit("camera", "tcp", folder=folder)
    assert unit.answer_to(bytes.fromhex("81 09 04 00 FF")).frame == bytes.fromhex("90 02 FF")


def test_an_address_may_begin_with_the_name_of_the_link_that_is_served(
    folder: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["simulate", "camera", "--specs", folder, "--port", "tcp://127.0.0.1"]) == 2
    assert "write it as tcp://HOST:PORT" in capsys.readouterr().err


def test_an_address_that_begins_with_the_name_of_another_link_needs_a_link(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "station", "--specs", str(TEST_SPECS), "--port", "tcp://127.0.0.1:0"]) == 2
    assert "names no link; write --port tcp=tcp://127.0.0.1:0" in capsys.readouterr().err


def test_a_simulated_device_says_which_of_its_messages_without_codes_it_exchanges(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO(""))
    command = ["simulate", "hiwin-e", "--specs", SPECS, "--port", "cyclic=udp://127.0.0.1:0", "--control"]
    note = "message telegram_3; --message NAME chooses another"
    assert main(command) == 0
    assert note in capsys.readouterr().err
    assert main([*command, "--message", "111"]) == 0
    assert note not in capsys.readouterr().err
