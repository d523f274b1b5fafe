"""The printed position of a field is the end of the fields before it in the record, which have a fixed size.

Why: the addresses of the first element and the widths of the fields give the same positions. If they differ,
an address or a width is misprinted, and the wrong bytes are read.

Example: a table at 0x9010 whose record has a field of two words at 0x9011 and the next field at 0x9012.

Fix: Correct the position or a width, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Table
from fieldspec.language.model.sizes import RecordSizes


def offsets_match_layout(device: Device) -> Findings:
    sizes = RecordSizes(device)
    tables: dict[str, list[Table]] = {}
    for table in device.tables.values():
        tables.setdefault(table.record, []).append(table)
    for layer in layers(device):
        holders = tables.get(layer.name, []) if device.records.get(layer.name) is layer else []
        bases = [table.base for table in holders] or [0]
        placed = sizes.offsets(layer)
        for field in layer.fields[len(placed) :] if layer.name not in sizes.endless else ():
            if field.at is not None:
                text = f"{field.name} is printed at {hexadecimal(field.at)}, but {placed[-1][0].name} before it"
                yield finding(field.place, "at", f"{text} has no fixed size", "remove it")
        for field, offset in placed:
            if field.at is None:
                continue
            if offset % 2 or field.at - offset // 2 not in bases:
                right = f"byte {offset} of {layer.name}" if offset % 2 else hexadecimal(bases[0] + offset // 2)
                yield finding(
                    field.place,
                    "at",
                    f"{field.name} is printed at {hexadecimal(field.at)}, but it is at {right}",
                    "correct the position or the type of a field before it",
                    *(label(table.place, "base", f"{table.name} begins here") for table in holders[:1]),
                )
