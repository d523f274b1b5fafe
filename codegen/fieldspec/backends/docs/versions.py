"""The list of a device's versions, which leads to their pages."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.docs.changes import Step, link, page_name
from fieldspec.backends.docs.context import cited
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
    Column("Changed since the version before"),
    Column("Identity", kept=True),
    Column("Source", "source"),
)


def versions(
    layouts: Sequence[DeviceLayout], held: Sequence[Step], ending: str, beside: Sequence[tuple[str, str]] = ()
) -> Document:
    """The versions, the newest first, and the steps between them; `ending` is that of the pages to which they lead.

    `beside` are other pages of the device: what each is, and its file.
    """
    newest = layouts[-1]
    device = newest.device
    known = {version.id: version for line in device.lines for version in line.versions}
    came_by = {step.new.device.version: step for step in held}
    rows = []
    for layout in reversed(layouts):
        version = layout.device.version
        rows.append(_row(layout, known.get(version), came_by.get(version), ending))
    blocks = [Paragraph((plain(device.doc),))] if device.doc else []
    section = Section("versions", (plain("Versions"),), (*blocks, table("Versions, the newest first", COLUMNS, rows)))
    summary = tuple((plain(text, file),) for text, file in beside)
    return Document(
        clean(device.name), clean(device.title), newest.identity, device.manual.language, summary, (section,)
    )


def _row(layout: DeviceLayout, version: Version | None, step: Step | None, ending: str) -> Row:
    device = layout.device
    doc: list[Line] = []
    if version is not None:
        doc = [(plain(text),) for text in (version.title, version.doc) if text]
        if version.inferred:
            doc.append((styled("inferred: ", "strong"), plain(version.inferred)))
    if layout.twins:
        doc.append((plain(f"The same holds for {', '.join(layout.twins)}."),))
    return Row(
        (
            cell(plain(version_title(device), f"{page_name(device.version)}{ending}")),
            cell(*doc),
            _count(sum(register.count for register in device.registers())),
            _count(len(device.messages)),
            _count(sum(len(held.parameters) for held in device.parameters.values())),
            _count(len(device.examples)),
            cell(plain(step.counts(), link(device.version, ending)) if step is not None else ()),
            cell(code(layout.identity)),
            cell(cited(version.sources) if version else ()),
        )
    )


def _count(number: int) -> Cell:
    return cell(str(number)) if number else Cell()
