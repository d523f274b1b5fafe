"""What of a device can be observed: its registers, fields and parameters, by the paths that dumps and captures have."""

from __future__ import annotations

import re

from fieldspec.codec.layout.bases import at_usual_bases, moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Table
from fieldspec.language.model.value import Value
from fieldspec.tools.audit.addressed_values import values_of_record
from fieldspec.tools.live.reading import all_occupants

_INDEX = re.compile(r"\[[0-9]+\]")

READ, WRITE = "read", "write"


@dataclass(frozen=True, slots=True)
class Observable:
    """A value: its fact, and what the spec says of its access. `address` is None for a field of a message, and of a
    table that begins where the device says.

    `same_as` is the path of the register of which it is an alias.
    """

    path: str
    fact: Fact
    value: Value
    access: str
    space: str = ""
    address: int | None = None
    same_as: str = ""


class Observables:
    """All values of a device that files of units can show."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.registers: dict[tuple[str, str], Observable] = {}
        moving = moving_tables(layout)
        for space, occupant in all_occupants(at_usual_bases(layout)):
            if not occupant.reserved and not getattr(occupant.fact, "reserved", False):
                same_as = getattr(occupant.fact, "same_as", "")
                address = (
                    None if isinstance(occupant.outer, Table) and occupant.outer.name in moving else occupant.address
                )
                self.registers[space, occupant.path] = Observable(
                    occupant.path, occupant.fact, occupant.value, occupant.access, space, address, same_as
                )
        self.parameters: dict[str, Observable] = {}
        for parameter_set in layout.device.parameters.values():
            for parameter in parameter_set.parameters:
                if parameter.reserved:
                    continue
                path = parameter.place.path
                space = parameter_set.space
                self.parameters[path] = Observable(parameter.name, parameter, parameter.value, parameter.access, space)
                for element in parameter.subindices:
                    if not element.reserved:
                        access = element.access or parameter.access
                        own = Observable(parameter.name, element, element.value, access, space)
                        self.parameters[element.place.path] = own
        self.fields: dict[tuple[str, str], Observable] = {}
        for message in layout.messages.values():
            if message.message.single_access is not None:
                continue
            for operation, record in ((WRITE, message.request), (READ, message.response)):
                for item in (record, *record.chosen.values()):
                    for name, field, _, _ in values_of_record(item, ""):
                        path = bare(f"{message.name}.{name}")
                        if field.value is not None and not field.field.reserved:
                            self.fields[operation, path] = Observable(path, field.field, field.value, "")
        self.all = (*self.registers.values(), *self.parameters.values(), *self.fields.values())


def bare(path: str) -> str:
    """A path without the numbers of elements."""
    return _INDEX.sub("", path)
