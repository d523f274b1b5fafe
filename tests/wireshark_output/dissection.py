"""Captures written packet by packet, and what tshark makes of them with the generated dissectors."""

from __future__ import annotations

import struct
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from bounded import HANGING
from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import Name
from fieldspec.targets.wireshark.backend import dissector

HEADERS = 42
"""The bytes of Ethernet, IP and UDP before the payload."""

FIRST_PORT = 2200
"""The port of the first link of a run; each of the others has the next one."""


class Packet(NamedTuple):
    """The payload of a UDP packet between a client and a device. Packets with the same client are a conversation."""

    client: int
    server: int
    direction: str
    payload: bytes


class Item(NamedTuple):
    """A field that tshark shows: its filter name, place in the payload, size, value and line of text."""

    name: str
    offset: int
    size: int
    value: str
    line: str


def pcap(packets: Iterable[Packet]) -> bytes:
    """A capture of Ethernet, a millisecond from packet to packet."""
    parts = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 1)]
    for number, packet in enumerate(packets):
        is_request = packet.direction == "request"
        ports = (packet.client, packet.server) if is_request else (packet.server, packet.client)
        hosts = (b"\x0a\0\0\1", b"\x0a\0\0\2") if is_request else (b"\x0a\0\0\2", b"\x0a\0\0\1")
        udp = struct.pack(">HHHH", *ports, 8 + len(packet.payload), 0) + packet.payload
        head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0) + b"".join(hosts)
        frame = bytes(12) + b"\x08\0" + head + udp
        parts += [struct.pack("<IIII", number // 1000, number % 1000 * 1000, len(frame), len(frame)), frame]
    return b"".join(parts)


def tshark(layouts: Sequence[DeviceLayout], capture: bytes, *options: str) -> subprocess.CompletedProcess[str]:
    """Runs tshark over a capture with the dissectors of some devices. Fails where any of them fails."""
    program = require_tool("tshark")
    with tempfile.TemporaryDirectory(prefix="fieldspec-tshark-") as folder:
        path = Path(folder) / "capture.pcap"
        path.write_bytes(capture)
        scripts = []
        for layout in layouts:
            script = Path(folder) / f"{Name.of(layout.device.id).snake()}.lua"
            script.write_text(dissector(layout), "utf-8")
            scripts += ["-X", f"lua_script:{script}"]
        run = subprocess.run(
            [program, "-n", "-r", str(path), *scripts, *options],
            capture_output=True,
            text=True,
            check=False,
            timeout=HANGING,
            env={"HOME": folder, "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"},
        )
    errors = [line for line in run.stderr.splitlines() if line and not line.startswith("Running as user")]
    assert run.returncode == 0, errors[:5]
    assert errors == []
    assert "Lua Error" not in run.stdout
    return run


@cache
def _names_of_wireshark() -> frozenset[str]:
    """The names of the protocols that tshark has without the dissectors."""
    run = subprocess.run([require_tool("tshark"), "-G", "protocols"], capture_output=True, text=True, check=True)
    return frozenset(line.split("\t")[2] for line in run.stdout.splitlines())


def prefix_of(layout: DeviceLayout) -> str:
    """The name of the protocol of a device: another one where Wireshark itself has one of that name."""
    name = Name.of(layout.device.id).snake()
    return f"{name}_device" if name in _names_of_wireshark() else name


def port_options(layout: DeviceLayout, ports: dict[tuple[str, str, str], int]) -> list[str]:
    """The preferences that attach the links of a device to the ports of a run, and the Decode As of messages."""
    device = prefix_of(layout)
    options = []
    for (owner, link, message), port in ports.items():
        if owner != layout.device.id:
            continue
        if message:
            options += ["-d", f"udp.port=={port},{device}_{link}_{message}"]
        else:
            options += ["-o", f"{device}.{link}_udp:{port}"]
    return options


def dissected(layouts: Sequence[DeviceLayout], packets: Sequence[Packet], options: Sequence[str]) -> list[list[Item]]:
    """The fields that tshark shows of each packet, in order, those of its own tree items only."""
    prefixes = " ".join(map(prefix_of, layouts))
    run = tshark(layouts, pcap(packets), "-T", "pdml", "-J", prefixes, *options)
    names = set(map(prefix_of, layouts))
    result: list[list[Item]] = []
    for packet in ElementTree.fromstring(run.stdout).iter("packet"):
        items = []
        for proto in packet.iter("proto"):
            if proto.get("name") in names:
                items += [_item(field) for field in proto.iter("field")]
        result.append(items)
    assert len(result) == len(packets)
    return result


def _item(field: ElementTree.Element) -> Item:
    attributes = {key: field.get(key, "") for key in ("name", "pos", "size", "show", "showname")}
    line = attributes["showname"] or attributes["show"]
    return Item(attributes["name"], int(attributes["pos"] or 0), int(attributes["size"] or 0), attributes["show"], line)
