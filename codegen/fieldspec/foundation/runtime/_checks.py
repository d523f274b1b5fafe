"""Checksums.

A CRC is linear in the bits of its data, so the term of a byte depends only on the byte and on how many bytes follow:
`CRC[d][byte]` is the term of a byte that `d` bytes follow. Frames of fixed length need one look-up for each byte that
varies; other data need eight look-ups for eight bytes at once. `CRC_EXCHANGED` has the same terms with their two bytes
exchanged, for Structs whose byte order differs from that of the checksum.
"""

from __future__ import annotations

from struct import Struct

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._typing import Data


def _tables() -> list[list[int]]:
    bits, term = [], 1
    for _ in range(8):
        term = term >> 1 ^ (0xA001 if term & 1 else 0)
        bits.append(term)
    table = [0]
    for term in reversed(bits):
        table += [term ^ other for other in table]
    tables = [table]
    for _ in range(7):
        tables.append([crc >> 8 ^ table[crc & 0xFF] for crc in tables[-1]])
    return tables


_TABLES = _tables()
CRC = tuple(map(tuple, _TABLES))
CRC_EXCHANGED = tuple(tuple((crc & 0xFF) << 8 | crc >> 8 for crc in table) for table in _TABLES)
BYTES = tuple(bytes((number,)) for number in range(256))
_T0, _T1, _T2, _T3, _T4, _T5, _T6, _T7 = CRC
_EIGHTS = Struct("<H6B").iter_unpack


def _starts() -> list[tuple[bytes, int]]:
    """Zeros to prepend to data, from none to seven, each with the start value that these zeros turn into 0xFFFF."""
    highs = {crc >> 8: byte for byte, crc in enumerate(_T0)}
    crc, starts = 0xFFFF, []
    for number in range(8):
        starts.append((bytes(number), crc))
        byte = highs[crc >> 8]
        crc = (crc ^ _T0[byte]) << 8 & 0xFFFF | byte
    return starts


_STARTS = _starts()


def crc16_modbus(data: Data) -> int:
    """CRC-16 with polynomial 0xA001, reflected, start value 0xFFFF.

    It is sent low byte first, so the CRC over data and their CRC is 0.
    """
    zeros, crc = _STARTS[-len(data) % 8]
    for word, c, d, e, f, g, h in _EIGHTS(zeros + data):
        crc ^= word
        crc = _T7[crc & 0xFF] ^ _T6[crc >> 8] ^ _T5[c] ^ _T4[d] ^ _T3[e] ^ _T2[f] ^ _T1[g] ^ _T0[h]
    return crc


def lrc(data: Data) -> int:
    """The two's complement of the sum of all bytes, 8 bits."""
    return -sum(data) & 0xFF


def sum8(data: Data) -> int:
    """The low byte of the sum of all bytes."""
    return sum(data) & 0xFF
