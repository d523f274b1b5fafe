"""The server of WebSockets says nothing of clients that leave or send what is not a request, and goes on."""

from __future__ import annotations

import logging
import socket
import struct
import threading

import pytest
from websockets.sync.client import connect

from bounded import wait_until
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.carriers.web import WebServer, WebSocket

HANDSHAKE = (
    "GET {target} HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)
"""A request of RFC 6455, 1.3."""

SENT = {
    "nothing": b"",
    "a part of a request": b"GET /x",
    "another protocol": bytes.fromhex("16 03 01 02 00 01 00"),
    "a request of a page": b"GET / HTTP/1.1\r\n\r\n",
    "another method": b"POST / HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "a target that is not an address": HANDSHAKE.format(target="http://[").encode(),
    "a target with a host that is none": HANDSHAKE.format(target="//[/rtu?key=x").encode(),
    "a key in other bytes": HANDSHAKE.format(target="/rtu?key=x").encode().replace(b"=x", b"=\xff"),
    "a link in other bytes": HANDSHAKE.format(target="/r?{key}").encode().replace(b"/r", b"/\xff"),
    "a request": HANDSHAKE.format(target="/rtu?{key}").encode(),
    "a frame that is none": HANDSHAKE.format(target="/rtu?{key}").encode() + b"\xff" * 20,
    "a text that is none": HANDSHAKE.format(target="/rtu?{key}").encode() + bytes.fromhex("81 81 00 00 00 00 FF"),
    "a text": HANDSHAKE.format(target="/rtu?{key}").encode() + bytes.fromhex("81 81 00 00 00 00 41"),
}


def echo(link: str, carrier: WebSocket) -> None:
    """Sends back what comes, until the client leaves."""
    try:
        while True:
            if data := carrier.read(0.2):
                carrier.write(data)
    except CarrierError:
        carrier.close()


@pytest.mark.parametrize("resets", [False, True], ids=["closes", "resets"])
@pytest.mark.parametrize("name", SENT)
def test_nothing_is_said_of_a_client_that_leaves_at_once(
    name: str, resets: bool, caplog: pytest.LogCaptureFixture
) -> None:
    server = WebServer(0, {"rtu": False}, echo)
    threads = threading.active_count()
    key = server.address("rtu").rpartition("?")[2]
    for _ in range(20):
        with socket.create_connection(("127.0.0.1", server.port), 10) as connection:
            connection.sendall(SENT[name].replace(b"{key}", key.encode()))
            if resets:
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    wait_until(lambda: threading.active_count() <= threads)
    with connect(server.address("rtu")) as client:
        client.send(b"\x01\x03")
        assert client.recv(timeout=10) == b"\x01\x03"
    server.close()
    assert [record for record in caplog.records if record.levelno >= logging.WARNING] == []
