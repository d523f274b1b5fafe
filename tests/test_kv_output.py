"""The word map and the device comments say where values lie, are read by an independent reader, and harm nobody."""

from __future__ import annotations

import csv
import io
import random
import re
import struct
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.reference.bits import bit_places
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.raw_numbers import number_in
from fieldspec.targets.kv.areas import Area, PlacedValue, areas
from fieldspec.targets.kv.backend import files
from fieldspec.targets.kv.dialect import KV
from fieldspec.targets.vectors.backend import vector
from layouts import SPECS, TEST_SPECS, has_digits, layout_at, layouts, newest
from spec_files import gadget
from word_memory import ROOTS, Row, comments, memory, number, signed, texts, word_map

VERSIONS = [
    pytest.param(layout, id=f"{layout.device.id}-{layout.device.version}")
    for root in (SPECS, TEST_SPECS)
    for versions in layouts(root).values()
    for layout in versions
    if not has_digits(layout) and not any(register.register.value.write_word_order for register in layout.registers)
]


def rows_of(layout: DeviceLayout) -> list[Row]:
    return word_map(layout.device.id, layout.device.version)


def is_number(row: Row) -> bool:
    """Whether a row is a number of its own: unlike the bits of a word, a part with some bits has bounds."""
    return bool(row["bits"]) and (row["type"] not in ("bit", "bits") or bool(row["max"]))


def mapped_areas(layout: DeviceLayout) -> list[Area]:
    """The areas of all messages but those that the map names as left out."""
    left_out = {row["name"].removeprefix("message ") for row in rows_of(layout) if row["area"] == "left out"}
    return [area for area in areas(layout) if area.name.split(" ")[0] not in left_out]


def at_path(values: Any, name: str) -> Any:
    """What lies in nested values at `points[0].mode`; None where it is not there."""
    for step in re.findall(r"[^.\[\]]+", name):
        if isinstance(values, list):
            values = values[int(step)] if int(step) < len(values) else None
        elif isinstance(values, dict):
            values = values.get(step)
        else:
            return None  # a field of bits, whose values an example has as one number
        if values is None:
            return None
    return values


EXAMPLES = [
    pytest.param(layout, example.id, id=f"{layout.device.id}-{layout.device.version}-{example.id}")
    for root in (SPECS, TEST_SPECS)
    for versions in layouts(root).values()
    for layout in versions
    for example in layout.device.examples.values()
    if example.message
    and not has_digits(layout)
    and not (example.refused or example.exception_response or layout.messages[example.message].message.single_access)
    and layout.links[example.link].link.transmission == "binary"
    and layout.links[example.link].link.escape is None
]


@pytest.mark.proof(200)
@pytest.mark.parametrize(("layout", "example_id"), EXAMPLES)
def test_the_bits_of_the_map_hold_the_values_of_every_example(layout: DeviceLayout, example_id: str) -> None:
    example = layout.device.examples[example_id]
    link = layout.links[example.link]
    values = vector(layout, example)["values"]
    assert isinstance(values, dict)
    shape = link.frame(example.direction)
    unit = 1 if shape.checksum else 2
    words = memory(example.frame, unit)
    ends = (f"{example.message} {example.direction}", f"{example.message} on {link.name} {example.direction}")
    compared = 0
    for row in rows_of(layout):
        if row["area"] not in ends or not is_number(row):
            continue
        selector, _, cases = row["case"].partition(": ")
        if cases and not chosen(layout, example.message, example.direction, values, selector, cases.split(", ")):
            continue
        for element in range(int(row["elements"] or 1)):
            name = re.sub(r"\[[0-9]+\.\.[0-9]+\]", f"[{element}]", row["name"])
            value = at_path(values, name)
            if value is None:
                continue
            if isinstance(value, float):
                bits, letter = {"f16": ("H", "e"), "f32": ("I", "f")}[row["type"]]
                value = struct.unpack(f">{bits}", struct.pack(f">{letter}", value))[0]
            assert signed(row, words, element) == value, row
            compared += 1
    assert compared >= sum(not isinstance(value, str | list) for value in values.values())


def chosen(layout: DeviceLayout, message: str, direction: str, values: Any, selector: str, cases: list[str]) -> bool:
    """Whether the selector has one of some values."""
    by = layout.messages[message].data(direction).named(selector)
    assert by is not None
    assert by.value is not None
    member = layout.device.enums[by.value.enum].member(values[selector])
    return member is not None and member.name in cases


