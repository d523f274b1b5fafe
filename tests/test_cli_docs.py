"""`fieldspec docs` builds the documentation and serves it to this machine alone."""

from __future__ import annotations

import shutil
import signal
import socket
import subprocess
import sys
from http.client import HTTPConnection
from pathlib import Path

import pytest

from bounded import HANGING
from command_line import SPECS
from fieldspec.cli import main


@pytest.fixture
def specs(tmp_path: Path) -> Path:
    folder = tmp_path / "specs"
    folder.mkdir()
    for name in ("esc11", "protocols"):
        shutil.copytree(SPECS / name, folder / name)
    return folder


def answer(address: str, path: str, host: str = "") -> tuple[int, bytes]:
    connection = HTTPConnection(address, timeout=HANGING)
    connection.request("GET", path, headers={"Host": host or address})
    response = connection.getresponse()
    return response.status, response.read()


def test_pages_are_built_and_served_until_an_interrupt(specs: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = [sys.executable, "-m", "fieldspec.cli", "docs", "--specs", str(specs), "--out", str(out)]
    with subprocess.Popen([*command, "--no-open", "--port", "0"], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(2)]
        address = lines[1].partition("http://")[2].partition("/")[0]
        try:
            status, page = answer(address, "/")
            assert (status, page) == (200, (out / "docs/index.html").read_bytes())
            assert answer(address, "/esc11/search-index.js")[0] == 200
            assert answer(address, "/../manifest.json")[0] == 404
            assert answer(address, "/", host="elsewhere.example:80")[0] == 403
        finally:
            process.send_signal(signal.SIGINT)
            try:
                code = process.wait(HANGING)
            finally:
                process.kill()
        assert code == 0


@pytest.mark.parametrize(
    ("port", "text"),
    [("70000", "--port 70000 is not a port"), ("-1", "--port -1 is not a port"), ("x", "invalid int value")],
)
def test_what_is_no_port_is_refused(port: str, text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["docs", f"--port={port}", "--no-open"]) == 2
    assert text in capsys.readouterr().err


def test_a_port_in_use_is_reported(specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        out = str(tmp_path / "out")
        assert main(["docs", "--specs", str(specs), "--out", out, "--port", str(port), "--no-open"]) == 2
    assert f"cannot serve pages on port {port}: " in capsys.readouterr().err


def test_a_folder_of_pages_that_leads_elsewhere_is_refused(
    specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, elsewhere = tmp_path / "out", tmp_path / "elsewhere"
    assert main(["build", "--specs", str(specs), "--out", str(out), "--to", "docs"]) == 0
    (out / "docs").rename(elsewhere)
    (out / "docs").symlink_to(elsewhere)
    capsys.readouterr()
    assert main(["docs", "--specs", str(specs), "--out", str(out), "--port", "0", "--no-open"]) == 2
    assert "leads out of" in capsys.readouterr().err
