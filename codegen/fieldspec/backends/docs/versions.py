"""The list of a device's versions, which leads to their pages."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.docs.context import Context, cited
from fieldspec.backends.docs.document import (
    Cell,
    Column,
    Document,
    Line,
    Paragraph,
    Row,
    Section,
    cell,
    clean,
    code,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.identity import version_title
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Version

COLUMNS = (
    Column("Version", kept=True),
    Column("What it is", "wide"),
    Column("Registers", "number"),
    Column("Messages", "number"),
    Column("Parameters", "number"),
    Column("Example frames", "number"),
    Column("Identity", kept=True),
    Column("Source", "source"),
)


def versions(layouts: Sequence[DeviceLayout], ending: str) -> Document:
    """The versions, the newest first; `ending` is that of the pages to which they lead."""
    newest = layouts[-1]
    device = newest.device
    known = {version.id: version for line in device.lines for version in line.versions}
    rows = [_row(layout, known.get(layout.device.version), ending) for layout in reversed(layouts)]
    blocks = [Paragraph((plain(device.doc),))] if device.doc else []
    section = Section("versions", (plain("Versions"),), (*blocks, table("Versions, the newest first", COLUMNS, rows)))
    return Document(clean(device.name), clean(device.title), newest.identity, device.manual.language, (), (section,))


def _row(layout: DeviceLayout, version: Version | None, ending: str) -> Row:
    device = layout.device
    doc: list[Line] = []
    if version is not None:
        doc = [(plain(text),) for text in (version.title, version.doc) if text]
        if version.inferred:
            doc.append((styled("inferred: ", "strong"), plain(version.inferred)))
    return Row(
        (
            cell(plain(version_title(Context(layout)), f"{device.version}{ending}")),
            cell(*doc),
            _count(sum(register.count for register in device.registers())),
            _count(len(device.messages)),
            _count(sum(len(held.parameters) for held in device.parameters.values())),
            _count(len(device.examples)),
            cell(code(layout.identity)),
            cell(cited(version.sources) if version else ()),
        )
    )


def _count(number: int) -> Cell:
    return cell(str(number)) if number else Cell()
