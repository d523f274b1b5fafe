"""Spec files for the tests of reading. In a text, `«` and `»` enclose what a finding must point to."""

from __future__ import annotations

import re

from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import Project, read

MANUAL = f'{{title: The manual, file: gadget.txt, sha256: "{"0" * 64}", lines: 999}}'
DEVICE = f"device: {{id: gadget, name: Gadget, vendor: Maker, manual: {MANUAL}}}\n"

_MARKS = re.compile("[«»]")


def unmarked(text: str) -> tuple[str, int, int]:
    """A text without its marks, and the offsets between which they enclosed it."""
    before, _, rest = text.partition("«")
    inside, _, after = rest.partition("»")
    assert not _MARKS.search(before + inside + after), "one pair of marks"
    return before + inside + after, len(before), len(before + inside)


def project(text: str = "", **others: str) -> Project:
    """The project of the device `gadget` with a text and other files: `protocols_wire` is `protocols/wire.yaml`."""
    files = {"gadget/device.yaml": DEVICE + text} | {
        f"{name.replace('_', '/', 1)}.yaml": other for name, other in others.items()
    }
    return read({path: content.encode() for path, content in files.items()})


def gadget(text: str, **others: str) -> DeviceSpec:
    """The device of such a project, which has no findings."""
    read_from = project(text, **others)
    assert codes(read_from.findings) == []
    return read_from.devices["gadget"]


def codes(findings: list[Diagnostic]) -> list[str]:
    """The codes of findings."""
    return [finding.code for finding in findings]


def pointed_at(span: Span) -> str:
    """The text of a span."""
    return span.file.text[span.start : span.end]
