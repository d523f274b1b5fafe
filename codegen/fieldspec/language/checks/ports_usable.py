"""Frames on a TCP port have an identifiable end, and each port belongs to one link.

Why: a TCP connection is a stream of bytes. Without a length, a code, a delimiter or a checksum it is unknown where a
frame ends in it. If two links state one port, its frames can belong to either.

Example: `network: {tcp: 4001}` at a link whose frames contain only data.

Fix: State `udp` in place of `tcp` if each datagram is a frame. State a port only at the link whose frames it carries.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.link import Link

_ENDING = ("length", "code", "checksum")
"""The roles of parts that determine the end of a frame."""


def ports_usable(device: Device) -> Findings:
    owners: dict[tuple[str, int], str] = {}
    for link in device.links.values():
        if link.is_can:
            continue
        for protocol, port in link.ports:
            if protocol == "tcp" and any(not _is_ended(link, direction) for direction in ("request", "response")):
                text = f"the end of a {link.name} frame in a TCP connection is unknown"
                help = "state `udp` in place of `tcp` if each datagram is a frame"
                yield finding(link.place, "network", text, help)
            owner = owners.setdefault((protocol, port), link.name)
            if owner != link.name:
                text = f"{link.name} and {owner} have the same {protocol.upper()} port {port}"
                help = "state the port at the link whose frames it carries"
                yield finding(link.place, "network", text, help)


def _is_ended(link: Link, direction: str) -> bool:
    return any(link.delimiters(direction)) or any(part.role in _ENDING for part in link.parts(direction))
