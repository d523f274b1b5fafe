"""Every address stands in one way, and requests read as much as they can without touching what cannot be read."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.read_plan import ACCESS_UNKNOWN, CLEARED, TOO_LONG, WRITE_ONLY, ReadPlan, read_plan
from fieldspec.tools.audit.address_map import STATES, Space, spaces_of
from fieldspec.tools.audit.addresses import read_rows
from layouts import SPECS, all_layouts, layout_at, newest
from spec_files import gadget

MESSAGES = """
messages:
  - name: read
    code: 3
    source: L1
    request: [{name: address, type: u16}, {name: word_count, type: u16, range: 1..%s}]
    response: [{name: values, type: u16, repeat: 1..%s}]
    accesses: [{operation: read, start: address, count: word_count, values: values}]
"""
LINK = """
links:
  - name: wire
    byte_order: big
    word_order: big
    source: L1
    request: [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
"""


def registers(rows: str, more: str = "") -> str:
    head = "registers:\n  - group: all\n    section: '1'\n    defaults: {type: u16, access: rw}\n"
    return f"{head}{more}    rows:\n{rows}"


def row(at: int, name: str, more: str = "") -> str:
    return f"      - {{at: {at}, name: {name}, source: L{at + 1}{', ' + more if more else ''}}}\n"


def space(text: str, name: str = "registers") -> Space:
    spaces = {space.name: space for space in spaces_of(layout_at(gadget(text), "1"))}
    return spaces[name]


def plan_of(rows: str, most: int = 10, more: str = "") -> ReadPlan:
    text = registers(rows, more) + LINK + MESSAGES % (most, most)
    return read_plan(layout_at(gadget(text), "1"))


def blocks(plan: ReadPlan) -> list[tuple[int, int]]:
    return [(block.start, block.words) for block in plan.blocks]


def states(space_map: Space) -> list[tuple[int, int, str]]:
    return [(run.first, run.last, run.state) for block in space_map.blocks for run in block.runs]


def test_used_reserved_and_both_kinds_of_gaps_are_told_apart() -> None:
    rows = row(0, "a") + row(1, "b", "type: u32") + row(3, "spare", "reserved: true") + row(6, "c") + row(9, "d")
    space_map = space(registers(rows, "    gaps: [{at: 4..5, reason: The table skips them.}]\n"))
    assert states(space_map) == [
        (0, 0, "used"),
        (1, 2, "used"),
        (3, 3, "reserved"),
        (4, 5, "declared_gap"),
        (6, 6, "used"),
        (7, 8, "undeclared_gap"),
        (9, 9, "used"),
    ]
    assert space_map.blocks[0].runs[3].reason == "The table skips them."
    assert space_map.count("used") == 5


def test_an_address_that_two_registers_hold_is_an_overlap_with_the_reason() -> None:
    allowed = "allow: {addresses_disjoint: One is the low word of the other.}"
    space_map = space(registers(row(0, "wide", f"type: u32, {allowed}") + row(1, "low")))
    (overlap,) = [run for run in space_map.blocks[0].runs if run.state == "overlap"]
    assert (overlap.first, overlap.last, overlap.reason) == (1, 1, "One is the low word of the other.")
    assert [occupant.name for occupant in overlap.occupants] == ["wide", "low"]


def test_a_register_of_another_group_is_no_gap_and_is_counted_once() -> None:
    text = (
        registers(row(0, "a") + row(2, "c"))
        + "  - group: other\n    section: '1'\n    rows:\n"
        + row(1, "b", "type: u16")
    )
    space_map = space(text)
    assert [run.is_own for run in space_map.blocks[0].runs] == [True, False, True]
    assert space_map.count("used") == 3


def test_values_at_two_addresses_are_aliases() -> None:
    space_map = space(registers(row(0, "a") + row(1, "b", "same_as: a")))
    assert [(alias.address, alias.of_address, alias.copied) for alias in space_map.aliases] == [(1, 0, False)]


def test_what_lies_between_the_elements_of_a_table_is_left_out_but_not_behind_the_last() -> None:
    fields = "[{name: x, type: u32}, {name: s, type: u16, reserved: true}]"
    record = f"records: [{{name: point, section: '1', source: L1, fields: {fields}}}]\n"
    tables = "tables: [{name: points, section: '1', source: L2, base: 16, stride: 8, count: 3, record: point}]\n"
    space_map = space(record + tables)
    (block,) = space_map.blocks
    assert (block.first, block.last, block.count("used"), block.count("reserved")) == (16, 34, 6, 3)
    assert block.count("declared_gap") == 10


def test_bytes_that_share_a_word_are_one_holder() -> None:
    record = (
        "records: [{name: pair, section: '1', source: L1, fields: [{name: low, type: u8}, {name: high, type: u8}]}]\n"
    )
    tables = "tables: [{name: pairs, section: '1', source: L2, base: 0, stride: 1, count: 2, record: pair}]\n"
    runs = space(record + tables).blocks[0].runs
    assert [occupant.name for run in runs for occupant in run.occupants] == ["low, high"]


def test_a_set_that_names_all_of_its_numbers_has_numbers_that_are_described_elsewhere() -> None:
    text = """
parameters:
  - {name: servo, space: pnu, base: 0x2000, numbers: 0..3, source: L1, type: u16, rows: [{number: 1, name: a}]}
"""
    assert states(space(text, "pnu")) == [
        (0x2000, 0x2000, "undescribed"),
        (0x2001, 0x2001, "used"),
        (0x2002, 0x2003, "undescribed"),
    ]


@pytest.mark.parametrize("layout", all_layouts(), ids=lambda layout: f"{layout.device.id}@{layout.device.version}")
def test_the_runs_of_a_block_follow_one_another_without_a_hole(layout) -> None:  # type: ignore[no-untyped-def]
    for space_map in spaces_of(layout):
        for block in space_map.blocks:
            for before, behind in zip(block.runs, block.runs[1:], strict=False):
                assert behind.first == before.last + 1
            assert {run.state for run in block.runs} <= STATES.keys()


def test_a_request_reads_up_to_the_limit_and_divides_no_value() -> None:
    plan = plan_of(row(0, "a", "count: 9") + row(9, "wide", "type: u32") + row(11, "b"))
    assert blocks(plan) == [(0, 9), (9, 3)]
    limit = plan.limit("")
    assert limit is not None
    assert limit.words == 10


def test_a_request_ends_at_a_hole() -> None:
    assert blocks(plan_of(row(0, "a") + row(1, "b") + row(3, "c"))) == [(0, 2), (3, 1)]


@pytest.mark.parametrize(
    ("more", "reason"),
    [
        ("access: wo", WRITE_ONLY),
        ("clears_on_read: true", CLEARED),
        ("type: bytes, length: 40", TOO_LONG),
    ],
)
def test_a_request_does_not_touch_what_must_not_be_read(more: str, reason: str) -> None:
    words = 20 if "bytes" in more else 1
    plan = plan_of(row(0, "a") + row(1, "b", more) + row(1 + words, "c"))
    assert blocks(plan) == [(0, 1), (1 + words, 1)]
    assert [(unit.name, unit.refused) for unit in plan.left_out] == [("b", reason)]


def test_a_register_of_which_nothing_says_that_it_can_be_read_is_left_out() -> None:
    text = "registers: [{group: all, section: '1', rows: [{at: 0, name: a, type: u16, source: L1}]}]\n" + LINK
    plan = read_plan(layout_at(gadget(text + MESSAGES % (10, 10)), "1"))
    assert [unit.refused for unit in plan.left_out] == [ACCESS_UNKNOWN]


def test_reserved_words_are_read_between_values_and_not_at_the_ends() -> None:
    spare = "reserved: true"
    rows = row(0, "s0", spare) + row(1, "a") + row(2, "s1", spare) + row(3, "b") + row(4, "s2", spare)
    (block,) = plan_of(rows).blocks
    assert (block.start, block.words, block.reserved, block.names) == (1, 3, 1, ("a", "b"))


def test_elements_are_named_by_their_numbers() -> None:
    (block,) = plan_of(row(0, "a", "count: 2") + row(2, "b") + row(3, "c", "count: 2, index_from: 1")).blocks
    assert block.names == ("a[0]", "a[1]", "b", "c[1]", "c[2]")


def test_the_least_of_what_bounds_a_request_is_the_limit() -> None:
    text = registers(row(0, "a")) + LINK + MESSAGES % (10, 4)
    plan = read_plan(layout_at(gadget(text), "1"))
    assert [(limit.words, limit.from_manual) for limit in plan.limits] == [(4, True)]


def test_a_limit_of_the_protocol_is_told_from_one_of_the_manual() -> None:
    assert [(read_limit.words, read_limit.from_manual) for read_limit in read_plan(newest(SPECS, "ck10")).limits] == [
        (125, False)
    ]
    (own,) = read_plan(newest(SPECS, "tc100")).limits
    assert (own.words, own.from_manual, [source.text() for source in own.sources]) == (60, True, ["8.5 L2026-2027"])


@pytest.mark.parametrize("device", ["tc100", "ck10"])
def test_the_blocks_of_a_device_hold_every_readable_value_once(device: str) -> None:
    layout = newest(SPECS, device)
    plan = read_plan(layout)
    names = [name for block in plan.blocks for name in block.names]
    assert len(names) == len(set(names))
    left_out = {unit.name for unit in plan.left_out}
    assert {
        register.name for register in layout.device.registers() if register.count == 1 and not register.reserved
    } <= {
        *names,
        *left_out,
    }
    limit = plan.limit("")
    assert limit is not None
    assert all(block.words <= (limit.words or 0) for block in plan.blocks)


def test_equal_requests_at_equal_distances_are_one_row() -> None:
    rows = read_rows(read_plan(newest(SPECS, "tc100")).blocks)
    (points,) = [read_row for read_row in rows if read_row.times > 1]
    assert (points.first.start, points.first.words, points.times, points.apart) == (0x9010, 14, 127, 16)
