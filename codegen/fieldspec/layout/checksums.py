"""The checks that close a frame, by the names that specs give them."""

from __future__ import annotations

from collections.abc import Callable, Mapping


def _crc16_modbus(data: bytes) -> int:
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return crc


CHECKSUMS: Mapping[str, Callable[[bytes], int]] = {
    "crc16_modbus": _crc16_modbus,
    "lrc": lambda data: -sum(data) & 0xFF,
    "sum8": lambda data: sum(data) & 0xFF,
}
