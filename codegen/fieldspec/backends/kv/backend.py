"""The files for controllers whose memory is words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.backends.kv import comments, word_map
from fieldspec.backends.kv.areas import Area, areas
from fieldspec.backends.kv.dialect import KV, WordDialect
from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.enum import Enum
from fieldspec.model.flags import Flags
from fieldspec.names import stem
from fieldspec.spreadsheet import BYTE_ORDER_MARK, csv_text


@dataclass(frozen=True, slots=True)
class Written:
    """The rows of an area in both files, and what they were made of."""

    area: Area
    meanings: list[Enum | Flags]
    words: str
    comments: str


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """A word map and a list of device comments for each version of a device."""
    texts = {}
    known: dict[tuple[int, str], Written] = {}
    for layout in versions:
        name = stem(layout.device.id, layout.device.version)
        written = [_written(layout, base, area, known) for base, area in _placed(layout, KV)]
        words = [csv_text(word_map.head(layout)), *(one.words for one in written)]
        texts[f"{name}_words.csv"] = BYTE_ORDER_MARK + "".join(words)
        texts[f"{name}_comments.csv"] = "".join(one.comments for one in written)
    return texts


def _written(layout: DeviceLayout, base: int, area: Area, known: dict[tuple[int, str], Written]) -> Written:
    """The rows of an area: those of another version, where nothing of it differs there."""
    device = layout.device
    meanings = word_map.meanings(device, area)
    before = known.get((base, area.name))
    if before is None or before.area != area or before.meanings != meanings:
        words = csv_text(word_map.rows(device, base, area, KV))
        before = Written(area, meanings, words, csv_text(comments.rows(base, area, KV)))
        known[base, area.name] = before
    return before


def shared() -> dict[str, str]:
    """Nothing belongs to no device."""
    return {}


def _placed(layout: DeviceLayout, dialect: WordDialect) -> Iterator[tuple[int, Area]]:
    """The areas with the numbers of their first words, one behind the other."""
    at = dialect.base
    for area in areas(layout):
        yield at, area
        at = dialect.next_step(at + area.words)
