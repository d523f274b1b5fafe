"""What a spec states once and places several times is in the model as if it were written out."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest

from fieldspec.language.model.device import Device
from fieldspec.language.model.ranges import Ranges
from spec_files import DEVICE, codes, gadget, pointed_at, project, unmarked

BLOCK = """
registers:
  - group: settings
    defaults: {type: u32, checked: {words: 2}}
    rows:
      - {at: 10, checked: {decimal: 10}, number: 0, name: speed, unit: rpm, scale: 0.1, default: 5, access: rw,
         doc: How fast.}
      - {at: 12, name: mode, type: u16, checked: {words: 1}, access: wo, trigger: true, restart: true, same_as: speed}
    copies:
      - group: stored
        prefix: stored
        base: 100
        access: ro
        trigger: false
        section: "4"
        rows: [{of: speed, at: 100, checked: {decimal: 0x64, words: 2}, label: 速, source: L7}]
"""

SIGNALS = """
signals:
  - {name: speed, printed_name: NSET, label: 速度, type: i32, range: -5..5, scale: 100/2^30, unit: "%"}
messages:
  - name: telegram
    request:
      - {signal: speed, source: 2 L1}
      - {signal: speed, name: speed_again, range: 0..5, label: 再}
    response: []
records:
  - {name: row, fields: [{signal: speed}]}
"""

ENUMS = """
flags:
  - name: inputs
    type: u32
    bits:
      - {bit: 0, name: stop, label: 停, source: 3 L9}
      - {bit: 1, name: x, reserved: true}
      - {bits: "4..5", name: path}
      - {bit: 7, reserved: true}
      - {bit: 31, name: go}
enums:
  - {name: function, derived: {flags: inputs}, members: [{value: 0, name: none}]}
  - {name: internal, derived: {enum: alarm}}
  - name: alarm
    members: [{value: 0x24, number: 4, name: system, printed_name: AL.024}, {value: 0x25, name: unnumbered}]
