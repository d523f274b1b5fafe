"""Messages that access registers in several steps: what explanations show, what `encode` refuses, what changes say."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import SPECS, TEST_SPECS, CommandLine
from fieldspec.codec.reference import codec
from fieldspec.command import pipeline
from fieldspec.command.sources.spec_files import files
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets

REQUEST = "01 17 00 00 00 02 00 00 00 02 04 00 05 00 01 16 81"
EXCHANGE = "read_write_registers read_address=0 read_word_count=1 write_address=0 values=5,1"
RESPONSE = "01 17 04 00 05 00 01 28 E6"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def test_a_request_shows_the_registers_of_all_steps(run: CommandLine) -> None:
    result = run("decode", "station", REQUEST, "--link", "rtu", "--direction", "request")
    assert "writes and reads registers" in result.out
    rows = [line.split() for line in result.out.splitlines() if line.startswith("0x000")]
    assert [" ".join(row[2:]) for row in rows] == [
        "00 05 filter_time rw 5 0.5 ms 5 L6",
        "00 01 mode rw 1 pulse 5 L7",
        "filter_time rw 5 L6",
        "mode rw 5 L7",
    ]


def test_a_response_shows_the_registers_that_its_request_reads(run: CommandLine) -> None:
    result = run("decode", "station", RESPONSE, "--link", "rtu", "--request", REQUEST)
    assert "reads registers" in result.out
    assert [line.split()[4] for line in result.out.splitlines() if line.startswith("0x000")] == ["filter_time", "mode"]


def test_a_step_that_a_register_forbids_is_not_encoded(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    specs = tmp_path / "specs"
    shutil.copytree(TEST_SPECS / "station", specs / "station")
    shutil.copytree(TEST_SPECS.parent.parent / "specs" / "protocols", specs / "protocols")
    device = specs / "station" / "device.yaml"
    device.write_text(device.read_text("utf-8").replace("name: mode, enum", "name: mode, access: ro, enum"), "utf-8")
    run = CommandLine(capsys, monkeypatch, specs)
    for message in ("mask_write_register address=1 and_mask=1 or_mask=0", EXCHANGE):
        result = run("encode", "station", *message.split(), "station=1", "--link", "rtu")
        assert "mode at 0x0001 can only be read; no frame is written" in result.err


def test_redaction_knows_the_registers_of_steps(tmp_path: Path) -> None:
    texts = {path.name: path.read_text("utf-8") for path in (TEST_SPECS / "station").glob("*.yaml")}
    device = texts["device.yaml"].replace("name: limit,", "name: limit, roles: serial_number,")
    (tmp_path / "station").mkdir()
    (tmp_path / "station" / "device.yaml").write_text(device, "utf-8")
    shutil.copytree(SPECS / "protocols", tmp_path / "protocols")
    (layout,) = pipeline.layouts(pipeline.load(files(tmp_path)).devices["station"])
    link = codec(layout).links["rtu"]
    asked = {"read_address": 1, "read_word_count": 3, "write_address": 1, "values": [1, 0x4142, 0x4344]}
    sent = {"station": 1, **asked}
    cleaned = Redaction(layout, Secrets())
    request = link.encode("request", "read_write_registers", sent)
    clean = cleaned.frame("rtu", "request", request, link.decode(request, "request"), {})
    assert link.decode(clean, "request").values["values"][0] == 1
    assert b"ABCD" in request
    assert b"ABCD" not in clean
    response = link.encode("response", "read_write_registers", {"station": 1, "values": [1, 0x4142, 0x4344]})
    clean = cleaned.frame("rtu", "response", response, link.decode(response, "response", "read_write_registers"), sent)
    assert b"ABCD" not in clean
