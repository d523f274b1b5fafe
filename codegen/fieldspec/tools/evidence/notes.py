"""The note that says of which unit the files of a folder are."""

from __future__ import annotations

import re

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.nodes import Mapping, Scalar
from fieldspec.language.reading.yaml_reader import decoded, key_span, parsed

FILE = "unit.yaml"
RULE = "evidence_notes_complete"
REDACTED = "redacted"

_REQUIRED = ("model", "firmware", "serial_number")
_KEYS = (*_REQUIRED, "unit_address", "remarks")
_HELP = {
    "model": "write the model as its label has it",
    "firmware": 'write the firmware in quotes, such as "2.12"; `unknown` if it is not known',
    "serial_number": "write `serial_number: redacted`, and remove the number from the files",
}


@dataclass(frozen=True, slots=True)
class UnitNote:
    """A unit: its model and firmware, and its address on a line that it shares; None if the files have only it."""

    name: str
    model: str
    firmware: str
    unit_address: int | None
    remarks: str


def unit_note(name: str, path: str, data: bytes) -> tuple[UnitNote | None, list[Diagnostic]]:
    """The note of a unit from the content of its file, or None, and what is wrong with it."""
    file, findings = decoded(path, data)
    node = None
    if not findings:
        node, findings = parsed(file)
    if findings:
        return None, findings
    if not isinstance(node, Mapping):
        text = f"a note has the keys {', '.join(_REQUIRED)}"
        return None, [Diagnostic(RULE, text, Span(file, 0, 0), help="write them as `key: value`")]
    findings = [
        Diagnostic(RULE, f"a note has no key `{key}`", key_span(node, key), help=f"use one of {', '.join(_KEYS)}")
        for key in node.values
        if key not in _KEYS
    ]
    texts: dict[str, str] = {}
    for key in _KEYS:
        value = node.values.get(key)
        if value is None:
            if key in _REQUIRED:
                findings.append(Diagnostic(RULE, f"`{key}` is missing", Span(file, 0, 0), help=_HELP[key]))
        elif not isinstance(value, Scalar) or not value.text.strip():
            findings.append(Diagnostic(RULE, f"`{key}` is not a text", value.span, help=_HELP.get(key, "write a text")))
        else:
            texts[key] = value.text.strip()
    if texts.get("serial_number", REDACTED) != REDACTED:
        span = node.values["serial_number"].span
        findings.append(Diagnostic(RULE, "a note has no serial number", span, help=_HELP["serial_number"]))
    address = texts.get("unit_address")
    if address is not None and not re.fullmatch(r"[0-9]{1,9}", address):
        span = node.values["unit_address"].span
        findings.append(Diagnostic(RULE, "`unit_address` is not a number", span, help="write it as 1"))
    if findings:
        return None, findings
    number = int(address) if address is not None else None
    return UnitNote(name, texts["model"], texts["firmware"], number, texts.get("remarks", "")), []
