"""The files for controllers with word memory, and what they can express."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.codec.layout.omissions import Expressed, expressed
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, csv_text
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.targets.controllers.capabilities import CONSTRUCTS, EXACT, Capability, adapted, refused
from fieldspec.targets.kv import word_map
from fieldspec.targets.kv.areas import Area, areas
from fieldspec.targets.kv.dialect import KV, WordDialect
from fieldspec.targets.kv.refusals import register_refusals, with_refused_links


@dataclass(frozen=True, slots=True)
class AreaRows:
    """The rows of an area in both files, and what they were made of."""

    area: Area
    meanings: list[Enum | Flags]
    words: str
    comments: str


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """A word map and a list of device comments for each version of a device."""
    texts = {}
    known: dict[tuple[int, str], AreaRows] = {}
    for layout in versions:
        name = stem(layout.device.id, layout.device.version)
        expressed_layout = remaining(layout)
        placed_areas = _placed_areas(expressed_layout.layout, KV)
        map_rows = [_area_rows(layout, base, area, known) for base, area in placed_areas]
        words = [
            csv_text(word_map.head(layout, expressed_layout.omissions)),
            *(rows_of_area.words for rows_of_area in map_rows),
        ]
        texts[f"{name}_words.csv"] = BYTE_ORDER_MARK + "".join(words)
        texts[f"{name}_comments.csv"] = "".join(rows_of_area.comments for rows_of_area in map_rows)
    return texts


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The refusals of what words do not carry: values, tables that move, registers and frames."""
    return [finding for layout in versions for finding in remaining(layout).findings]


def remaining(layout: DeviceLayout) -> Expressed:
    """The facts of a version that word maps express, with those that they leave out."""
    reader = "a word map"
    refusal_functions = (character_refusals, base_refusals, inner_list_refusals)
    of_values = [refusal for refusals_of in refusal_functions for refusal in refusals_of(layout, reader)]
    return with_refused_links(expressed(layout, [*of_values, *register_refusals(layout)], reads_exceptions=False))


def _area_rows(layout: DeviceLayout, base: int, area: Area, known: dict[tuple[int, str], AreaRows]) -> AreaRows:
    """The rows of an area: the rows of another version if they are equal."""
    device = layout.device
    meanings = word_map.meanings(device, area)
    before = known.get((base, area.name))
    if before is None or before.area != area or before.meanings != meanings:
        words = csv_text(word_map.rows(device, base, area, KV))
        before = AreaRows(area, meanings, words, csv_text(word_map.comment_rows(layout.device, base, area, KV)))
        known[base, area.name] = before
    return before


def _placed_areas(layout: DeviceLayout, dialect: WordDialect) -> Iterator[tuple[int, Area]]:
    """The areas with the numbers of their first words, one after the other."""
    address = dialect.base
    for area in areas(layout):
        yield address, area
        address = dialect.next_step(address + area.words)


_TABLE = "only in the table, because KV STUDIO imports only comments"
_NOT_EXACT = {
    "wide_numbers": adapted("words, which no KV instruction reads as one number"),
    "wide_lists": adapted("words, which no KV instruction reads as one number"),
    "magnitudes": adapted("words, which the ladder must convert to numbers"),
    "half_floats": adapted("words, which the ladder must convert to numbers"),
    "bits": refused(
        "they do not occupy whole words; the map lists the bytes of their messages: output_registers_words"
    ),
    "escaped_frames": refused("the sent bytes differ from the bytes of the parts: output_frames_words"),
    "hex_frames": refused("each byte is sent as two characters: output_frames_words"),
    "can_frames": refused("they are not sent as words on a serial line: output_frames_words"),
    "byte_registers": refused(
        "they do not occupy whole words; the map lists the bytes of their messages: output_registers_words"
    ),
    "moving_tables": refused("the map contains addresses as constants: output_addresses_constant"),
    "pieces": adapted("the map lists the words of the messages; the ladder must reassemble the segments"),
    "choices": adapted("listed once for each type, with the values that select it"),
    "aliases": adapted("only the main name"),
    "other_frames": adapted("words; the ladder must fill, sum and compare them"),
    "frames": adapted("words; the ladder must fill, sum and compare them"),
    "orders": adapted("stated for each value; the ladder must exchange words and bytes"),
    "scales": adapted(_TABLE),
    "powers": adapted(_TABLE),
    "conversions": refused("they are formulas, which a word map does not contain"),
    "digits": refused("KV instructions do not read digits as numbers: output_numbers_binary"),
    "inner_lists": refused("the words after a list have no fixed address: output_lists_last"),
    "formed_texts": refused("KV instructions copy the bytes unconverted: output_texts_ascii"),
    "ranges": adapted(_TABLE),
    "told_ranges": adapted(_TABLE),
    "constants": adapted(_TABLE),
    "code_texts": refused("see the output for operator panels"),
    "remedies": refused("see the output for operator panels"),
    "labels": adapted("only in the table, because comments are ASCII"),
}


def capabilities() -> Mapping[str, Capability]:
    """How far each construct is expressed."""
    return {name: _NOT_EXACT.get(name, Capability(EXACT)) for name in CONSTRUCTS}
