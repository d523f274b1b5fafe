"""`fieldspec audit --captures`: what captures show of a device."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from pyarrow import parquet

from captures.conversations import USER_0, pcap, rtu
from captures.test_decode_in_bulk import run
from layouts import SPECS

READ_SHARE = rtu(1, 4, 0, 0x0C, 0, 4)
SHARE = rtu(1, 4, 8, 0x43, 0x16, 0, 0, 1, 0x23, 0x12, 0x34)  # 150 percent, the firmware, a word that no register has
EXCHANGES = [
    READ_SHARE, SHARE, READ_SHARE, SHARE,
    rtu(1, 3, 0, 0, 0, 2), rtu(1, 0x83, 2),
    rtu(1, 16, 0, 0, 0, 2, 4, 0, 0, 0, 0), rtu(1, 16, 0, 0, 0, 2),
    rtu(1, 4, 0, 0, 0, 2),
]  # fmt: skip


def report(tmp_path: Path, packets: list[bytes], device: str = "wattmeter@1") -> tuple[int, dict[str, Any]]:
    """The exit code and the sections of the report on a capture."""
    folder = tmp_path / "captures"
    folder.mkdir(exist_ok=True)
    (folder / "line.pcap").write_bytes(pcap(packets, USER_0))
    code, text, error = run("audit", device, "--captures", str(folder), "--format", "json")
    assert text, error
    return code, json.loads(text)["sections"]


@pytest.fixture
def sections(tmp_path: Path) -> dict[str, Any]:
    return report(tmp_path, EXCHANGES)[1]


def test_registers_are_listed_with_their_number_and_bounds(sections: dict[str, Any]) -> None:
    rows = {row["register"]: row for row in sections["seen"]["tables"]["registers"]}
    assert rows["export_share"]["count"] == 2
    assert (rows["export_share"]["least"], rows["export_share"]["greatest"]) == (150, 150)
    assert "voltages[1]" in {row["register"] for row in sections["seen"]["tables"]["unseen"]}


def test_exceptions_and_missing_answers_are_counted_by_register(sections: dict[str, Any]) -> None:
    failures = {(row["registers"], row["failure"]): row["count"] for row in sections["exchanges"]["tables"]["failures"]}
    assert failures == {("ratio", "illegal_data_address"): 1, ("voltages[1]", "no answer"): 1}


def test_contradictions_name_the_register_and_the_reason(tmp_path: Path) -> None:
    code, sections = report(tmp_path, EXCHANGES)
    rows = sections["contradictions"]["tables"]["contradictions"]
    assert code == 1
    assert {(row["register"], row["operation"], row["count"]) for row in rows} == {
        ("export_share", "read", 2),
        ("0x000F", "read", 2),
        ("ratio", "write", 1),
    }


def test_reads_over_gaps_are_remarked(sections: dict[str, Any]) -> None:
    (row,) = sections["polling"]["tables"]["polling"]
    assert (row["requests"], row["interval_ms"], row["unchanged"]) == (2, 2, "100.0 %")
    assert row["remark"] == "reads over gaps: 0x000F"


def test_frequent_reads_of_what_never_changes_are_remarked(tmp_path: Path) -> None:
    packets = 200 * [rtu(1, 4, 0, 0, 0, 2), rtu(1, 4, 4, 0, 0, 0, 0)]
    (row,) = report(tmp_path, packets)[1]["polling"]["tables"]["polling"]
    assert "hardly ever changes" in row["remark"]


def test_the_tables_of_decode_give_the_same_report(tmp_path: Path) -> None:
    _, sections = report(tmp_path, EXCHANGES)
    out = tmp_path / "tables"
    run("decode", "wattmeter@1", str(tmp_path / "captures"), "--to", "parquet", "--out", str(out))
    _, text, _ = run("audit", "wattmeter@1", "--captures", str(out), "--format", "json")
    assert json.loads(text)["sections"] == sections


def test_the_report_is_text_a_page_or_parquet(tmp_path: Path) -> None:
    report(tmp_path, EXCHANGES)
    folder = str(tmp_path / "captures")
    text = run("audit", "wattmeter@1", "--captures", folder)[1]
    assert "illegal_data_address" in text
    assert re.search(r"\b0x[0-9A-F]{4} +[\w.]+ +read ", text), "addresses are written as in `live`"
    page = tmp_path / "report.html"
    run("audit", "wattmeter@1", "--captures", folder, "--format", "html", "--out", str(page))
    assert "illegal_data_address" in page.read_text("utf-8")
    run("audit", "wattmeter@1", "--captures", folder, "--format", "parquet", "--out", str(tmp_path / "out"))
    table = parquet.read_table(tmp_path / "out" / "failures.parquet")
    assert sorted(table.column("count").to_pylist()) == [1, 1]


def test_captures_without_a_frame_of_the_device_are_refused(tmp_path: Path) -> None:
    folder = tmp_path / "captures"
    folder.mkdir()
    (folder / "line.pcap").write_bytes(pcap([], USER_0))
    code, _, error = run("audit", "wattmeter@1", "--captures", str(folder))
    assert code == 2
    assert "no frame of wattmeter" in error


def test_writes_to_memory_that_wears_out_are_counted(tmp_path: Path) -> None:
    write = rtu(1, 6, 0x99, 0x99, 0, 1)
    folder = tmp_path / "captures"
    folder.mkdir()
    (folder / "line.pcap").write_bytes(pcap(3 * [write, write], USER_0, [0, 1, 10_000, 10_001, 20_000, 20_001]))
    text = run("audit", "tc100", "--captures", str(folder), "--format", "json", specs=SPECS)[1]
    (row,) = json.loads(text)["sections"]["wear"]["tables"]["wear"]
    assert (row["register"], row["writes"], row["endurance"]) == ("parameter_storage", 3, "not printed")
    assert row["writes_per_day"] == f"{3 * 86_400 / 20:.0f}"
