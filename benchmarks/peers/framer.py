"""A framer for Modbus RTU requests as people write it by hand: a buffer, the length by the function code, the CRC."""

from __future__ import annotations

from peers.modbus import crc16

STATIONS = frozenset(range(17))


class Framer:
    """Takes bytes as they come and gives whole requests with a right CRC; drops a byte where none begins."""

    def __init__(self) -> None:
        self.buffer = bytearray()
        self.dropped = 0

    def feed(self, data: bytes) -> list[bytes]:
        """The requests that these bytes complete."""
        buffer = self.buffer
        buffer += data
        frames = []
        at, size = 0, len(buffer)
        while size - at >= 8:
            function = buffer[at + 1]
            if buffer[at] not in STATIONS:
                length = 0
            elif function == 3 or function == 6:
                length = 8
            elif function == 16:
                length = 9 + buffer[at + 6]
                if length > 127:
                    length = 0
            else:
                length = 0
            if length:
                if at + length > size:
                    break
                frame = bytes(buffer[at : at + length])
                if crc16(frame[:-2]) == frame[-2] | frame[-1] << 8:
                    frames.append(frame)
                    at += length
                    continue
            at += 1
            self.dropped += 1
        del buffer[:at]
        return frames
