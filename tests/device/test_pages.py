"""The server of pages: it gives the files of one folder, to this machine alone, whatever its clients do."""

from __future__ import annotations

import socket
import struct
import threading
from collections.abc import Iterator
from http.client import HTTPConnection
from pathlib import Path

import pytest

from bounded import wait_until
from fieldspec.tools.carriers.pages import PageServer

SECRET = b"of somebody else"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of pages, and a file beside it that is none of them."""
    (tmp_path / "secret.txt").write_bytes(SECRET)
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "index.html").write_bytes(SECRET)
    pages = tmp_path / "docs"
    (pages / "device").mkdir(parents=True)
    (pages / "index.html").write_bytes(b"all devices")
    (pages / "device" / "index.html").write_bytes(b"a device")
    return pages


@pytest.fixture
def port(folder: Path) -> Iterator[int]:
    """The port at which the folder is served."""
    server = PageServer(folder, 0)
    thread = threading.Thread(target=server.serve)
    thread.start()
    yield int(server.address.rpartition(":")[2].rstrip("/"))
    server.close()
    thread.join(10)


def answer(port: int, path: str, host: str = "localhost") -> tuple[int, bytes]:
    """The status and the content that a server answers with."""
    connection = HTTPConnection("127.0.0.1", port, timeout=10)
    connection.request("GET", path, headers={"Host": host})
    response = connection.getresponse()
    return response.status, response.read()


@pytest.mark.parametrize(
    ("link", "target", "path"),
    [
        ("leak.txt", "../secret.txt", "/leak.txt"),
        ("leak", "..", "/leak/secret.txt"),
        ("leak", "../elsewhere", "/leak/"),
        ("device/chain", "../leak.txt", "/device/chain"),
        ("pages/index.html", "../../secret.txt", "/pages/"),
        ("pages/index.htm", "../../secret.txt", "/pages/"),
        ("loop", "loop", "/loop"),
    ],
)
def test_a_link_out_of_the_folder_is_no_page(folder: Path, port: int, link: str, target: str, path: str) -> None:
    (folder / "pages").mkdir()
    (folder / "leak.txt").symlink_to("../secret.txt")
    (folder / link).unlink(missing_ok=True)
    (folder / link).symlink_to(target)
    assert answer(port, path)[0] == 404


def test_a_link_within_the_folder_is_a_page(folder: Path, port: int) -> None:
    (folder / "newest").symlink_to("device")
    assert answer(port, "/newest/") == (200, b"a device")


@pytest.mark.parametrize("path", ["/%00", "/%ED%A0%80", "/" + "x" * 5000, "/device/%2e%2e/%2e%2e/secret.txt"])
def test_a_path_that_no_file_can_have_is_no_page(port: int, path: str, capfd: pytest.CaptureFixture[str]) -> None:
    assert answer(port, path)[0] == 404
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize(
    ("host", "status"),
    [
        # RFC 9110, 7.2: the port is left out where it is 80.
        ("127.0.0.1", 200),
        ("localhost", 200),
        ("LocalHost:8000", 200),
        ("127.0.0.1:80", 200),
        ("elsewhere.example", 403),
        ("elsewhere.example:80", 403),
        ("localhost.elsewhere.example", 403),
        ("localhost:80:80", 403),
        ("localhost:port", 403),
        ("", 403),
    ],
)
def test_who_asks_by_the_name_of_this_machine_is_served(port: int, host: str, status: int) -> None:
    assert answer(port, "/", host)[0] == status


def test_nothing_is_said_of_clients_that_leave(folder: Path, port: int, capfd: pytest.CaptureFixture[str]) -> None:
    (folder / "large.bin").write_bytes(bytes(1 << 24))  # more than all buffers between the two
    threads = threading.active_count()
    for request in (b"", b"GET /large", b"GET /large.bin HTTP/1.0\r\nHost: localhost\r\n\r\n"):
        with socket.create_connection(("127.0.0.1", port), 10) as connection:
            connection.sendall(request)
            if request.endswith(b"\r\n\r\n"):
                assert connection.recv(1)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # leaves at once
    wait_until(lambda: threading.active_count() <= threads)
    assert capfd.readouterr().err == ""
    assert answer(port, "/") == (200, b"all devices")