@pytest.mark.proof(14)
@pytest.mark.parametrize("layout", VERSIONS)
def test_the_bits_of_the_map_are_those_that_the_reference_writes(layout: DeviceLayout) -> None:
    chance = random.Random(layout.identity)
    result = {(row["area"], row["name"], row["case"]): row for row in rows_of(layout)}
    for area in mapped_areas(layout):
        for placed_value in area.values:
            if placed_value.value is not None and not is_array(placed_value.value.encoding):
                check_element(result[area.name, placed_value.title, placed_value.case], area, placed_value, chance)


def check_element(row: Row, area: Area, placed_value: PlacedValue, chance: random.Random) -> None:
    assert placed_value.value is not None
    if placed_value.width:
        raw = chance.getrandbits(placed_value.width)
        data, stop = bytearray(area.size), placed_value.start + placed_value.size
        word_bytes = (raw << placed_value.shift).to_bytes(placed_value.size, "big")
        data[placed_value.start : stop] = word_bytes[::-1] if placed_value.order == "little" else word_bytes
        assert number(row, memory(bytes(data), area.unit), 0) == raw
        return
    raw = chance.getrandbits(8 * placed_value.size)
    word = number_in(placed_value.value, raw.to_bytes(placed_value.size, "big"), "big", False)
    if word is None or word != word or (word == 0 and raw):  # one NaN is like another, and so is one zero
        return
    encoded = value_construct(placed_value.value, placed_value.order, placed_value.swapped).build(word)
    element = chance.randrange(placed_value.elements)
    data = bytearray(area.size)
    at = placed_value.start + element * placed_value.stride
    data[at : at + placed_value.size] = encoded
    assert number(row, memory(bytes(data), area.unit), element) == raw


def fields_of(layout: DeviceLayout) -> Iterator[FieldLayout]:
    for message in layout.messages.values():
        yield from (*message.request.fields, *message.response.fields)


@pytest.mark.parametrize("layout", VERSIONS)
def test_flags_have_rows_for_their_bits(layout: DeviceLayout) -> None:
    rows = rows_of(layout)
    result = {(row["area"], row["name"]): row for row in rows}
    chance = random.Random(1)
    checked = 0
    for area in mapped_areas(layout):
        for placed_value in area.values:
            flags = (
                layout.device.flags.get(placed_value.value.flags)
                if placed_value.value and placed_value.value.flags
                else None
            )
            for bit in flags.bits if flags else ():
                words = [chance.getrandbits(16) for _ in range(placed_value.start + placed_value.size + 1)]
                whole = number(result[area.name, placed_value.title], words)
                part = number(result[area.name, f"{placed_value.title}.{bit.name}"], words)
                assert part == sum((whole >> place & 1) << weight for weight, place in enumerate(bit_places(bit)))
                checked += 1
    is_serial = any(not link.link.is_can for link in layout.links.values())
    if is_serial and any(field.value and field.value.flags for field in fields_of(layout)):
        assert checked


@pytest.mark.parametrize("layout", VERSIONS)
def test_every_register_and_every_field_of_a_table_is_in_the_map(layout: DeviceLayout) -> None:
    rows = rows_of(layout)
    addresses = {int(row["address"], 16) for row in rows if row["address"]}
    words = [
        register
        for register in layout.registers
        if register.register.unit_size > 1 and register.register.value.type.name != "bit"
    ]
    wanted = {register.address + number * register.stride for register in words for number in range(register.count)}
    assert wanted <= addresses
    for table in layout.tables.values():
        names = {re.sub(r"\[[^\]]*\]", "", row["name"]) for row in rows if row["area"] == f"table {table.name}"}
        assert {f"{table.name}.{field.name}" for field in table.record.fields if not field.record} <= names


@pytest.mark.parametrize("layout", VERSIONS)
def test_areas_lie_apart_and_behind_the_documented_base(layout: DeviceLayout) -> None:
    first: dict[str, int] = {}
    for row in rows_of(layout):
        if row["device"]:
            start = int(row["device"].removeprefix(KV.letters)) - int(row["word"])
            assert first.setdefault(row["area"], start) == start
    ends = {area.name: first[area.name] + area.words for area in mapped_areas(layout)}
    spans = sorted((start, ends[name]) for name, start in first.items())
    if not spans:
        return  # a CAN bus has no words
    assert spans[0][0] == KV.base
    assert all(end <= start for (_, end), (start, _) in pairwise(spans))
    assert all(start % KV.step == 0 for start, _ in spans)
    assert spans[-1][1] - 1 <= KV.last


