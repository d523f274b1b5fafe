"""The payloads of TCP, UDP and serial lines in captured packets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from ipaddress import ip_address

import numpy as np
import numpy.typing as npt

from fieldspec.captures.capture_files import Interface, Packets
from fieldspec.captures.columns import Bytes, Mask, Numbers, number_at, numbers, runs
from fieldspec.captures.payloads import REQUEST, RESPONSE, UNKNOWN, Names
from fieldspec.classes import dataclass

ETHERNET, NULL, LOOP, COOKED, COOKED_2 = 1, 0, 108, 113, 276
BARE_IP = (12, 14, 101, 228, 229)
USER = range(147, 163)
"""The link types that are free for users: each packet is a frame of the line."""

RTAC_SERIAL = 250
"""Serial lines that a real-time automation controller records: 12 bytes of its own come first."""

CAN = 227
"""CAN buses as SocketCAN records them: the identifier with its flags, and the data, which may be filled up."""

CAN_HEADER, CAN_DATA, CAN_NO_DATA, CAN_FD = 8, 8, 0x60, 0x04
"""Bytes before the data and of the data, flags of remote requests and errors in the first byte, that of CAN FD."""

DATAGRAM, PIECE = -1, -2
"""In place of the number of the first byte: payloads that are sent as a unit, and pieces of a serial line."""

TCP, UDP = 6, 17
IPV4, IPV6, VLAN = 0x0800, 0x86DD, (0x8100, 0x88A8)


@dataclass(slots=True)
class Segments:
    """Payloads of packets before streams are put in order, as columns of equal length.

    `packet` is the number of the packet from 1, `stream` the place of the connection, `sequence` the number of the
    first byte in a stream of TCP, with the `flags` of TCP; both are DATAGRAM or PIECE for others.
    """

    at: Numbers
    size: Numbers
    time: Numbers
    packet: Numbers
    stream: Numbers
    direction: Numbers
    sequence: Numbers
    flags: Numbers


def concatenated(parts: Collection[Segments]) -> Segments:
    """Segments of several kinds in the order of their packets."""
    names = ("at", "size", "time", "packet", "stream", "direction", "sequence", "flags")
    columns = [np.concatenate([getattr(part, name) for part in parts] or [numbers([])]) for name in names]
    order = np.argsort(columns[3], kind="stable")
    return Segments(*(column[order] for column in columns))


class Network:
    """Finds the payloads in packets. `skipped` counts the packets that carry none, by the reason.

    `ports` are those of the devices, and nothing between other ones is taken. Where there are none, the side with one
    of the `usual` ports is the device, which are pairs of protocol and port; and where no side or both have one, that
    with the lower port. `names` are the connections, the client first.
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
        """The packets of serial lines. What is recorded without bytes, such as a change of a signal, has none."""
        at, size = packets.at[rows], packets.size[rows]
        direction = np.full(len(rows), UNKNOWN)
        if link_type == RTAC_SERIAL:
            whole = size >= 12
            self._skip("serial packets shorter than their header", ~whole)
            rows, at, size = rows[whole], at[whole], size[whole]
            direction = np.full(len(rows), UNKNOWN)
            at, size = at + 12, size - 12
        place = {each: self.names.place(f"serial {each}") for each in np.unique(packets.interface[rows]).tolist()}
        streams = numbers([place[each] for each in packets.interface[rows].tolist()])
        some = size > 0
        self._skip("packets without data", ~some)
        none = np.full(len(rows), PIECE)
        columns = (at, size, packets.time[rows], packet[rows], streams, direction, none, none)
        return Segments(*(column[some] for column in columns))

    def _can(self, packets: Packets, rows: Numbers, packet: Numbers) -> Segments:
        """The frames of CAN buses, without what fills them up. Each bus is one connection."""
        at, size = packets.at[rows], packets.size[rows]
        whole = size >= CAN_HEADER
        count = np.where(whole, number_at(packets.buffer, at + 4, 1), 0)
        whole &= size >= CAN_HEADER + count
        is_wide = (count > CAN_DATA) | ((number_at(packets.buffer, at + 5, 1) & CAN_FD) != 0)
        carries = (number_at(packets.buffer, at, 1) & CAN_NO_DATA) == 0
        self._skip("packets that the capture cut short", ~whole)
        self._skip("frames of CAN FD", whole & is_wide)
        self._skip("remote requests and errors of CAN buses", whole & ~is_wide & ~carries)
        some = whole & ~is_wide & carries
        place = {each: self.names.place(f"can {each}") for each in np.unique(packets.interface[rows]).tolist()}
        streams = numbers([place[each] for each in packets.interface[rows].tolist()])
        none, direction = np.full(len(rows), DATAGRAM), np.full(len(rows), UNKNOWN)
        columns = (at, CAN_HEADER + count, packets.time[rows], packet[rows], streams, direction, none, none)
        return Segments(*(column[some] for column in columns))

    def _skip(self, why: str, which: Mask) -> None:
        count = int(np.count_nonzero(which))
        if count:
            self.skipped[why] += count

    def _internet(self, packets: Packets, rows: Numbers, packet: Numbers, link_type: int) -> list[Segments]:
        buffer = packets.buffer
        at, end = packets.at[rows], packets.at[rows] + packets.size[rows]
        if link_type in BARE_IP:
            kind = np.where(number_at(buffer, at, 1) >> 4 == 6, IPV6, IPV4)
        elif link_type in (ETHERNET, COOKED, COOKED_2):
            kind_at = at + {ETHERNET: 12, COOKED: 14, COOKED_2: 0}[link_type]
            at = at + {ETHERNET: 14, COOKED: 16, COOKED_2: 20}[link_type]
            kind = number_at(buffer, kind_at, 2)
            for _ in range(2):
                tagged = np.isin(kind, VLAN) & (at + 4 <= end)
                kind = np.where(tagged, number_at(buffer, at + 2, 2), kind)
                at = at + 4 * tagged
        elif link_type in (NULL, LOOP):
            at = at + 4
            kind = np.where(number_at(buffer, at, 1) >> 4 == 6, IPV6, IPV4)
        else:
            self.skipped[f"packets of the unsupported link type {link_type}"] += len(rows)
            return []
        parts = []
        is_ip = np.isin(kind, (IPV4, IPV6)) & (at + 20 <= end)
        self._skip("packets other than IP", ~is_ip)
        for version, size in ((IPV4, 4), (IPV6, 16)):
            own = is_ip & (kind == version)
            if own.any():
                transport = self._transport(buffer, at[own], end[own], version)
                parts += self._ported(packets, rows[own], packet, size, *transport)
        return parts

    def _transport(
        self, buffer: Bytes, at: Numbers, end: Numbers, version: int
    ) -> tuple[Numbers, Numbers, Numbers, Numbers, Mask]:
        """Where addresses and data of IP packets begin, where the data end, the protocol, and which are whole."""
        if version == IPV4:
            head = (number_at(buffer, at, 1) & 15) * 4
            stop = at + number_at(buffer, at + 2, 2)
            stop = np.where(stop == at, end, stop)  # 0 where the network card divides packets
            protocol = number_at(buffer, at + 9, 1)
            fragment = (number_at(buffer, at + 6, 2) & 0x3FFF) != 0
            self._skip("fragments of IP packets", fragment)
            return at + 12, at + head, np.minimum(stop, end), protocol, ~fragment & (stop <= end) & (head >= 20)
        stop = at + 40 + number_at(buffer, at + 4, 2)
        protocol = number_at(buffer, at + 6, 1)
        return at + 8, at + 40, np.minimum(stop, end), protocol, (stop <= end) & (at + 40 <= end)

    def _ported(
        self,
        packets: Packets,
        rows: Numbers,
        packet: Numbers,
        address_size: int,
        addresses: Numbers,
        at: Numbers,
        stop: Numbers,
        protocol: Numbers,
        is_whole: Mask,
    ) -> list[Segments]:
        """The payloads of TCP and UDP. A packet that the capture cut short is skipped and counted."""
        self._skip("packets that the capture cut short", ~is_whole & np.isin(protocol, (TCP, UDP)))
        self._skip("packets other than TCP and UDP", ~np.isin(protocol, (TCP, UDP)))
        parts = []
        for kind, least in ((TCP, 20), (UDP, 8)):
            own = is_whole & (protocol == kind) & (at + least <= stop)
            if not own.any():
                continue
            place, buffer = at[own], packets.buffer
            sequence = flags = np.full(len(place), DATAGRAM)
            head = np.full(len(place), 8)
            if kind == TCP:
                sequence = number_at(buffer, place + 4, 4)
                head = (number_at(buffer, place + 12, 1) >> 4) * 4
                flags = number_at(buffer, place + 13, 1)
            size = np.maximum(stop[own] - place - head, 0)
            source, target = number_at(buffer, place, 2), number_at(buffer, place + 2, 2)
            ends = self._addresses(buffer, addresses[own], address_size)
            stream, direction = self._streams(kind, source, target, *ends)
            columns = (place + head, size, packets.time[rows[own]], packet[rows[own]], stream, direction)
            wanted = stream >= 0
            self._skip("packets of other ports", ~wanted)
            parts.append(Segments(*(column[wanted] for column in (*columns, sequence, flags))))
        return parts

    def _addresses(self, buffer: Bytes, at: Numbers, size: int) -> tuple[npt.NDArray[np.void], npt.NDArray[np.void]]:
        """The addresses of the sender and of the receiver as bytes."""
        data = buffer[at[:, None] + np.arange(2 * size)]
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
        places = range(table.shape[1])
        factors = numbers([0x9E3779B97F4A7C1 * (2 * place + 1) ^ 0x5BD1E995 << place for place in places])
        mixed = (table * factors).sum(axis=1)
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
