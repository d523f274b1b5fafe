"""The printed position of a record's field is where the fields before it end.

Why: the addresses of a table's first element and the widths of its fields say the same thing twice.
Where they differ, one address or one width is misprinted, and what is read lies beside the field.

Example: a table at 0x9010 whose record has a field of two words at 0x9011 and the next one at 0x9012.

Cure: Put the position or a width right, and write an erratum if it is printed so.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import layers
from fieldspec.checks.finding import finding, hexadecimal, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.registers import Table
from fieldspec.model.sizes import RecordSizes


def offsets_match_layout(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    tables: dict[str, list[Table]] = {}
    for table in device.tables.values():
        tables.setdefault(table.record, []).append(table)
    for layer in layers(device):
        holders = tables.get(layer.name, []) if device.records.get(layer.name) is layer else []
        bases = [table.base for table in holders] or [0]
        for field, offset in sizes.offsets(layer):
            if field.at is None:
                continue
            if offset % 2 or field.at - offset // 2 not in bases:
                right = f"byte {offset} of {layer.name}" if offset % 2 else hexadecimal(bases[0] + offset // 2)
                yield finding(
                    "offsets_match_layout",
                    field.place,
                    "at",
                    f"{field.name} is printed at {hexadecimal(field.at)}; it lies at {right}",
                    "put the position, or a type before it, right",
                    *(label(table.place, "base", f"{table.name} begins here") for table in holders[:1]),
                )