@pytest.mark.parametrize("layout", VERSIONS)
def test_every_word_that_holds_something_has_one_short_comment_in_ascii(layout: DeviceLayout) -> None:
    outputs = comments(layout.device.id, layout.device.version)
    assert all(len(row) == 2 for row in outputs)
    assert all(row[1].isascii() and row[1].isprintable() and 0 < len(row[1]) <= KV.width for row in outputs)
    devices = [row[0] for row in outputs]
    assert len(devices) == len(set(devices))
    base = {row["area"]: int(row["device"][2:]) - int(row["word"]) for row in rows_of(layout) if row["device"]}
    wanted = {
        KV.device(base[area.name] + byte // area.unit)
        for area in mapped_areas(layout)
        for placed_value in area.values
        for _, start in placed_value.names()
        for byte in range(start, start + placed_value.size)
    }
    assert set(devices) == wanted


@pytest.mark.parametrize("device", ROOTS)
def test_comments_are_the_same_bytes_in_every_encoding_that_they_may_be_read_in(device: str) -> None:
    for path, text in texts(device).items():
        if path.endswith("_comments.csv"):
            assert text.encode("cp932") == text.encode("utf-8") == text.encode("gbk")


@pytest.mark.parametrize("device", ROOTS)
def test_lines_end_as_they_do_on_windows(device: str) -> None:
    for text in texts(device).values():
        assert text.count("\n") == text.count("\r\n") == text.count("\r")


def test_a_value_of_two_words_says_what_must_be_done_before_it_is_read_as_one() -> None:
    result = {row["name"]: row for row in word_map("widget", "2.0")}
    by_bits: dict[str, set[str]] = {}
    for row in result.values():
        if is_number(row):
            by_bits.setdefault(row["bits"], set()).add(row["in_memory"])
    assert by_bits["15..0"] == {"direct"}
    assert by_bits["0:15..0 1:15..0"] == {"swap words"}


def test_a_label_that_is_a_formula_to_a_spreadsheet_is_a_text() -> None:
    spec = gadget(
        """
registers:
  - group: all
    title: All
    section: "1"
    rows:
      - {at: 0, name: first, type: u16, access: rw, label: '=HYPERLINK("http://x","y")', source: L1}
      - {at: 1, name: second, type: u16, access: rw, label: "+1, \\"quoted\\"\\nline", source: L2}
      - {at: 2, name: third, type: u16, access: rw, label: "@SUM(1)", source: L3}
      - {at: 3, name: fourth, type: u16, access: rw, label: "-A1", source: L4}
""",
    )
    outputs = files([layout_at(spec, "1")])
    text = next(text for path, text in outputs.items() if path.endswith("_words.csv"))
    labels = [row["label"] for row in csv.DictReader(io.StringIO(text[1:], newline=""))][1:]
    assert labels == ['\'=HYPERLINK("http://x","y")', '\'+1, "quoted" line', "'@SUM(1)", "'-A1"]


def test_words_behind_the_last_one_of_the_controller_have_no_device() -> None:
    assert (KV.device(KV.last), KV.device(KV.last + 1)) == ("DM65534", "")


def test_the_map_bears_the_identity() -> None:
    layout = newest(SPECS, "esc11")
    text = next(text for path, text in files([layout]).items() if path.endswith("_words.csv"))
    assert layout.identity in text.splitlines()[1]


@pytest.mark.proof(13)
@pytest.mark.parametrize("device", ROOTS)
def test_versions_that_share_areas_have_the_files_that_each_has_alone(device: str) -> None:
    versions = layouts(ROOTS[device])[device]
    alone = {path: text for layout in versions for path, text in files([layout]).items()}
    assert files(versions) == alone


@pytest.mark.parametrize(
    ("name", "in_memory"),
    [
        ("field", "convert"),
        ("turn", "convert"),
        ("sample.odd", "join bytes, convert"),
        ("sample.wide", "join bytes, convert"),
    ],
)
def test_the_map_says_which_numbers_no_instruction_reads(name: str, in_memory: str) -> None:
    rows = {row["name"]: row for row in rows_of(newest(TEST_SPECS, "compass"))}
    assert (rows[name]["in_memory"], rows[name]["suffix"]) == (in_memory, "")
