"""The table of facts lists every fact once, with its line in the manual, in the documented columns."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Scalar, Sequence, find
from fieldspec.language.reading.project import read
from fieldspec.tools.facts import COLUMNS, FactRow, rows

ROOT = Path(__file__).resolve().parent.parent
SPECS = ROOT / "specs"
TEST_SPECS = ROOT / "tests" / "specs"
PAGE = (ROOT / "docs" / "facts.md").read_text("utf-8")
DEVICES = sorted(path.parent.name for path in SPECS.glob("*/device.yaml"))


@lru_cache(maxsize=8)
def spec(folder: Path, device: str) -> DeviceSpec:
    """The spec of a device."""
    files = {
        path.relative_to(root).as_posix(): path.read_bytes()
        for root in (SPECS, folder)
        for path in sorted(root.glob("*/*.yaml"))
    }
    return read(files, frozenset({device})).devices[device]


@lru_cache(maxsize=8)
def facts(folder: Path, device: str) -> tuple[FactRow, ...]:
    """The facts of a device at its newest version."""
    device_spec = spec(folder, device)
    return tuple(rows(device_layout(device_spec.at(device_spec.versions()[-1])[0])))


def leads_to_fact(tree: Mapping, path: str) -> bool:
    """Whether a path leads to a node, to an element of the fact at its node, or to a value in the list there."""
    if find(tree, path) is not None:
        return True
    outer, _, last = path.rpartition("/")
    node = find(tree, outer)
    if isinstance(node, Sequence):
        return any(isinstance(item, Scalar) and item.text == last for item in node.items)
    return node is not None and last.isdigit()


def fact(path: str) -> FactRow:
    """The row of the made-up device that has a path."""
    (match,) = (row for row in facts(TEST_SPECS, "glider-x") if row["path"] == path)
    return match


def test_documentation_describes_every_column_in_order() -> None:
    table = PAGE.partition("## Columns")[2].partition("## Provenance")[0]
    described = [name for line in table.splitlines() for name in re.findall(r"`(\w+)`", line.partition("| ")[2][:25])]
    assert [name for name in described if name in COLUMNS] == list(COLUMNS)


@pytest.mark.parametrize("device", DEVICES)
def test_a_path_belongs_to_one_fact(device: str) -> None:
    paths = [str(row["path"]) for row in facts(SPECS, device)]
    assert sorted(set(paths)) == sorted(paths)


@pytest.mark.parametrize("device", sorted(path.parent.name for path in TEST_SPECS.glob("*/device.yaml")))
def test_the_path_of_a_fact_leads_to_it_in_the_spec(device: str) -> None:
    device_spec = spec(TEST_SPECS, device)
    version = device_spec.versions()[-1]
    tree = device_spec.trees.get(version, device_spec.tree)
    paths = [str(row["path"]) for row in facts(TEST_SPECS, device)]
    assert [path for path in paths if not leads_to_fact(tree, path)] == []


@pytest.mark.parametrize("device", DEVICES)
def test_every_printed_fact_has_its_line(device: str) -> None:
    free = ("example", "note", "version", "register_group", "task")
    elsewhere = ("standard", "computed", "reported")
    printed_facts = [
        row for row in facts(SPECS, device) if row["provenance"] not in elsewhere and row["kind"] not in free
    ]
    assert [row["path"] for row in printed_facts if row["line"] is None] == []


@pytest.mark.parametrize("device", DEVICES)
def test_standard_computed_and_reported_facts_do_not_cite_the_manual(device: str) -> None:
    elsewhere = ("standard", "computed", "reported")
    cited = [row["path"] for row in facts(SPECS, device) if row["provenance"] in elsewhere and row["sources"]]
    assert cited == []


@pytest.mark.parametrize(
    ("path", "cells"),
    [
        (
            "signals/torque_reduction",
            {"kind": "signal", "direction": "request", "max": 16384, "line": 14},
        ),
        ("conversions/output_torque", {"kind": "conversion", "type": "u16", "max": 0x4000, "line": 19}),
        ("conversions/output_torque/references/0", {"kind": "conversion_reference", "line": 19}),
        ("messages/telegram_11", {"kind": "telegram", "code": 11, "line": 26}),
        ("messages/telegram_11/data_words/response", {"kind": "data_words", "code": 11, "words": 5}),
        ("messages/telegram_11/request/gain", {"kind": "telegram_field", "position": "4-5", "type": "i32", "line": 29}),
        ("messages/telegram_70/supplements/1", {"kind": "supplement", "name": "telegram_11"}),
        (
            "messages/read_parameter/response/values/choice/cases/unsigned16",
            {"kind": "case", "type": "u16", "bytes": 2, "direction": "response"},
        ),
        (
            "messages/read_parameter/response/values/choice/cases/unsigned16/when/word",
            {"kind": "case_value", "name": "word"},
        ),
        ("flags/status_word/states/inhibited", {"kind": "state", "code": 64, "bit": "0..1, 6", "line": 44}),
        ("enums/alarm/system", {"kind": "alarm", "code": 0x24, "number": 4}),
        ("enums/input_function/user_5", {"kind": "enum_value", "code": 1 << 31}),
        ("registers/resolution", {"kind": "register", "address": 0x100, "number": 0}),
        ("registers/stored_turns", {"kind": "register", "address": 0x204, "words": 4, "access": "ro", "line": 58}),
        ("parameters/servo", {"kind": "parameter_set", "number": 0x2000, "ranges": "0..4095"}),
        ("parameters/servo/reference_torque", {"code": 0x42A, "number": 0x242A, "restart": "yes", "line": 69}),
        ("parameters/servo/reference_speed/applies_to/rotary", {"kind": "applies_to", "code": 0x317}),
        ("parameters/servo/reference_speed/messages/telegram_11", {"kind": "effective_with", "name": "telegram_11"}),
        ("parameters/profile/fault_codes", {"kind": "parameter", "count": 8}),
        (
            "parameters/profile/identification/subindices/maker",
            {"kind": "subindex", "number": 0, "const": 0xAAA, "default": None},
        ),
        ("parameters/profile/identification/subindices/2", {"kind": "subindex", "number": 2, "count": 3, "line": 65}),
        ("parameters/monitor/unused", {"kind": "parameter_series", "code": 0x100, "count": 5}),
        ("parameters/monitor/unused/260", {"kind": "parameter", "code": 0x104, "number": 0x4104, "line": 72}),
    ],
)
def test_every_kind_of_fact_has_a_row(path: str, cells: dict[str, object]) -> None:
    row = fact(path)
    assert {key: row[key] for key in cells} == cells


@pytest.mark.parametrize(
    ("device", "path", "cells"),
    [
        ("glider-x", "messages/telegram_11/request/torque_reduction", {"position": "6"}),
        (
            "ecu-can",
            "messages/write_word/response_code",
            {"kind": "response_code", "code": 0x036E, "name": "write_word"},
        ),
        ("weigher", "records/article/share", {"address": 0x102, "words": 2}),
        ("totalizer", "records/entry/difference", {"address": 0x103, "words": 3}),
    ],
)
def test_a_row_says_where_a_value_is_and_what_answers(device: str, path: str, cells: dict[str, object]) -> None:
    (row,) = (row for row in facts(TEST_SPECS, device) if row["path"] == path)
    assert {key: row[key] for key in cells} == cells


def test_a_range_that_the_manual_prints_again_is_a_row_with_its_ends() -> None:
    (row,) = (row for row in facts(SPECS, "ck10") if row["path"] == "records/point/low_speed/restated/0")
    assert (row["min"], row["max"], row["ranges"]) == (1, 35000, "1..35000")
