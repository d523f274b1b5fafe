"""The form of an external source: a mark of its encoding, a head of comments, objects, line ends of Windows."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.backends.scl.project import Project
from fieldspec.plc.routines.written import comment


def source(held: Project, objects: Iterable[list[str]]) -> str:
    """A source of several objects, each one its lines."""
    dialect = held.declared.dialect
    lines = list(head(held))
    for one in objects:
        lines += ["", *one]
    return dialect.byte_order_mark + "".join(line.rstrip() + dialect.line_end for line in lines)


def head(held: Project) -> list[str]:
    """What the file is, what it was made of, and how it is imported."""
    device = held.layout.device
    manual = f"{device.manual.title} {device.manual.edition}".strip()
    sources = [
        f"{held.stem}_types.udt",
        *([f"{held.stem}_data.db"] if held.blocks else []),
        f"{held.stem}_functions.scl",
    ]
    return [
        *comment(f"{device.name} ({device.vendor}), version {device.version}"),
        *comment(f"Manual: {manual}. A note such as [8.2 L1622] is a section and a line of it."),
        *comment(f"Identity of the layout: {held.layout.identity}"),
        *comment("Written by fieldspec. Do not edit: change the spec and build again."),
        "//",
        *comment(
            "Import: in the project tree of the PLC, External source files, Add new external file, then Generate "
            f"blocks from source: {', '.join(sources)}, in this order. A block of the same name is overwritten."
        ),
        *comment(f"Constants: PLC tags, Show all tags, Import, {held.stem}_constants.xlsx."),
    ]
