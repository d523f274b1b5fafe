"""One file from its bytes to batches of both tables: its kind is told, and it goes on where another run stopped."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any, BinaryIO

from fieldspec.captures.capture_files import CaptureError
from fieldspec.captures.decoding import MOST_TEXTS, Batch, DeviceDecoder, SourceDecoder
from fieldspec.captures.payloads import Names
from fieldspec.captures.register_rows import RegisterRows, columns_of
from fieldspec.captures.sources import LogSource, PacketSource, Source, is_capture

HEAD = 4096
CAPTURE, LOG, ROWS = "capture", "log", "rows"


def kind_of(head: bytes) -> str:
    """What a file is, from its first bytes. Raises CaptureError for one that is neither a capture nor a text."""
    if is_capture(head):
        return CAPTURE
    text = head.replace(b"\0", b"")
    is_wide = head[:2] in (b"\xff\xfe", b"\xfe\xff")
    controls = sum(byte < 32 and byte not in b"\t\r\n\x02\x03\x1b" for byte in (text if is_wide else head))
    if not head:
        raise CaptureError(0, "the file is empty")
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
        file.seek(0)
        kind = state["kind"] if state else kind_of(file.read(HEAD))
        own = state["source"] if state else None
        self.kind = kind
        names = Names(state["names"] if state else ())
        self.decoder = SourceDecoder(device, names)
        file.seek(_position(kind, own))
        self.rows: RegisterRows | None = None
        self.source: Source | None = None
        if kind == ROWS:
            self.rows = RegisterRows(file.readline, device, own)
        elif kind == LOG:
            links = [link.link for link in device.layout.links.values()]
            self.source = LogSource(file.readline, names, links, own)
        else:
            usual = {port for link in device.links for port in device.layout.links[link].link.ports}
            self.source = PacketSource(file.read, names, ports, own, usual)
        if state:
            self.decoder.restore(state["decoder"])

    @property
    def position(self) -> int:
        """The bytes of the file that are decoded."""
        return (self.source or self.rows).position  # type: ignore[union-attr]

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
        """Where it stands, as data that JSON can hold."""
        own = self.rows or self.source
        assert own is not None
        return {
            "kind": self.kind,
            "source": own.state(),
            "decoder": self.decoder.state(),
            "names": self.decoder.names.texts,
        }

    def counters(self) -> Counter[str]:
        """What this run has skipped, lost and noticed."""
        own = self.rows or self.source
        assert own is not None
        result: Counter[str] = Counter()
        for kind, counts in own.counters().items():
            for what, count in counts.items():
                result[f"{kind}: {what}"] += count
        for what, count in self.decoder.skipped.items():
            result[f"skipped: {what}"] += count
        return result

    def forget_texts(self) -> None:
        """Forgets texts once there are many of them, so that the memory does not grow with the file."""
        if len(self.device.texts.texts) > MOST_TEXTS:
            self.device.reset()
            self.decoder.refresh()


def _position(kind: str, state: dict[str, Any] | None) -> int:
    if state is None:
        return 0
    position: int = state["reader"]["position"] if kind == CAPTURE else state["position"]
    return position