"""


def device(text: str) -> Device:
    built, findings = gadget(text).at("1")
    assert codes(findings) == []
    return built


def test_a_copy_is_a_group_of_its_own_at_other_addresses() -> None:
    settings, stored = device(BLOCK).groups
    assert (settings.name, stored.name, stored.section) == ("settings", "stored", "4")
    assert [(row.name, row.address, row.copy_of) for row in stored.registers] == [
        ("stored_speed", 100, "speed"),
        ("stored_mode", 102, "mode"),
    ]


def test_a_copy_is_in_the_address_space_of_its_group() -> None:
    spaces = "\nspaces: [{name: words, source: 2 L1}, {name: bytes, unit: byte, source: 2 L2}]\n"
    settings, stored = device(spaces + BLOCK.replace("settings\n", "settings\n    space: words\n")).groups
    assert (settings.space, stored.space) == ("words", "words")
    assert {row.space for row in stored.registers} == {"words"}


def test_a_copied_register_has_the_value_of_its_original() -> None:
    settings, stored = device(BLOCK).groups
    assert [row.value for row in stored.registers] == [row.value for row in settings.registers]
    assert [row.doc for row in stored.registers] == ["How fast.", ""]


def test_a_copied_register_has_the_facts_printed_for_it() -> None:
    speed, mode = device(BLOCK).groups[1].registers
    assert (speed.decimal, speed.words, speed.label, speed.sources[0].text()) == (100, 2, "速", "4 L7")
    assert (mode.decimal, mode.words, mode.label, mode.sources) == (None, 1, "", ())


def test_a_copied_register_is_accessed_as_its_block_says() -> None:
    speed, mode = device(BLOCK).groups[1].registers
    assert [(row.access, row.trigger, row.restart, row.same_as, row.number) for row in (speed, mode)] == [
        ("ro", False, None, "", None),
        ("ro", False, None, "", None),
    ]


def test_a_field_takes_from_its_signal_what_it_does_not_state() -> None:
    first, second = device(SIGNALS).messages["telegram"].request.fields
    assert (first.name, first.printed_name, first.label, first.signal) == ("speed", "NSET", "速度", "speed")
    assert (second.name, second.printed_name, second.label, second.signal) == ("speed_again", "NSET", "再", "speed")
    assert first.value is not None
    assert second.value is not None
    assert (first.value.scale_text, first.value.unit, first.value.ranges.text() if first.value.ranges else "") == (
        "100/2^30",
        "%",
        "-5..5",
    )
    assert second.value.ranges is not None
    assert second.value.ranges.text() == "0..5"
    assert first.sources[0].text() == "2 L1"


def test_a_field_of_a_record_may_place_a_signal() -> None:
    assert [field.name for field in device(SIGNALS).records["row"].fields] == ["speed"]


def test_masks_of_named_bits_are_members_after_the_listed_ones() -> None:
    members = device(ENUMS).enums["function"].members
    assert [(member.value, member.name, member.label) for member in members] == [
        (0, "none", ""),
        (1, "stop", "停"),
        (1 << 31, "go", ""),
    ]
    assert members[1].sources[0].text() == "3 L9"


def test_masks_are_those_of_bits_counted_from_the_most_significant_one() -> None:
    members = device(ENUMS.replace("type: u32", "type: u32\n    bit_0: most")).enums["function"].members
    assert [(member.value, member.name) for member in members] == [(0, "none"), (1 << 31, "stop"), (1, "go")]


def test_numbers_of_members_are_the_members_of_another_enum() -> None:
    assert [(member.value, member.name, member.printed_name) for member in device(ENUMS).enums["internal"].members] == [
        (4, "system", "AL.024")
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("messages: [{name: a, request: [{signal: «speed»}]}]\n", "there is no signal `speed`"),
        ("enums: [{name: a, derived: {flags: «b»}}]\n", "there is no bit field `b`"),
        ("enums: [{name: a, derived: {enum: «b»}}]\n", "there is no enum `b`"),
        (
            "registers: [{group: a, rows: [{at: 1, name: x, type: u8}], "
            "copies: [{group: b, prefix: c, base: 9, rows: [{of: «y»}]}]}]\n",
            "there is no register in this group `y`",
        ),
    ],
)
def test_a_reference_to_something_missing_is_a_finding(text: str, message: str) -> None:
    clean, start, end = unmarked(DEVICE + text)
    findings = project(clean.removeprefix(DEVICE)).findings
    assert (findings[0].code, findings[0].message) == ("references_resolve", message)
    assert pointed_at(findings[0].span) == clean[start:end]


@pytest.mark.parametrize(
    ("scale", "exact"), [("100/2^14", "0.006103515625"), ("1/1000", "0.001"), ("0.5/5", "0.1"), ("3/1", "3")]
)
def test_a_fraction_is_an_exact_scale(scale: str, exact: str) -> None:
    text = f"records: [{{name: a, fields: [{{name: b, type: i32, scale: {scale}}}]}}]\n"
    value = device(text).records["a"].fields[0].value
    assert value is not None
    assert f"{value.scale:f}" == exact


def test_a_fraction_that_is_no_decimal_is_an_exact_scale() -> None:
    text = "records: [{name: a, fields: [{name: b, type: u8, scale: 100/255, unit: '%', unit_range: 0..80}]}]\n"
    value = device(text).records["a"].fields[0].value
    assert value is not None
    assert (value.scale, value.scale_number, value.ranges) == (Fraction(20, 51), "100/255", Ranges(((0, 204),)))
    assert (value.from_unit(Decimal(20)), value.from_unit(Decimal(50))) == (51, None)
    assert f"{value.in_unit(128):.8f}" == "50.19607843"


@pytest.mark.parametrize("scale", ["1/0", "1/7^50"])
def test_a_fraction_of_more_digits_than_outputs_have_is_a_finding(scale: str) -> None:
    findings = gadget(f"records: [{{name: a, fields: [{{name: b, type: i32, scale: {scale}}}]}}]\n").at("1")[1]
    assert codes(findings) == ["wrong_form"]


def test_a_value_in_the_unit_is_exact_for_long_scales() -> None:
    value = device(SIGNALS).signals["speed"].value
    for raw in (1, -1, 2**31 - 1, -(2**31), 123456789):
        assert value.from_unit(value.in_unit(raw)) == raw


def test_bounds_of_several_lines_count_for_their_own_line() -> None:
    lines = """
versions:
  - {line: two, builds: true, members: [{id: "2.8"}, {id: "2.12"}]}
  - {line: three, members: [{id: "3.8"}, {id: "3.12"}]}
limits:
  - {name: late, value: 1, since: ["2.12", "3.12"]}
"""
    spec = gadget(lines)
    assert [[limit.name for limit in spec.at(version)[0].limits] for version in ("2.8", "2.12")] == [[], ["late"]]
