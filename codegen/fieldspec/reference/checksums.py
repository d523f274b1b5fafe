"""Check algorithms, bit by bit as the standards define them. Slow on purpose: they judge the fast ones."""

from __future__ import annotations


def crc16_modbus(data: bytes) -> int:
    """CRC-16 with polynomial 0xA001, reflected, start value 0xFFFF."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return crc


def lrc(data: bytes) -> int:
    """The two's complement of the sum of all bytes."""
    return -sum(data) & 0xFF


def sum8(data: bytes) -> int:
    """The low byte of the sum of all bytes."""
    return sum(data) & 0xFF


ALGORITHMS = {"crc16_modbus": crc16_modbus, "lrc": lrc, "sum8": sum8}
