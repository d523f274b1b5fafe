"""`fieldspec audit --evidence`: what real units show of the facts of a spec, and what that does not prove."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from captures.conversations import USER_0, pcap, rtu
from captures.test_decode_in_bulk import run
from fieldspec.tools.evidence.unit_evidence import Series, SeriesValue, UnitNote, unit_note
from layouts import SPECS

NOTE = 'model: W\nfirmware: "1"\nserial_number: redacted\n'
DEVICE = "wattmeter@1"


def words(*values: int) -> list[int]:
    return [byte for value in values for byte in divmod(value, 256)]


def read(address: int, *values: int) -> list[bytes]:
    """A read of input registers and its answer."""
    return [rtu(1, 4, *words(address, len(values))), rtu(1, 4, 2 * len(values), *words(*values))]


def unit(folder: Path, name: str, files: dict[str, bytes], note: str = NOTE) -> None:
    own = folder / name
    own.mkdir(parents=True)
    (own / "unit.yaml").write_text(note, "utf-8")
    for file, content in files.items():
        (own / file).write_bytes(content)


def capture(*packets: bytes) -> dict[str, bytes]:
    return {"line.pcap": pcap(packets, USER_0)}


def dump(number: int) -> bytes:
    """A dump in which the share and the firmware depend on a number."""
    rows = [(0x0C, 0x4216 + number), (0x0D, 0), (0x0E, number)]
    return ("space,address,value\n" + "".join(f"input_registers,{a},{b}\n" for a, b in rows)).encode()


def report(folder: Path, *options: str) -> tuple[int, dict[str, Any]]:
    """The exit code and the tables of the report."""
    code, text, error = run("audit", DEVICE, "--evidence", str(folder), "--format", "json", *options)
    assert text, error
    return code, json.loads(text)["sections"]["evidence"]["tables"]


def states(tables: dict[str, Any], fact: str) -> dict[str, str]:
    return {row["aspect"]: row["state"] for row in tables["evidence"] if row["fact"] == fact}


WRONG_NOTES = [
    ("- a\n", "a note has the keys model, firmware, serial_number", (0, 0)),
    (NOTE.replace("model: W\n", ""), "`model` is missing", (0, 0)),
    (NOTE.replace("W", "[]"), "`model` is not a text", (7, 9)),
    (NOTE.replace("redacted", "S123"), "a note has no serial number", (38, 42)),
    (NOTE + "colour: red\n", "a note has no key `colour`", (47, 53)),
    (NOTE + "unit_address: x\n", "`unit_address` is not a number", (61, 62)),
    (NOTE + 'remarks: " "\n', "`remarks` is not a text", (56, 59)),
]


@pytest.mark.parametrize(("text", "message", "place"), WRONG_NOTES)
def test_what_is_wrong_with_a_note_is_found_where_it_is(text: str, message: str, place: tuple[int, int]) -> None:
    note, findings = unit_note("a", "a/unit.yaml", text.encode())
    assert note is None
    assert [(finding.message, (finding.span.start, finding.span.end)) for finding in findings] == [(message, place)]


def test_a_note_may_have_an_address_and_remarks() -> None:
    text = f"{NOTE}unit_address: 12\nremarks: near the door\n"
    assert unit_note("a", "a/unit.yaml", text.encode()) == (UnitNote("a", "W", "1", 12, "near the door"), [])


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([7, 7], "7"),
        ([3, 1, 2, 0], "0, 1, 2, 3"),
        ([3, 1, 2, 0, 4], "0..4"),
        ([2.5, 0.5, 1, 3, 4], "0.5..4"),
        (["off", 3, 1, 2, 0], "0, 1, 2, 3, .."),
        (["on", "off", 1], "1, off, on"),
    ],
)
def test_a_few_values_are_told_one_by_one_and_many_by_their_bounds(values: list[SeriesValue], text: str) -> None:
    series = Series("line")
    for moment, value in enumerate(values):
        series.add(value, moment)
    assert series.text == text


def test_a_value_that_was_always_0_proves_neither_itself_nor_its_scale(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0C, 0, 0), *read(0x0C, 0, 0)))
    code, tables = report(tmp_path)
    own = states(tables, "registers/export_share")
    assert code == 0
    assert own["address"] == "observed"
    assert (own["value"], own["scale"]) == ("proves nothing", "proves nothing")


def test_values_that_change_show_the_value_and_leave_the_scale_to_a_person(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0C, 0x4216, 0), *read(0x0C, 0x4220, 0)))
    own = states(report(tmp_path)[1], "registers/export_share")
    assert (own["value"], own["scale"]) == ("observed", "consistent")


def test_values_that_change_in_step_do_not_tell_which_is_which(tmp_path: Path) -> None:
    unit(tmp_path, "a", {f"{number}.csv": dump(number) for number in (1, 2)})
    rows = {row["fact"]: row for row in report(tmp_path)[1]["unproven"] if row["aspect"] == "value"}
    assert "in step with firmware" in rows["registers/export_share"]["remark"]
    assert "in step with export_share" in rows["registers/firmware"]["remark"]


def test_values_that_change_at_different_moments_show_which_is_which(tmp_path: Path) -> None:
    answers = [(0x4216, 1), (0x4220, 1), (0x4220, 2)]
    unit(tmp_path, "a", capture(*(frame for share, number in answers for frame in read(0x0C, share, 0, number))))
    _, tables = report(tmp_path)
    assert states(tables, "registers/export_share")["value"] == "observed"
    assert states(tables, "registers/firmware")["value"] == "observed"


@pytest.mark.parametrize(
    ("answer", "state"),
    [
        (rtu(1, 16, *words(0, 2)), "observed"),
        (rtu(1, 0x90, 2), "consistent"),
    ],
)
def test_a_write_counts_once_it_is_accepted(tmp_path: Path, answer: bytes, state: str) -> None:
    ask, values = rtu(1, 3, *words(0, 2)), rtu(1, 3, 4, *words(0x3F80, 0))
    write = rtu(1, 16, *words(0, 2), 4, *words(0x3F80, 0))
    unit(tmp_path, "a", capture(ask, values, write, answer))
    assert states(report(tmp_path)[1], "registers/ratio")["access"] == state


def test_refusals_of_other_units_on_the_line_do_not_count(tmp_path: Path) -> None:
    refused = [rtu(2, 4, *words(0x0E, 1)), rtu(2, 0x84, 2)]
    unit(tmp_path, "a", capture(*refused, *read(0x0C, 0x4216, 0)), NOTE + "unit_address: 1\n")
    assert report(tmp_path)[1]["disagreements"] == []


def test_another_unit_tells_apart_what_changes_in_step_in_one(tmp_path: Path) -> None:
    unit(tmp_path, "a", {f"{number}.csv": dump(number) for number in (1, 2)})
    unit(tmp_path, "b", capture(*read(0x0C, 0x4216, 0, 1), *read(0x0C, 0x4216, 0, 2)))
    _, tables = report(tmp_path)
    assert states(tables, "registers/firmware")["value"] == "observed"
    (row,) = (row for row in tables["units_matrix"] if (row["fact"], row["aspect"]) == ("registers/firmware", "value"))
    assert (row["unit a"], row["unit b"]) == ("proves nothing", "observed")


def test_what_contradicts_the_spec_is_a_finding_and_an_open_entry(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0C, 0x4316, 0)))  # 150 percent
    code, tables = report(tmp_path)
    (row,) = tables["disagreements"]
    assert code == 1
    assert (row["fact"], row["aspect"], row["decision"]) == ("registers/export_share", "range", "open")
    assert row["where"] == "line.pcap, frame 2"


def test_a_register_that_refuses_every_read_contradicts_its_address(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(rtu(1, 4, *words(0x0E, 1)), rtu(1, 0x84, 2), *read(0x0C, 0x4216, 0)))
    (row,) = report(tmp_path)[1]["disagreements"]
    assert (row["fact"], row["aspect"]) == ("registers/firmware", "address")
    assert "illegal_data_address" in row["wire"]


def test_addresses_that_answer_and_are_not_in_the_spec_are_named(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0E, 1, 0x1234)))
    (row,) = report(tmp_path)[1]["unlisted"]
    assert (row["address"], row["values"]) == ("0x000F", str(0x1234))


def test_a_scan_shows_what_answers_and_what_does_not(tmp_path: Path) -> None:
    space = {"space": "input_registers", "words": {"0x000E": 5}, "refused": ["0x000C", "0x000D"]}
    scan = {"spaces": [space]}
    unit(tmp_path, "a", {"scan.json": json.dumps(scan).encode()})
    _, tables = report(tmp_path)
    assert {row["fact"] for row in tables["disagreements"]} == {"registers/export_share"}


def test_frames_of_other_units_on_the_line_do_not_count(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0C, 0x4216, 0)), NOTE + "unit_address: 7\n")
    assert {row["state"] for row in report(tmp_path)[1]["evidence"]} == {"never seen"}


def test_evidence_that_is_lost_is_a_finding(tmp_path: Path) -> None:
    folder, saved = tmp_path / "units", tmp_path / "baseline.json"
    unit(folder, "a", capture(*read(0x0C, 0x4216, 0)))
    unit(folder, "b", capture(*read(0x0E, 1), *read(0x0E, 2)))
    arguments = ("audit", DEVICE, "--evidence", str(folder))
    assert run(*arguments, "--table", "evidence", "--format", "json", "--out", str(saved))[0] == 0
    assert report(folder, "--baseline", str(saved))[0] == 0
    (folder / "b" / "line.pcap").write_bytes(pcap(read(0x0E, 1), USER_0))
    code, text, _ = run(*arguments, "--baseline", str(saved))
    assert code == 1
    assert "the value of registers/firmware was `observed`; it is now `proves nothing`" in text


def test_a_contradiction_that_a_baseline_has_is_a_warning(tmp_path: Path) -> None:
    folder, saved = tmp_path / "units", tmp_path / "baseline.json"
    unit(folder, "a", capture(*read(0x0C, 0x4316, 0)))
    arguments = ("audit", DEVICE, "--evidence", str(folder))
    assert run(*arguments, "--table", "evidence", "--format", "json", "--out", str(saved))[0] == 1
    assert report(folder, "--baseline", str(saved))[0] == 0


def test_the_report_is_a_page_that_escapes_notes(tmp_path: Path) -> None:
    unit(tmp_path, "a", capture(*read(0x0C, 0x4216, 0)), NOTE + 'remarks: "</script><b>"\n')
    code, text, _ = run("audit", DEVICE, "--evidence", str(tmp_path), "--format", "html")
    assert code == 0
    assert "</script><b>" not in text
    assert "&lt;/script&gt;&lt;b&gt;" in text


def test_a_unit_with_the_firmware_of_another_version_is_listed_and_does_not_count(tmp_path: Path) -> None:
    note = 'model: E1\nfirmware: "2.8.16"\nserial_number: redacted\n'
    unit(tmp_path, "a", {"dump.csv": b"address,value\n1,1\n"}, note)
    text = run("audit", "hiwin-e@2.14.4", "--evidence", str(tmp_path), "--format", "json", specs=SPECS)[1]
    tables = json.loads(text)["sections"]["evidence"]["tables"]
    assert [row["remark"] for row in tables["evidence_units"]] == ["not counted: audit hiwin-e@2.8.16"]
    assert {row["state"] for row in tables["evidence"]} == {"never seen"}


def test_fields_of_messages_are_facts(tmp_path: Path) -> None:
    log = b"TX 01 01 11 70 FF FF FE 7F\nTX 01 01 11 6F FF FF FE 7E\n"
    unit(tmp_path, "a", {"line.log": log}, "model: C\nfirmware: unknown\nserial_number: redacted\n")
    text = run("audit", "counter", "--evidence", str(tmp_path), "--format", "json")[1]
    rows = json.loads(text)["sections"]["evidence"]["tables"]["evidence"]
    values = {row["fact"].rsplit("/", 1)[-1]: row["state"] for row in rows if row["aspect"] == "value" and row["count"]}
    assert values == {"channel": "observed", "limit": "proves nothing"}


@pytest.mark.parametrize(
    ("files", "reason"),
    [
        ({}, "has no dump, scan or capture"),
        ({"line.pcap": pcap([], USER_0)}, "has no frame of wattmeter"),
        ({"dump.csv": b"address,value\n"}, "dump.csv"),
        ({"dump.json": b"{"}, "dump.json"),
        ({"picture.png": b"\x89PNG\r\n\x1a\n\0\0\0"}, "could not be read"),
    ],
)
def test_files_that_are_no_evidence_are_refused(tmp_path: Path, files: dict[str, bytes], reason: str) -> None:
    unit(tmp_path, "a", files)
    code, _, error = run("audit", DEVICE, "--evidence", str(tmp_path))
    assert code == 2
    assert reason in error


def test_a_folder_without_units_and_one_without_a_note_are_refused(tmp_path: Path) -> None:
    assert run("audit", DEVICE, "--evidence", str(tmp_path))[0] == 2
    (tmp_path / "a").mkdir()
    code, _, error = run("audit", DEVICE, "--evidence", str(tmp_path))
    assert code == 2
    assert "no unit.yaml" in error


def test_a_baseline_of_another_kind_is_refused(tmp_path: Path) -> None:
    folder, saved = tmp_path / "units", tmp_path / "baseline.json"
    unit(folder, "a", capture(*read(0x0C, 0x4216, 0)))
    saved.write_text('[{"fact": 1}]', "utf-8")
    code, _, error = run("audit", DEVICE, "--evidence", str(folder), "--baseline", str(saved))
    assert code == 2
    assert "is not a table of evidence" in error
