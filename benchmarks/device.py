"""Requests a second: the simulated device beside pymodbus' server, the generated client beside pymodbus' client.

Servers are processes of their own, and both sides of a row talk over TCP on this machine. The clock counts, since
waiting is a part of the work; both sides take turns.
"""

from __future__ import annotations

import re
import socket
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from importlib.metadata import version
from itertools import repeat
from pathlib import Path
from statistics import median
from time import perf_counter

from rows import ROOT, Row, printed, use_generated

use_generated()

GROUP = "Modbus RTU over TCP"
PEERS = Path(__file__).parent / "peers"
REQUEST = bytes.fromhex("01 03 10 00 00 01 80 CA")
BATCH, ROUNDS = 200, 15


@contextmanager
def served(*command: str) -> Iterator[int]:
    """The port of a server, which is a process of its own."""
    process = subprocess.Popen(
        [sys.executable, *command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=ROOT
    )
    try:
        assert process.stdout is not None
        match = re.search(r"(\d+)\s*$", process.stdout.readline())
        assert match is not None
        yield int(match[1])
    finally:
        process.kill()
        process.wait()


def asker(port: int, requests: Iterable[bytes] = repeat(REQUEST), size: int = 7) -> Callable[[], object]:
    """A call that sends the next request, and receives the whole answer."""
    due = iter(requests)
    connection = socket.create_connection(("127.0.0.1", port), 5)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def ask() -> object:
        connection.sendall(next(due))
        data = b""
        while len(data) < size:
            data += connection.recv(256)
        return data

    return ask


def compared(ours: Callable[[], object], peer: Callable[[], object]) -> tuple[list[float], list[float]]:
    """The seconds of each request of ours and of the peer, in turns."""
    took: tuple[list[float], list[float]] = ([], [])
    for turn in range(ROUNDS):
        pairs = [(ours, took[0]), (peer, took[1])]
        for call, times in pairs if turn % 2 else pairs[::-1]:
            for _ in range(BATCH):
                begin = perf_counter()
                call()
                times.append(perf_counter() - begin)
    return took


def rates(name: str, peer: str, times: tuple[list[float], list[float]], **goal: float) -> Iterator[Row]:
    """The rows of requests a second, and of the longest pause."""
    mine, other = (1 / median(seconds) for seconds in times)
    figures = round(mine), round(other), "/s", round(mine / other, 3)
    yield Row(GROUP, f"{name}, requests a second", peer, *figures, **goal)
    mine, other = (1000 * max(seconds) for seconds in times)
    figures = round(mine, 2), round(other, 2), "ms", round(mine / other, 3)
    yield Row(GROUP, f"{name}, longest of {BATCH * ROUNDS:,}", peer, *figures)


def rows() -> Iterator[Row]:
    """The rows."""
    from pymodbus import FramerType
    from pymodbus.client import ModbusTcpClient

    from fieldspec_devices import tc100, transports
    from fieldspec_devices.tc100 import client

    positions = (tc100.write_request(tc100.PRESET_POSITION, number) for number in range(BATCH * ROUNDS))
    writes = [tc100.rtu.encode_request(1, request) for request in positions]
    known = version("pymodbus")
    simulate = ("-m", "fieldspec", "simulate", "tc100", "--port", "rtu=tcp://127.0.0.1:0")
    with served(*simulate) as ours, served(str(PEERS / "modbus_server.py")) as peer:
        server = f"pymodbus {known}, server"
        yield from rates("simulated device", server, compared(asker(ours), asker(peer)), at_least=1.0)
        both = (asker(port, writes, 8) for port in (ours, peer))
        name = "simulated device, each time another position written"
        yield from rates(name, server, compared(*both), at_least=1.0)
    answering = str(PEERS / "answering.py")
    with served(answering) as own, served(answering) as other, transports.tcp("127.0.0.1", own) as transport:
        generated = client.Client(transport, link="rtu", pause=0.0)
        library = ModbusTcpClient("127.0.0.1", port=other, framer=FramerType.RTU)
        assert library.connect()

        def read() -> object:
            return generated.read(tc100.MOTION_SPEED)

        def read_by_library() -> object:
            return library.read_holding_registers(0x2014, count=1, device_id=1).registers[0]

        assert read() == read_by_library() == 5
        yield from rates("generated client", f"pymodbus {known}, client", compared(read, read_by_library))
        library.close()


if __name__ == "__main__":
    printed(rows())
