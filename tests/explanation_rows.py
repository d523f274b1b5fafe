"""The bytes that the rows of an explanation show."""

from __future__ import annotations

from collections.abc import Collection

from fieldspec.codec.explain.explanation import Explanation
from fieldspec.codec.layout.device import DeviceLayout


def sent(explanation: Explanation, shared: Collection[str] = ()) -> bytes:
    """The bytes of all rows as they are sent. Each row must start at the end of the one before it, but the rows of
    `shared` parts have the same bytes as the one before it.
    """
    data = b""
    for previous, row in zip((None, *explanation.rows), explanation.rows, strict=False):
        if previous is not None and row.kind == "part" and row.path in shared:
            assert (row.offset, row.length, row.raw) == (previous.offset, previous.length, previous.raw)
            continue
        assert row.offset == len(data)
        characters = row.characters.encode("latin-1") or row.raw
        data += characters if len(characters) == row.length else bytes.fromhex(row.characters)
        assert row.offset + row.length == len(data)
    return data


def shared_parts(layout: DeviceLayout, link: str, direction: str) -> list[str]:
    """The parts that have other bits of the bytes of the part before them."""
    return [part.name for part in layout.links[link].link.parts(direction) if part.is_shared]
