"""The payloads of TCP, UDP and serial lines in captured packets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from ipaddress import ip_address
from typing import Any

import numpy as np
import numpy.typing as npt

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.capture_files import Interface, Packets
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, number_at, numbers, runs
from fieldspec.tools.captures.payloads import DATAGRAM, PIECE, REQUEST, RESPONSE, STREAM, UNKNOWN, Carriers, Names

ETHERNET, NULL, LOOP, COOKED, COOKED_2 = 1, 0, 108, 113, 276
BARE_IP = (12, 14, 101, 228, 229)
USER = range(147, 163)
"""The link types that are free for users: each packet is a frame of the line."""

RTAC_SERIAL = 250
"""Serial lines that a real-time automation controller records: 12 bytes of its own come first."""

CAN = 227
"""CAN buses as SocketCAN records them: the identifier with its flags, and the data, which may be filled up."""

CAN_HEADER, CAN_DATA, CAN_REMOTE, CAN_ERROR, CAN_FD = 8, 8, 0x40, 0x20, 0x04
"""Bytes before the data and of the data, flags of remote requests and errors in the first byte, that of CAN FD."""

TCP, UDP = 6, 17
IPV4, IPV6, VLAN = 0x0800, 0x86DD, (0x8100, 0x88A8, 0x9100)
MOST_TAGS = 4

FRAGMENT, AUTHENTICATION = 44, 51
EXTENSIONS = (0, 43, FRAGMENT, AUTHENTICATION, 60, 135)
"""The headers between that of IPv6 and that of TCP or UDP; each begins with the kind of the next one, and its size."""

MOST_EXTENSIONS = 8

FACTOR = 0x9E3779B97F4A7C1
"""An odd number without a pattern, by whose powers the numbers of a connection become one, modulo 2^64."""

NO_DATA = "packets without data"
CUT_SHORT, BROKEN = "packets that the capture cut short", "packets whose headers contradict themselves"


@dataclass(slots=True)
class Segments:
    """Payloads of packets before streams are put in order, as columns of equal length.

    `length` is the size before the capture cut the packet short. `packet` is the number of the packet from 1, `stream`
    the place of the connection. Streams of TCP have the `sequence` number of the first byte, the number of the byte
    that the other side expects next, which it has `acknowledged`, and the `flags`; the three are -1 for others.
    """

    at: Numbers
    size: Numbers
    length: Numbers
    time: Numbers
    packet: Numbers
    stream: Numbers
    direction: Numbers
    carrier: Carriers
    sequence: Numbers
    acknowledged: Numbers
    flags: Numbers

    def columns(self) -> tuple[npt.NDArray[Any], ...]:
        """All columns in their order."""
        return (
            self.at, self.size, self.length, self.time, self.packet, self.stream, self.direction, self.carrier,
            self.sequence, self.acknowledged, self.flags,
        )  # fmt: skip

    def rows(self, rows: Numbers | Mask) -> Segments:
        """The segments in some rows."""
        return Segments(*(column[rows] for column in self.columns()))


_NONE = numbers([])
NO_SEGMENTS = Segments(_NONE, _NONE, _NONE, _NONE, _NONE, _NONE, _NONE, np.zeros(0, np.int8), _NONE, _NONE, _NONE)


def concatenated(parts: Sequence[Segments]) -> Segments:
    """Segments of several kinds in the order of their packets."""
    if len(parts) == 1:
        return parts[0]
    columns = zip(*(part.columns() for part in (NO_SEGMENTS, *parts)), strict=True)
    segments = Segments(*map(np.concatenate, columns))
    return segments.rows(np.argsort(segments.packet, kind="stable"))


@dataclass(frozen=True, slots=True)
class _Transport:
    """What IP packets carry, one row each: the packets' `rows`, where their `addresses` of `address_size` bytes are,
    where the data begin, where the captured bytes `end`, and where the data `stop`."""

    rows: Numbers
    addresses: Numbers
    address_size: int
    at: Numbers
    end: Numbers
    stop: Numbers
    protocol: Numbers


def _lines(
    packets: Packets,
    rows: Numbers,
    packet: Numbers,
    offsets: Numbers,
    size: Numbers,
    length: Numbers,
    streams: Numbers,
    carrier: int,
) -> Segments:
    """The traffic of lines and buses, whose direction is unknown."""
    none, carriers = np.full(len(rows), -1), np.full(len(rows), carrier, np.int8)
    direction = np.full(len(rows), UNKNOWN)
    return Segments(
        offsets, size, length, packets.time[rows], packet[rows], streams, direction, carriers, none, none, none
    )


class Network:
    """Finds the payloads in packets. `skipped` counts the packets that carry none, by the reason.

    `ports` are the ports of the devices; traffic between other ports is ignored. Where there are none, the side with
    one of the `usual` ports is the device, which are pairs of protocol and port; and where no side or both have one,
    that with the lower port. `names` are the connections, the client first.
    """

    def __init__(self, ports: Collection[int], names: Names, usual: Collection[tuple[str, int]] = ()) -> None:
        self.ports, self.names, self.usual = numbers(sorted(ports)), names, frozenset(usual)
        self.skipped: Counter[str] = Counter()

    def segments(self, packets: Packets, interfaces: list[Interface], first: int) -> Segments:
        """The payloads of packets, of which the first one has the number `first`."""
        packet = np.arange(first, first + len(packets.at))
        types = numbers([own.link_type for own in interfaces])[packets.interface]
        parts = []
        for link_type, rows in runs(types):
            if link_type in USER or link_type == RTAC_SERIAL:
                parts.append(self._serial(packets, rows, packet, link_type))
            elif link_type == CAN:
                parts.append(self._can(packets, rows, packet))
            else:
                parts += self._internet(packets, rows, packet, link_type)
        return concatenated(parts)

    def _serial(self, packets: Packets, rows: Numbers, packet: Numbers, link_type: int) -> Segments:
        """The packets of serial lines. Records without bytes, such as a change of a signal, have no packet."""
        offsets, size = packets.at[rows], packets.size[rows]
        if link_type == RTAC_SERIAL:
            whole = size >= 12
            self._skip("serial packets shorter than their header", ~whole)
            rows, offsets, size = rows[whole], offsets[whole] + 12, size[whole] - 12
        length = size + np.maximum(packets.original[rows] - packets.size[rows], 0)
        has_data = length > 0
        self._skip(NO_DATA, ~has_data)
        return _lines(
            packets, rows, packet, offsets, size, length, self._interfaces(packets, rows, "serial"), PIECE
        ).rows(has_data)

    def _interfaces(self, packets: Packets, rows: Numbers, kind: str) -> Numbers:
        """The connection of each packet: its interface."""
        own = packets.interface[rows].tolist()
        place = {interface: self.names.place(f"{kind} {interface}") for interface in sorted(set(own))}
        return numbers([place[interface] for interface in own])

    def _can(self, packets: Packets, rows: Numbers, packet: Numbers) -> Segments:
        """The frames of CAN buses, without what fills them up. Each bus is one connection."""
        offsets, size = packets.at[rows], packets.size[rows]
        whole = size >= CAN_HEADER
        count = np.where(whole, number_at(packets.buffer, offsets + 4, 1), 0)
        flags = number_at(packets.buffer, offsets, 1)
        data = np.where((flags & CAN_REMOTE) != 0, 0, count)
        whole &= size >= CAN_HEADER + data
        is_wide = (count > CAN_DATA) | ((number_at(packets.buffer, offsets + 5, 1) & CAN_FD) != 0)
        carries = (flags & CAN_ERROR) == 0
        self._skip(CUT_SHORT, ~whole)
        self._skip("frames of CAN FD", whole & is_wide)
        self._skip("errors of CAN buses", whole & ~is_wide & ~carries)
        is_taken = whole & ~is_wide & carries
        length, streams = CAN_HEADER + data, self._interfaces(packets, rows, "can")
        return _lines(packets, rows, packet, offsets, length, length, streams, DATAGRAM).rows(is_taken)

    def _skip(self, reason: str, rows: Mask) -> None:
        count = int(np.count_nonzero(rows))
        if count:
            self.skipped[reason] += count

    def _internet(self, packets: Packets, rows: Numbers, packet: Numbers, link_type: int) -> list[Segments]:
        buffer = packets.buffer
        offsets, end = packets.at[rows], packets.at[rows] + packets.size[rows]
        if link_type in BARE_IP:
            kind = np.where(number_at(buffer, offsets, 1) >> 4 == 6, IPV6, IPV4)
        elif link_type in (ETHERNET, COOKED, COOKED_2):
            kind_at = offsets + {ETHERNET: 12, COOKED: 14, COOKED_2: 0}[link_type]
            offsets = offsets + {ETHERNET: 14, COOKED: 16, COOKED_2: 20}[link_type]
            kind = number_at(buffer, kind_at, 2)
            for _ in range(MOST_TAGS):
                tagged = np.isin(kind, VLAN) & (offsets + 4 <= end)
                kind = np.where(tagged, number_at(buffer, offsets + 2, 2), kind)
                offsets = offsets + 4 * tagged
        elif link_type in (NULL, LOOP):
            offsets = offsets + 4
            kind = np.where(number_at(buffer, offsets, 1) >> 4 == 6, IPV6, IPV4)
        else:
            self.skipped[f"packets of the unsupported link type {link_type}"] += len(rows)
            return []
        parts = []
        is_ip = np.isin(kind, (IPV4, IPV6))
        self._skip("packets other than IP", ~is_ip)
        self._skip(CUT_SHORT, is_ip & (offsets + np.where(kind == IPV4, 20, 40) > end))
        for version, head in ((IPV4, 20), (IPV6, 40)):
            own = np.flatnonzero((kind == version) & (offsets + head <= end))
            if len(own):
                transport = self._transport(buffer, offsets[own], end[own], version)
                parts += self._ported(packets, rows[own], packet, transport)
        return parts

    def _transport(self, buffer: Bytes, offsets: Numbers, end: Numbers, version: int) -> _Transport:
        """What IP packets carry. Their headers say where the data end; the capture may have less."""
        if version == IPV4:
            head = (number_at(buffer, offsets, 1) & 15) * 4
            stop = offsets + number_at(buffer, offsets + 2, 2)
            stop = np.where(stop == offsets, end, stop)  # 0 where the network card divides packets
            is_fragment = (number_at(buffer, offsets + 6, 2) & 0x3FFF) != 0
            self._skip("fragments of IP packets", is_fragment)
            is_broken = ~is_fragment & (head < 20)
            self._skip(BROKEN, is_broken)
            own = np.flatnonzero(~is_fragment & ~is_broken)
            return _Transport(
                own,
                offsets[own] + 12,
                4,
                (offsets + head)[own],
                end[own],
                stop[own],
                number_at(buffer, offsets[own] + 9, 1),
            )
        size = number_at(buffer, offsets + 4, 2)
        stop = np.where(size == 0, end, offsets + 40 + size)
        protocol, place = number_at(buffer, offsets + 6, 1), offsets + 40
        is_fragment = np.zeros(len(offsets), np.bool_)
        for _ in range(MOST_EXTENSIONS):
            extended = np.isin(protocol, EXTENSIONS) & ~is_fragment & (place + 8 <= end)
            if not extended.any():
                break
            units = number_at(buffer, place + 1, 1)
            is_fragment |= extended & (protocol == FRAGMENT) & ((number_at(buffer, place + 2, 2) & 0xFFF9) != 0)
            units = np.where(
                protocol == AUTHENTICATION, 4 * units + 8, np.where(protocol == FRAGMENT, 8, 8 * units + 8)
            )
            protocol = np.where(extended, number_at(buffer, place, 1), protocol)
            place = place + units * extended
        self._skip("fragments of IP packets", is_fragment)
        own = np.flatnonzero(~is_fragment)
        return _Transport(own, offsets[own] + 8, 16, place[own], end[own], stop[own], protocol[own])

    def _ported(self, packets: Packets, rows: Numbers, packet: Numbers, ip: _Transport) -> list[Segments]:
        """The payloads of TCP and UDP. A datagram that the capture cut short is skipped and counted."""
        rows = rows[ip.rows]
        self._skip("packets other than TCP and UDP", ~np.isin(ip.protocol, (TCP, UDP)))
        parts = []
        for kind, header_size in ((TCP, 20), (UDP, 8)):
            of_kind = ip.protocol == kind
            missing = of_kind & (ip.at + header_size > ip.end) | (
                of_kind & (ip.stop > ip.end) if kind == UDP else False
            )
            self._skip(CUT_SHORT, missing)
            is_broken = of_kind & ~missing & (ip.at + header_size > ip.stop)
            self._skip(BROKEN, is_broken)
            own = np.flatnonzero(of_kind & ~missing & ~is_broken)
            if not len(own):
                continue
            place, stop, buffer = ip.at[own], ip.stop[own], packets.buffer
            sequence = acknowledged = flags = np.full(len(own), -1)
            head = np.full(len(own), 8)
            if kind == TCP:
                sequence, acknowledged = number_at(buffer, place + 4, 4), number_at(buffer, place + 8, 4)
                head = (number_at(buffer, place + 12, 1) >> 4) * 4
                flags = number_at(buffer, place + 13, 1)
            length = np.maximum(stop - place - head, 0)
            size = np.clip(ip.end[own] - place - head, 0, length)
            source, target = number_at(buffer, place, 2), number_at(buffer, place + 2, 2)
            ends = self._addresses(buffer, ip.addresses[own], ip.address_size)
            stream, direction = self._streams(kind, source, target, *ends)
            carrier = np.full(len(own), STREAM if kind == TCP else DATAGRAM, np.int8)
            segments = Segments(
                place + head, size, length, packets.time[rows[own]], packet[rows[own]], stream, direction, carrier,
                sequence, acknowledged, flags,
            )  # fmt: skip
            is_wanted = stream >= 0
            self._skip("packets of other ports", ~is_wanted)
            parts.append(segments if is_wanted.all() else segments.rows(is_wanted))
        return parts

    def _addresses(
        self, buffer: Bytes, offsets: Numbers, size: int
    ) -> tuple[npt.NDArray[np.void], npt.NDArray[np.void]]:
        """The addresses of the sender and of the receiver as bytes."""
        data = buffer[offsets[:, None] + np.arange(2 * size)]
        halves = (np.ascontiguousarray(data[:, :size]), np.ascontiguousarray(data[:, size:]))
        return halves[0].view(f"V{size}").ravel(), halves[1].view(f"V{size}").ravel()

    def _streams(
        self,
        kind: int,
        source: Numbers,
        target: Numbers,
        sender: npt.NDArray[np.void],
        receiver: npt.NDArray[np.void],
    ) -> tuple[Numbers, Numbers]:
        """The connection of each packet, -1 for one between other ports, and its direction."""
        words = sender.dtype.itemsize // 4
        table = np.empty((len(source), 1 + 2 * words), np.int64)
        table[:, 0] = source << 16 | target
        table[:, 1 : 1 + words] = sender.view(">u4").reshape(-1, words)
        table[:, 1 + words :] = receiver.view(">u4").reshape(-1, words)
        factors = [pow(FACTOR, place, 1 << 64) for place in range(1, 1 + table.shape[1])]
        mixed = (table * np.array(factors, np.uint64).view(np.int64)).sum(axis=1)
        _, first, group = np.unique(mixed ^ mixed >> 29, return_index=True, return_inverse=True)
        if not bool((table == table[first][group]).all()):  # two connections with one mixed number: compare the rows
            _, first, group = np.unique(table, axis=0, return_index=True, return_inverse=True)
        streams, directions = numbers(np.zeros(len(first))), numbers(np.zeros(len(first)))
        for number, row in sorted(enumerate(first.tolist()), key=lambda item: item[1]):
            left = ip_address(bytes(sender[row])), int(source[row])
            right = ip_address(bytes(receiver[row])), int(target[row])
            streams[number], directions[number] = self._stream(kind, left, right)
        return streams[group.ravel()], directions[group.ravel()]

    def _stream(self, kind: int, left: tuple[object, int], right: tuple[object, int]) -> tuple[int, int]:
        protocol = "tcp" if kind == TCP else "udp"
        is_usual = [(protocol, side[1]) in self.usual for side in (left, right)]
        is_request = is_usual[1] if is_usual[0] != is_usual[1] else left[1] >= right[1]
        if len(self.ports):
            known = np.isin((left[1], right[1]), self.ports)
            if not known.any():
                return -1, UNKNOWN
            if known[0] != known[1]:
                is_request = bool(known[1])
        client, server = (left, right) if is_request else (right, left)
        texts = [f"[{host}]:{port}" if ":" in str(host) else f"{host}:{port}" for host, port in (client, server)]
        name = f"{protocol} {texts[0]} {texts[1]}"
        return self.names.place(name), REQUEST if is_request else RESPONSE
