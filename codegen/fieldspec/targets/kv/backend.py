"""The files for controllers with word memory, and what they lack: registers of bits and bytes, and some frames."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.codec.layout.omissions import Expressed, Omission, expressed, warning
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, csv_text
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.targets.controllers.capabilities import CONSTRUCTS, EXACT, Capability, adapted, refused
from fieldspec.targets.kv import word_map
from fieldspec.targets.kv.areas import Area, areas, frames_in_words, has_frame_areas
from fieldspec.targets.kv.dialect import KV, WordDialect


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


def register_refusals(layout: DeviceLayout) -> Iterator[Refusal]:
    """A refusal of each register in a space of bits or bytes; the registers of a group have one finding.

    Each register whose words are written in a different order from reads is refused too.
    """
    for group in layout.device.groups:
        space = layout.device.space(group.space)
        if space.unit == WORD:
            for register in group.registers:
                if register.value.write_word_order:
                    text = f"{register.name} is written in another order of words than a word map has, that of a read"
                    place = register.place["write_word_order"]
                    yield Refusal(register, Diagnostic("output_registers_words", text, place, help=LEAVE_OUT))
            continue
        text = (
            f"an address of the registers in {group.name} is a {space.unit}, and a word map has one register per word"
        )
        finding = Diagnostic("output_registers_words", text, group.place["group"], help=LEAVE_OUT)
        for register in group.registers:
            yield Refusal(register, finding)


def with_refused_links(remaining: Expressed) -> Expressed:
    """The expressed facts, with an omission and a warning for each link whose frames no word of the map has."""
    omissions, findings = [], []
    for link, messages, key, reason in _refused_links(remaining.layout):
        finding = Diagnostic("output_frames_words", reason, link.link.place[key])
        names = ", ".join(messages)
        findings.append(warning(finding, f"the frames of {names} on {link.name} are left out"))
        omissions.append(Omission(f"link {link.name}", f"{reason}: {names}"))
    return replace(
        remaining,
        omissions=(*remaining.omissions, *omissions),
        findings=(*remaining.findings, *findings),
    )


def _refused_links(layout: DeviceLayout) -> Iterator[tuple[LinkLayout, list[str], str, str]]:
    """Links with messages that no other link has in words: the names of these, the key that forbids it, the reason."""
    links = layout.links.values()
    present = {name for link in links if frames_in_words(link) for name in link.messages}
    for link in links:
        messages = [
            message.name
            for message in link.messages.values()
            if message.name not in present and has_frame_areas(layout, link, message)
        ]
        if frames_in_words(link) or not messages:
            continue
        if link.link.is_can:
            yield link, messages, "can", f"{link.name} is a CAN bus, whose frames are not words of a serial line"
        elif link.link.escape is not None:
            reason = f"{link.name} escapes bytes, so the words of its parts are not what is sent"
            yield link, messages, "escape", reason
        elif link.link.preamble is not None:
            reason = f"{link.name} has a preamble of varying length, so the words of its frames have no place"
            yield link, messages, "preamble", reason
        else:
            yield (
                link,
                messages,
                "transmission",
                f"{link.name} sends each byte as two characters, which a word map has not",
            )
