"""Escaped bytes, and where each original byte is among those that are sent."""

from __future__ import annotations

from fieldspec.language.model.escape import CAN_HEADER, Escape


class EscapeError(ValueError):
    """Bytes that are the escape of nothing; `offset` is the place of the first one."""

    def __init__(self, offset: int) -> None:
        super().__init__(offset)
        self.offset = offset


def original_places(escape: Escape, data: bytes) -> list[tuple[int, int]]:
    """The original bytes, each with the place of the byte that is sent for it. Raises EscapeError."""
    if escape.method == "can":
        return _of_identifier(escape, data)
    if escape.method == "cobs":
        return _of_blocks(data)
    if escape.method == "add":
        return [((byte - escape.inserted) & 0xFF, place) for place, byte in enumerate(data)]
    return _replaced(escape, data) if escape.method == "replace" else _without_inserted(escape, data)


def _replaced(escape: Escape, data: bytes) -> list[tuple[int, int]]:
    originals = {(first, second): byte for byte, first, second in escape.pairs}
    special = {byte for byte, _, _ in escape.pairs} | {first for _, first, _ in escape.pairs}
    places, place = [], 0
    while place < len(data):
        byte, width = data[place], 1
        if byte in special:
            pair = (byte, data[place + 1]) if place + 1 < len(data) else None
            if pair not in originals:
                raise EscapeError(place)
            byte, width = originals[pair], 2
        places.append((byte, place))
        place += width
    return places


def _without_inserted(escape: Escape, data: bytes) -> list[tuple[int, int]]:
    places, begin, place = [], 0, 0
    while place < len(data):
        places.append((data[place], place))
        place += 1
        if data[begin:place].endswith(escape.pattern):
            if place == len(data) or data[place] != escape.inserted:
                raise EscapeError(place)
            place += 1
            begin = place
    return places


def _of_blocks(data: bytes) -> list[tuple[int, int]]:
    places: list[tuple[int, int]] = []
    begin = 0
    while begin < len(data):
        end = begin + data[begin]
        if end == begin or end > len(data) or 0 in data[begin:end]:
            raise EscapeError(begin)
        places += [(data[place], place) for place in range(begin + 1, end)]
        if data[begin] < 0xFF and end < len(data):
            places.append((0, end))
        begin = end
    if not data:
        raise EscapeError(0)
    return places


def _of_identifier(escape: Escape, data: bytes) -> list[tuple[int, int]]:
    """The first part is in the place of the whole header, and the other parts of the identifier follow it.

    In a remote request, the requested number of bytes is in the second half of the header.
    """
    wrong = escape.wrong_header(data)
    if wrong is not None:
        raise EscapeError(wrong)
    parts, first = escape.unpacked(int.from_bytes(data[:4], "big")), escape.fields[0][0]
    is_remote = escape.is_remote(data)
    places = [(byte, 0 if place < first else 4 if is_remote else CAN_HEADER) for place, byte in enumerate(parts)]
    if is_remote:
        return [*places, (data[4], 4)]
    return [*places, *((data[place], place) for place in range(CAN_HEADER, len(data)))]
