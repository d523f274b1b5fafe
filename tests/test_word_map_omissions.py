"""A word map leaves out registers and frames that are not the bytes of words, and says so."""

from __future__ import annotations

import csv
import io

import pytest

from fieldspec.language.diagnostics import Severity
from fieldspec.targets.kv.backend import files, refusals
from fieldspec.targets.queries.backend import files as query_files
from layouts import layout_at
from spec_files import gadget
from word_memory import Row

SPACES = """
spaces:
  - {name: table, title: Table, unit: byte, source: 1 L9}
  - {name: lamps, title: Lamps, unit: bit, source: 1 L9}
  - {name: words, title: Words, source: 1 L9}
registers:
  - {group: levels, section: "1", space: table, rows: [{at: 0, name: level, type: u16, access: ro, source: L1}]}
  - {group: lit, section: "1", space: lamps, rows: [{at: 0, name: lamp, type: bit, access: ro, source: L2}]}
  - {group: kept, section: "1", space: words, rows: [{at: 0, name: limit, type: u16, access: ro, source: L3}]}
"""
LINK = """
  - name: %s
    source: 1 L1
    byte_order: big
    request:
      - {name: code, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
    %s
"""
MESSAGES = """
messages:
  - {name: rest, code: 9, source: 1 L5, request: [{name: time, type: u8}], response: []}
"""


def word_map(*links: tuple[str, str], spaces: str = "") -> tuple[list[Row], list[str]]:
    """The rows below the identity, and the warnings."""
    keys = "\n    "
    stated = "".join(LINK % (name, keys.join(more.split("; "))) for name, more in links)
    layout = layout_at(gadget(f"links:{stated}{MESSAGES}{spaces}" if links else spaces), "1")
    (text,) = (text for path, text in files([layout]).items() if path.endswith("_words.csv"))
    findings = refusals([layout])
    assert all(finding.severity is Severity.WARNING for finding in findings)
    rows = list(csv.DictReader(io.StringIO(text[1:], newline="")))[1:]
    return rows, [f"{finding.code}: {finding.message}; {finding.help}" for finding in findings]


def test_registers_that_are_no_words_are_left_out_with_a_warning_for_each_group() -> None:
    rows, findings = word_map(spaces=SPACES)
    assert [(row["area"], row["name"]) for row in rows] == [
        ("left out", "register level"),
        ("left out", "register lamp"),
        ("words 0x0000..0x0000", "limit"),
    ]
    assert findings == [
        "output_registers_words: an address of the registers in levels is a byte, and a word map has one register per "
        "word; register level is left out",
        "output_registers_words: an address of the registers in lit is a bit, and a word map has one register per "
        "word; register lamp is left out",
    ]


@pytest.mark.parametrize(
    ("more", "reason"),
    [
        (
            "transmission: binary; escape: {method: slip}",
            "bus escapes bytes, so the words of its parts are not what is sent",
        ),
        ('transmission: hex_ascii; start: "3A"', "bus sends each byte as two characters, which a word map has not"),
    ],
)
def test_frames_whose_bytes_are_not_those_of_their_parts_are_left_out_with_a_warning(more: str, reason: str) -> None:
    rows, findings = word_map(("bus", more))
    assert [(row["area"], row["name"], row["label"]) for row in rows] == [("left out", "link bus", f"{reason}: rest")]
    assert findings == [f"output_frames_words: {reason}; the frames of rest on bus are left out"]


def test_frames_that_another_link_has_in_words_are_there_for_it_alone() -> None:
    rows, findings = word_map(("bus", "transmission: binary; escape: {method: slip}"), ("open", "transmission: binary"))
    assert {row["area"] for row in rows} == {"rest on open request", "rest on open response"}
    assert findings == []


def test_delimiters_are_words_of_a_frame() -> None:
    rows, findings = word_map(("bus", 'transmission: binary; start: "3A 3B"; end: "0D"'))
    assert findings == []
    request = [row for row in rows if row["area"] == "rest request"]
    assert [(row["name"], row["byte"], row["words"], row["fixed"]) for row in request] == [
        ("start delimiter", "0", "2", str(0x3A3B)),
        ("code", "2", "1", "9"),
        ("time", "3", "1", ""),
        ("sum", "4", "1", ""),
        ("end delimiter", "5", "1", str(0x0D)),
    ]


def test_queries_say_that_payloads_are_not_escaped() -> None:
    links = LINK % ("bus", "transmission: binary\n    escape: {method: slip}")
    texts = query_files([layout_at(gadget(f"links:{links}{MESSAGES}"), "1")])
    assert all("Payloads of bus have the bytes before they are escaped." in text for text in texts.values())
