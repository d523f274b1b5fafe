"""The `count_by` of a record table names a register in the address space of the table: a single readable whole number
without a scale, names or sentinels, whose `range` is between 0 and the `count` of the table.

Why: programs read the number of elements and request only these. Arrays have room for `count` elements, and the
following addresses belong to other data.

Example: `count: 4, count_by: module_count`, where `module_count` is a `u16` without a `range`.

Fix: State the maximum number of elements under `count`, and as the end of the register's `range`. If the number is
always the same, state only `count`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.numbers import number_objection
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Register, Table


def counts_apply(device: Device) -> Findings:
    for table in device.tables.values():
        register = device.register(table.count_by) if table.count_by else None
        wrong = _no_count(device, table, register) if register is not None else ""
        if register is not None and wrong:
            text = f"{register.name} cannot be the number of elements of {table.name}: {wrong}"
            help = "name the register with the number of elements, or correct that register"
            yield finding(table.place, "count_by", text, help, label(register.place, "name", "the register"))


def _no_count(device: Device, table: Table, register: Register) -> str:
    """Why a register does not have the number of elements of a table; empty where it may."""
    value = register.value
    if device.space_name(register.space) != device.space_name(table.space):
        return "it is in another address space"
    if wrong := number_objection(register, "number of elements"):
        return wrong
    if value.ranges is None or value.ranges.low < 0 or value.ranges.high > table.count:
        return f"its `range` is not within 0..{table.count}"
    first, last = register.address, register.end - 1
    if first <= table.address(table.indexes[-1]) + table.stride - 1 and table.base <= last:
        return "it is one of the elements"
    return ""
