"""Copies of captures, dumps and scans of a unit without identifying data.

Only the meaning of a file's frames, words and counts is copied: no addresses of a network, no names, no comments, no
bytes between frames. Times begin with 0.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.spreadsheet import csv_text
from fieldspec.tools.audit.register_dump import compared
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.lists.dump import Dump

if TYPE_CHECKING:
    from fieldspec.tools.captures.decoding import Batch, DeviceDecoder

_NO_TIME = -(1 << 63)
_MARKS = {"request": ">", "response": "<"}


class RedactedCapture:
    """The frames of a capture or a log, as the lines of a log for each connection; `left_out` counts the others."""

    def __init__(self, redaction: Redaction, decoder: DeviceDecoder) -> None:
        self.redaction, self.decoder = redaction, decoder
        self.lines: dict[int, list[str]] = {}
        self.rows: list[tuple[str, ...]] = []
        self.left_out: Counter[str] = Counter()
        self.frames = 0
        self._begin: int | None = None
        self._asked: dict[int, Mapping[str, Any]] = {}

    def add(self, batch: Batch) -> None:
        """Adds the frames of a batch."""
        from fieldspec.tools.captures.pairing import NONE
        from fieldspec.tools.captures.verdicts import OK, VERDICTS

        texts, frames = self.decoder.texts.texts, batch.frames
        if len(frames.link) and frames.link[0] < 0:
            self._add_rows(batch)
            return
        buffer, offsets = frames.bytes
        data = buffer.tobytes()
        rows = zip(
            frames.number.tolist(), frames.time.tolist(), frames.stream.tolist(), frames.link.tolist(),
            frames.direction.tolist(), frames.message.tolist(), frames.request.tolist(), frames.verdict.tolist(),
            offsets[:-1].tolist(), offsets[1:].tolist(), strict=True,
        )  # fmt: skip
        for number, time, stream, link, direction_place, message, request, verdict, first, end in rows:
            if verdict != OK or direction_place == NONE:
                self.left_out[f"frames that are {VERDICTS[verdict] or 'of no direction'}"] += 1
                continue
            direction = texts[direction_place]
            name = "" if message == NONE else texts[message]
            request_values = self._asked.pop(request, {}) if direction == "response" else {}
            frame = self._frame(number, texts[link], direction, name, data[first:end], request_values)
            if frame is not None:
                self._write(stream, time, direction, frame)

    def _add_rows(self, batch: Batch) -> None:
        """Adds accesses that a file has as rows of registers and not as frames."""
        texts, frames = self.decoder.texts.texts, batch.frames
        ways = dict(zip(batch.values.frame.tolist(), batch.values.operation.tolist(), strict=True))
        buffer, offsets = frames.data
        data = buffer.tobytes()
        rows = zip(
            frames.time.tolist(), frames.space.tolist(), frames.address.tolist(), frames.unit_address.tolist(),
            offsets[:-1].tolist(), offsets[1:].tolist(), strict=True,
        )  # fmt: skip
        for number, (time, space, address, unit, first, end) in enumerate(rows):
            clean = self.redaction.words(texts[space], address, data[first:end])
            if self.redaction.secrets.is_in(clean):
                self.left_out["accesses with a secret elsewhere"] += 1
                continue
            own = texts[ways[number]] if number in ways else "read"
            stamp, station = self._stamp(time).strip(), "" if unit < 0 else str(unit)
            size = self.redaction.layout.device.space(texts[space]).unit_size
            for offset in range(0, len(clean) - size + 1, size):
                word = int.from_bytes(clean[offset : offset + size], "big")
                place = f"0x{address + offset // size:04X}"
                self.rows.append((stamp, texts[space], station, own, place, str(word)))
            self.frames += 1

    def table(self) -> str:
        """The rows of registers as CSV; empty where there are none."""
        head = ("time", "space", "unit_address", "operation", "address", "value")
        return csv_text([head, *self.rows]) if self.rows else ""

    def _frame(
        self, number: int, link: str, direction: str, message: str, frame: bytes, request_values: Mapping[str, Any]
    ) -> bytes | None:
        """A frame without secrets; None for one that is left out."""
        try:
            decoded = self.redaction.codec.links[link].decode(frame, direction, message)
            clean = self.redaction.frame(link, direction, frame, decoded, request_values)
            self.redaction.codec.links[link].decode(clean, direction, message)
        except CodecError:
            self.left_out["frames that the codecs do not take"] += 1
            return None
        if direction == "request":
            self._asked[number] = decoded.values
            if len(self._asked) > 4096:
                del self._asked[next(iter(self._asked))]
        return clean

    def _write(self, stream: int, time: int, direction: str, frame: bytes) -> None:
        self.frames += 1
        self.lines.setdefault(stream, []).append(f"{self._stamp(time)}{_MARKS[direction]} {frame.hex(' ').upper()}")

    def _stamp(self, time: int) -> str:
        """The seconds since the first frame; empty where the file has no times."""
        if time == _NO_TIME:
            return ""
        self._begin = time if self._begin is None else self._begin
        return f"{max(time - self._begin, 0) / 1e9:.6f} "

    def logs(self) -> list[str]:
        """The texts of the logs, one for each connection. A frame in which a secret remains is left out."""
        result = []
        for lines in self.lines.values():
            clean = [
                line
                for line in lines
                if not self.redaction.secrets.is_in(bytes.fromhex(line.rpartition(_mark(line))[2]))
            ]
            if len(clean) < len(lines):
                self.left_out["frames with a secret elsewhere"] += len(lines) - len(clean)
            result.append("".join(f"{line}\n" for line in clean))
        return [text for text in result if text]


def _mark(line: str) -> str:
    return "<" if "<" in line else ">"


def redacted_rows(
    redaction: Redaction, rows: Iterable[tuple[str, int, Sequence[int]]]
) -> list[tuple[str, int, list[int]]]:
    """Rows of a space, an address or a number, and counts there, without what identifies a unit.

    Counts in which a secret continues from row to row are 0.
    """
    clean = [(space, number, redaction.counts(space, number, counts)) for space, number, counts in rows]
    clean.sort(key=lambda row: (row[0], row[1]))
    spaces = redaction.layout.device.spaces
    data, sources = bytearray(), list[tuple[list[int], int]]()
    for space, _, counts in clean:
        size = spaces[space].unit_size if space in spaces else 2
        for index, count in enumerate(counts):
            data += (count & (1 << 8 * size) - 1).to_bytes(size, "big")
            sources += [(counts, index)] * size
    for place in list(redaction.secrets.places(bytes(data))):
        for counts, index in sources[place.start : place.stop]:
            counts[index] = 0
    for _, _, counts in clean:
        for index, count in enumerate(counts):
            if redaction.secrets.is_in(str(count).encode()) or redaction.secrets.is_in(_number_bytes(count)):
                counts[index] = 0
    return clean


def _number_bytes(count: int) -> bytes:
    return count.to_bytes((count.bit_length() + 8) // 8, "big", signed=True)


def redacted_dump(redaction: Redaction, dump: Dump) -> str:
    """A dump as CSV. A value of several words is divided into these, so that each row is one word."""
    report = compared(redaction.layout, dump)
    device = redaction.layout.device
    spaces = {parameter_set.space for parameter_set in device.parameters.values()}
    bits = {space for space in device.spaces if device.space(space).unit == "bit"}
    rows: list[tuple[str, int, Sequence[int]]] = []
    for entry in dump.entries(report.base):
        stated_space = entry.space if entry.space in {*device.spaces, *spaces} else ""
        space = stated_space or device.space_name("")
        numbered = stated_space in spaces or not redaction.occupants
        if numbered:
            own = stated_space or next(
                (own for own in spaces if device.parameter_at(own, entry.address) is not None), ""
            )
            rows.append((own, entry.address, entry.values))
            continue
        words = _words(redaction, space, entry.address, entry.values, entry.words)
        rows += [(space, entry.address + offset, (word,)) for offset, word in enumerate(words)]
    grouped = _joined(rows, spaces | bits)
    clean = [
        (space, address + offset, [count]) if space not in spaces else (space, address, counts)
        for space, address, counts in redacted_rows(redaction, grouped)
        for offset, count in (enumerate(counts) if space not in spaces else ((0, 0),))
    ]
    has_spaces = len({space for space, _, _ in clean}) > 1 or any(space in spaces for space, _, _ in clean)
    head = ("space", "address", "value") if has_spaces else ("address", "value")
    cells = [
        (*((space,) * has_spaces), f"0x{address:04X}", " ".join(map(str, counts))) for space, address, counts in clean
    ]
    return csv_text([head, *cells])


def _joined(rows: Iterable[tuple[str, int, Sequence[int]]], alone: set[str]) -> list[tuple[str, int, list[int]]]:
    """Neighbouring words as one row, so that a value of several words is replaced as a whole."""
    result: list[tuple[str, int, list[int]]] = []
    for space, address, counts in sorted(rows, key=lambda row: (row[0], row[1])):
        last = result[-1] if result else None
        if last is not None and space not in alone and last[0] == space and last[1] + len(last[2]) == address:
            last[2].extend(counts)
        elif last is None or (space, address) != last[:2]:
            result.append((space, address, list(counts)))
    return result


def _words(redaction: Redaction, space: str, address: int, values: Sequence[int], words: int | None) -> list[int]:
    """The words, or the bytes, of a row of a dump: a great number is divided like the value at its address."""
    own = next((own for own in redaction.occupants.get((space, address), []) if own.address == address), None)
    number = values[0]
    device = redaction.layout.device
    bits = 8 * device.space(space).unit_size
    mask = (1 << bits) - 1
    if own is None or len(values) > 1 or own.words == 1 or (words != own.words and -(1 << bits - 1) <= number <= mask):
        return [value & mask for value in values]
    parts = [number >> bits * index & mask for index in reversed(range(own.words))]
    return parts if (device.word_order if bits > 8 else own.order) == "big" else parts[::-1]


def redacted_scan(redaction: Redaction, content: Mapping[str, Any]) -> str:
    """A scan as JSON, with the spaces that the device has.

    Raises ValueError, TypeError, KeyError and AttributeError for other files.
    """
    device = redaction.layout.device
    parameter_spaces = {parameter_set.space for parameter_set in device.parameters.values()}
    spaces = []
    for part in content["spaces"]:
        space = str(part["space"])
        if space not in {*device.spaces, device.space_name(""), *parameter_spaces}:
            continue
        rows = [
            (space, int(address, 16), [int(count) for count in (value if isinstance(value, list) else [value])])
            for address, value in part["words"].items()
        ]
        grouped = _joined(rows, parameter_spaces)
        words: dict[str, object] = {}
        for _, address, counts in redacted_rows(redaction, grouped):
            if space in parameter_spaces:
                words[f"0x{address:04X}"] = counts[0] if len(counts) == 1 else counts
            else:
                words |= {f"0x{address + offset:04X}": count for offset, count in enumerate(counts)}
        refused = [f"0x{int(address, 16):04X}" for address in part["refused"]]
        spaces.append({"space": space, "words": words, "refused": refused})
    return json.dumps({"device": device.id, "spaces": spaces}, indent=1) + "\n"
