"""One file from its bytes to batches of both tables: its type is detected, and it continues where
another run stopped.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any, BinaryIO

from fieldspec.tools.captures.capture_files import CaptureError
from fieldspec.tools.captures.decoding import MOST_TEXTS, Batch, DeviceDecoder, SourceDecoder
from fieldspec.tools.captures.file_content import FileContent, is_capture
from fieldspec.tools.captures.network import NO_DATA
from fieldspec.tools.captures.payloads import Names
from fieldspec.tools.captures.register_rows import RegisterRows, columns_of
from fieldspec.tools.captures.sources import Lines, LogSource, PacketSource, Source

HEAD = 4096
DAMAGE = "damage"
PACKED = {b"\x28\xb5\x2f\xfd": "zstd", b"\x04\x22\x4d\x18": "lz4", b"\xfd7zX": "xz", b"BZh": "bzip2", b"PK\3\4": "zip"}
"""What other packed files begin with."""

CAPTURE, LOG, ROWS = "capture", "log", "rows"


def kind_of(head: bytes) -> str:
    """The type of a file, from its first bytes. Raises CaptureError for one that is neither a capture nor a text."""
    if is_capture(head):
        return CAPTURE
    text = head.replace(b"\0", b"")
    is_wide = head[:2] in (b"\xff\xfe", b"\xfe\xff")
    controls = sum(byte < 32 and byte not in b"\t\r\n\x02\x03\x1b" for byte in (text if is_wide else head))
    if not head:
        raise CaptureError(0, "the file is empty")
    for magic, program in PACKED.items():
        if head.startswith(magic):
            raise CaptureError(0, f"{program} has packed the file; unpack it, or pack it with gzip")
    if controls * 50 > len(head):
        raise CaptureError(0, f"the file begins with {head[:4].hex(' ').upper()}: neither a capture nor a text")
    first = text.decode("utf-8", "replace").removeprefix("\ufeff").partition("\n")[0]
    return ROWS if columns_of(first) is not None else LOG


class Conversion:
    """The decoding of one file, which stands where `state` says, else at its beginning."""

    def __init__(
        self, file: BinaryIO, device: DeviceDecoder, ports: Collection[int], state: dict[str, Any] | None = None
    ) -> None:
        self.device = device
        kind = state["kind"] if state else _kind(FileContent(file))
        own = state["source"] if state else None
        self.kind = kind
        names = Names(state["names"] if state else ())
        self.decoder = SourceDecoder(device, names)
        self.content = content = FileContent(file)
        position = _position(kind, own)
        content.skip(position)
        self.rows: RegisterRows | None = None
        self.source: Source | None = None
        if kind == ROWS:
            self.rows = RegisterRows(Lines(content.readline, position, content.rest), device, own)
        elif kind == LOG:
            links = [link.link for link in device.layout.links.values()]
            self.source = LogSource(Lines(content.readline, position, content.rest), names, links, own)
        else:
            usual = {port for link in device.links for port in device.layout.links[link].link.ports}
            self.source = PacketSource(content.read, names, ports, own, usual, content.rest)
        if state:
            self.decoder.restore(state["decoder"])

    @property
    def position(self) -> int:
        """The bytes of the file that are decoded."""
        return self.content.position if self.content.is_packed else self._own.position

    @property
    def _own(self) -> RegisterRows | Source:
        own = self.rows or self.source
        assert own is not None
        return own

    @property
    def is_left_out(self) -> bool:
        """Whether there was something to decode, and no byte of it is in a frame."""
        frames = self.rows.frame if self.rows is not None else self.decoder.number
        left_out = (remark.partition(": ") for remark, count in self.counters().items() if count)
        return not frames and any(kind in ("skipped", "events") and remark != NO_DATA for kind, _, remark in left_out)

    def batches(self) -> Iterator[list[Batch]]:
        """The batches of the file in lists; between two of them, `state` says where it stands. Raises CaptureError."""
        if self.rows is not None:
            yield from self.rows.batches()
            return
        assert self.source is not None
        for payloads in self.source.payloads():
            yield self.decoder.decode(payloads)
        yield self.decoder.rest()

    def state(self) -> dict[str, Any]:
        """The state of the conversion, as data that JSON can express."""
        return {
            "kind": self.kind,
            "source": self._own.state(),
            "decoder": self.decoder.state(),
            "names": self.decoder.names.texts,
        }

    def counters(self) -> Counter[str]:
        """What this run has skipped, lost and noticed."""
        result: Counter[str] = Counter()
        if self.content.damage:
            result[f"{DAMAGE}: {self.content.damage}"] = 1
        for kind, counts in self._own.counters().items():
            for remark, count in counts.items():
                result[f"{kind}: {remark}"] += count
        for remark, count in self.decoder.skipped.items():
            result[f"skipped: {remark}"] += count
        return result

    def forget_texts(self) -> None:
        """Forgets texts once there are many of them, so that the memory does not grow with the file."""
        if len(self.device.texts.texts) > MOST_TEXTS:
            self.device.reset()
            self.decoder.refresh()


def _kind(content: FileContent) -> str:
    """The type of a file, from its content. Raises CaptureError."""
    head = content.read(HEAD)
    if not head and content.damage:
        raise CaptureError(0, content.damage)
    return kind_of(head)


def _position(kind: str, state: dict[str, Any] | None) -> int:
    if state is None:
        return 0
    position: int = state["reader"]["position"] if kind == CAPTURE else state["position"]
    return position
