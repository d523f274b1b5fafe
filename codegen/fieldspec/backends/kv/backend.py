"""The files for controllers whose memory is words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.backends.kv import comments, word_map
from fieldspec.backends.kv.areas import Area, areas
from fieldspec.backends.kv.dialect import KV, WordDialect
from fieldspec.layout.device import DeviceLayout
from fieldspec.names import stem
from fieldspec.spreadsheet import BYTE_ORDER_MARK, csv_text


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """A word map and a list of device comments for each version of a device."""
    texts = {}
    for layout in versions:
        name = stem(layout.device.id, layout.device.version)
        placed = list(_placed(layout, KV))
        texts[f"{name}_words.csv"] = BYTE_ORDER_MARK + csv_text([word_map.COLUMNS, *word_map.rows(layout, placed, KV)])
        texts[f"{name}_comments.csv"] = csv_text(comments.rows(placed, KV))
    return texts


def shared() -> dict[str, str]:
    """Nothing belongs to no device."""
    return {}


def _placed(layout: DeviceLayout, dialect: WordDialect) -> Iterator[tuple[int, Area]]:
    """The areas with the numbers of their first words, one behind the other."""
    at = dialect.base
    for area in areas(layout):
        yield at, area
        at = dialect.next_step(at + area.words)
