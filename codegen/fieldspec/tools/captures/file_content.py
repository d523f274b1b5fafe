"""The content of a file: its bytes, or what they unpack to where gzip has packed them, a buffer of it at a time."""

from __future__ import annotations

import gzip
import io
import zlib
from typing import Any, BinaryIO

MAGIC = b"\x1f\x8b"
CAPTURES = (b"\xd4\xc3\xb2\xa1", b"\xa1\xb2\xc3\xd4", b"\x4d\x3c\xb2\xa1", b"\xa1\xb2\x3c\x4d", b"\x0a\x0d\x0d\x0a")
"""What captures begin with: pcap in both orders and units of time, and pcapng."""

BUFFER = 1 << 16


def is_capture(head: bytes) -> bool:
    """Whether a file begins like a capture."""
    return head[:4] in CAPTURES


class _Unpacker(io.RawIOBase):
    """The unpacked bytes of a file, up to where it is damaged: `damage` says how. A buffer of them is in memory."""

    def __init__(self, file: BinaryIO) -> None:
        super().__init__()
        self.file = gzip.GzipFile(fileobj=file)
        self.damage = ""

    def readable(self) -> bool:
        """As `io` asks."""
        return True

    def readinto(self, buffer: Any) -> int:
        """Unpacks at most the bytes that fit into a buffer; none at the end, and after damage."""
        data = b""
        if not self.damage:
            try:
                data = self.file.read1(len(buffer))
            except EOFError:
                self.damage = "the compressed data ends too early"
            except (gzip.BadGzipFile, zlib.error) as error:
                self.damage = f"the compressed data is broken: {error}"
        buffer[: len(data)] = data
        return len(data)


class FileContent:
    """A file from its beginning. `read` and `readline` take its content; `position` counts the bytes of the file."""

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        file.seek(0)
        self.unpacker = _Unpacker(file) if file.read(len(MAGIC)) == MAGIC else None
        file.seek(0)
        content = file if self.unpacker is None else io.BufferedReader(self.unpacker, BUFFER)
        self.read, self.readline = content.read, content.readline

    @property
    def is_packed(self) -> bool:
        """Whether the file is packed by gzip."""
        return self.unpacker is not None

    @property
    def position(self) -> int:
        """The number of bytes of the file that have been read."""
        return self.file.tell()

    @property
    def damage(self) -> str:
        """Why what follows cannot be unpacked; empty where nothing is wrong."""
        return self.unpacker.damage if self.unpacker is not None else ""

    def skip(self, size: int) -> None:
        """Continues after that number of bytes of the content."""
        if self.unpacker is None:
            self.file.seek(size)
            return
        while size > 0 and (data := self.read(min(size, BUFFER))):
            size -= len(data)

    def rest(self) -> int:
        """The bytes of the file that are not read: packed ones, where it is packed."""
        position = self.position
        return max(self.file.seek(0, io.SEEK_END) - position, 0)
