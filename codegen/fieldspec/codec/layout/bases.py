"""Tables that begin where a register of the device says."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.codec.layout.record import RegisterLayout


def moving_tables(layout: DeviceLayout) -> dict[str, RegisterLayout]:
    """The register that has the address of the first element, by the name of each table that has one."""
    names = {table.name: table.table.base_by for table in layout.tables.values() if table.table.base_by}
    registers = {register.name: register for register in layout.registers} if names else {}
    return {table: registers[name] for table, name in names.items()}


def at_bases(layout: DeviceLayout, bases: Mapping[str, int]) -> DeviceLayout:
    """The layout with tables at known base addresses, by the names of the tables; they do not move any more."""
    if not bases:
        return layout
    tables = {
        name: replace(table, table=replace(table.table, base=bases[name], base_by="")) if name in bases else table
        for name, table in layout.tables.items()
    }
    return replace(layout, tables=tables)


def at_usual_bases(layout: DeviceLayout) -> DeviceLayout:
    """A layout whose tables begin where they usually do."""
    return at_bases(layout, {name: layout.tables[name].table.base for name in moving_tables(layout)})


def base_refusals(layout: DeviceLayout, reader: str, for_controllers: bool = False) -> list[Refusal]:
    """A refusal of each table that begins where a register says. `reader` is what has constant addresses."""
    return [
        Refusal(
            table,
            Diagnostic(
                "plc_addresses_constant" if for_controllers else "output_addresses_constant",
                f"{table.name} begins where {table.base_by} says, and {reader} has constant addresses",
                table.place["base_by"],
                help=LEAVE_OUT,
            ),
        )
        for table in (layout.tables[name].table for name in moving_tables(layout))
    ]
