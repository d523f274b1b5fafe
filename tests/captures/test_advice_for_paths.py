"""Somebody who names a file without `--to` is told a command that decodes it."""

from __future__ import annotations

import gzip
import random
import shlex
from pathlib import Path

import pytest

from captures.network_captures import FORMS, capture, connection, exchanges, turns
from command_line import TEST_SPECS, CommandLine

READ = "01 04 00 00 00 02 71 CB\n"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def packets(form: str) -> bytes:
    """A capture of some exchanges with a meter."""
    chance = random.Random(7)
    return capture(connection(turns(exchanges(chance, 4), 1, 1, 0, chance)), form=form)


def advised(run: CommandLine, path: Path) -> list[str]:
    """The words of the command that an error about a path advises."""
    refused = run("decode", "wattmeter", str(path))
    assert refused.code == 2
    return shlex.split(refused.err.partition("fieldspec decode ")[2])


@pytest.mark.parametrize("form", FORMS)
def test_the_command_that_is_advised_for_a_capture_decodes_it(run: CommandLine, tmp_path: Path, form: str) -> None:
    path = tmp_path / "some capture"
    path.write_bytes(packets(form))
    words = advised(run, path)
    folder = str(tmp_path / "tables")
    assert run("decode", *(folder if word == "FOLDER" else word for word in words)).code == 0
    assert list(Path(folder).glob("values/*.parquet"))


def test_the_command_that_is_advised_for_a_packed_log_decodes_it(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "log.gz"
    path.write_bytes(gzip.compress(READ.encode()))
    folder = str(tmp_path / "tables")
    assert run("decode", *(folder if word == "FOLDER" else word for word in advised(run, path))).code == 0
    assert list(Path(folder).glob("frames/*.parquet"))


def test_a_log_is_read_from_standard_input_as_advised(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "a log.txt"
    path.write_text(READ)
    device, dash, redirection, name = advised(run, path)
    assert (device, dash, redirection, name) == ("wattmeter", "-", "<", str(path))
    assert run("decode", device, dash, stdin=Path(name).read_bytes()).code == 0


@pytest.mark.parametrize("data", [packets("pcap"), gzip.compress(READ.encode())], ids=["capture", "packed"])
def test_what_is_no_text_is_refused_at_once_from_standard_input(run: CommandLine, data: bytes) -> None:
    refused = run("decode", "wattmeter", "-", stdin=data)
    assert (refused.code, refused.out) == (2, "")
    assert "name the file, with --to parquet --out FOLDER" in refused.err
