"""A device that lists the messages of a protocol takes along the records that these have, and no others."""

from __future__ import annotations

import pytest

from fieldspec.language.diagnostics import has_errors
from spec_files import project

PROTOCOL = """
protocol: {id: wire, title: Wire, doc: A wire.}
links:
  - name: line
    transmission: binary
    byte_order: big
    request: &frame [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: *frame
    exception_response: {flag: 0x80, record: exception}
records:
  - {name: exception, fields: [{name: reason, type: u8}]}
  - {name: inner, fields: [{name: low, type: u8}, {name: high, type: u8}]}
  - {name: outer, fields: [{name: pair, record: inner}, {name: mark, type: u8}]}
  - {name: both, fields: [{name: number, type: u16}]}
  - {name: unused, fields: [{name: number, type: u16}]}
messages:
  - {name: read, code: 1, request: [], response: [{name: number, record: both}]}
  - {name: scan, code: 2, request: [], response: [{name: first, record: both}, {name: rows, record: outer}]}
"""
USES = "uses: [{protocol: wire, messages: [%s]}]\n"
OWN_MESSAGE = "messages: [{name: own, code: 3, source: 1 L1, request: [], response: [{name: row, record: outer}]}]\n"
OWN_RECORD = "records: [{name: outer, source: 1 L1, fields: [{name: mark}]}]\n"


def records(text: str) -> list[str]:
    """The records of a device, which has no errors but missing sources."""
    result = project(text, protocols_wire=PROTOCOL)
    assert not has_errors(result.findings)
    device, findings = result.devices["gadget"].at("1")
    assert {finding.code for finding in findings} <= {"sources_present"}
    return list(device.records)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (USES % "read", ["exception", "both", "unused"]),
        (USES % "scan", ["exception", "inner", "outer", "both", "unused"]),
        (USES % "", ["exception", "unused"]),
        (USES % "read" + OWN_MESSAGE, ["exception", "inner", "outer", "both", "unused"]),
        (USES % "read" + OWN_RECORD, ["exception", "inner", "outer", "both", "unused"]),
        ("uses: [{protocol: wire}]\n", ["exception", "inner", "outer", "both", "unused"]),
    ],
)
def test_records_that_only_other_messages_have_stay_behind(text: str, names: list[str]) -> None:
    assert records(text) == names
