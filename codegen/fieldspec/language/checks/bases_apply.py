"""The `base_by` of a record table names a register with the address of the first element: a single readable whole
number without a scale, names or sentinels. Its `range` includes the `base` of the table, its `default` equals the
`base`, and for every address in that range all elements are within the address space.

Why: programs read the register, and use the addresses that follow from it. A value that is not an address leads them to
other data.

Example: `base: 0x1000, base_by: log_address`, where `log_address` is a `u16` without a `range`.

Fix: Give the register the `range` of the addresses at which the table can begin. If the table always begins at the
same address, state only `base`.
"""

from __future__ import annotations

from fieldspec.language.checks.addresses import table_words
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.numbers import number_objection
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Register, Table
from fieldspec.language.model.sizes import RecordSizes


def bases_apply(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for table in device.tables.values():
        register = device.register(table.base_by) if table.base_by else None
        if register is None:
            continue
        extent = (table.count - 1) * table.stride + table_words(table, sizes)
        wrong = number_objection(register, "address") or _no_address(device, table, register, extent)
        if wrong:
            text = f"{register.name} cannot be the address of {table.name}: {wrong}"
            help = "name the register with the address of the first element, or correct that register"
            yield finding(table.place, "base_by", text, help, label(register.place, "name", "the register"))
        yield from _detections(device, table)


def _no_address(device: Device, table: Table, register: Register, extent: int) -> str:
    """Why the range of a register cannot be the base address of a table with `words` words; empty if it can."""
    value, space = register.value, device.space(table.space)
    bounds = space.bounds.intervals
    if value.ranges is None:
        return "it has no `range`"
    if not all(
        any(first <= low and high + extent - 1 <= last for first, last in bounds)
        for low, high in value.ranges.intervals
    ):
        return f"its `range` lets elements be outside of {space.name}"
    if table.base not in value.ranges:
        return f"its `range` does not include the base 0x{table.base:04X}"
    if value.default not in (None, table.base):
        return f"its `default` is {value.default}, and the base 0x{table.base:04X}"
    is_apart = device.space_name(register.space) != device.space_name(table.space)
    first, last = register.address, register.end - 1
    return "" if is_apart or table.base > last or first > table.base + extent - 1 else "it is in one of the elements"


def _detections(device: Device, table: Table) -> Findings:
    """A version is identified by a value at a constant address."""
    record = device.records.get(table.record)
    paths = {field.place.path for field in record.fields} if record is not None else set()
    for line in device.lines:
        if line.detected_by is not None and line.detected_by.fact in paths:
            text = f"the version is detected by a field of {table.name}, whose address depends on the device"
            yield finding(table.place, "base_by", text, "name a register under `detected_by`")
