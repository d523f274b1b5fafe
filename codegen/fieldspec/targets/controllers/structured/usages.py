"""How programs of controllers use what is generated: code for registers, fields of tables and telegrams, parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.targets.controllers.declarations import Declarations
from fieldspec.targets.controllers.routines.blocks.ports import AXIS
from fieldspec.targets.controllers.routines.printer import parameter
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.registers import registers_of
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.routine import bare
from fieldspec.targets.usages import Usage, VersionUsages, spelling


def version_usages(
    output: str, language: str, layout: DeviceLayout, declare: Callable[[DeviceLayout], Declarations]
) -> dict[str, VersionUsages]:
    """The code for the one version of a device that an output has, with the names that it declares."""
    rows = spelling(output, layout, partial(usage_rows, layout, declare))
    return {layout.device.version: VersionUsages(language, {}, rows)}


def usage_rows(layout: DeviceLayout, declare: Callable[[DeviceLayout], Declarations]) -> Iterator[Usage]:
    """The code that reads or writes each fact; none where there is no program."""
    declared = declare(layout)
    return iter(()) if has_errors(declared.findings) else _usages(declared)


def _usages(declared: Declarations) -> Iterator[Usage]:
    """The code for all facts of a device that a dialect has. The transferred values of a block are in its struct."""
    uses = _Usages(declared, dict(_constants(declared)))
    yield from uses.registers()
    yield from uses.tables()
    yield from uses.telegrams()
    yield from uses.parameters()


def _constants(declared: Declarations) -> Iterator[tuple[str, str]]:
    """The constants of addresses and numbers of parameters by the paths of facts, as programs name them."""
    for constants in declared.constants:
        if constants.key in ("addresses", "parameters"):
            for constant in reversed(constants.constants):
                if constant.fact is not None:
                    name = f"{constants.name}.{constant.name}" if declared.dialect.qualified else f'"{constant.name}"'
                    yield constant.fact.place.path, name


@dataclass(frozen=True, slots=True)
class _Usages:
    """The declarations of a device, and its constants by the paths of facts."""

    declared: Declarations
    constants: Mapping[str, str]

    @property
    def world(self) -> World:
        """The names of the device's declarations."""
        return self.declared.world

    @property
    def layout(self) -> DeviceLayout:
        """The layout that the dialect declares."""
        return self.declared.layout

    def registers(self) -> Iterator[Usage]:
        """The code for registers of the first space of words."""
        for group in self._groups():
            registers = registers_of(self.layout, group)
            reads = any(readable(register.register.access) for register in registers)
            for register in registers:
                fact = register.register
                constant = self.constants.get(fact.place.path)
                if (
                    constant is None
                    or fact.reserved
                    or register.count > 1
                    or register.words > self.world.words.high + 1
                ):
                    continue
                blocks = [("read", reads and readable(fact.access)), ("write", writable(fact.access) or fact.trigger)]
                ways = [direction for direction, is_possible in blocks if is_possible]
                if ways:
                    arguments = (
                        f"{self._parameter('Address')} := {constant}, {self._parameter('Count')} := {register.words}"
                    )
                    yield self._usage(fact.place.path, ways, group.name, group.name, arguments, register.name)

    def tables(self) -> Iterator[Usage]:
        """The code for the fields of one element of a table."""
        device = self.layout.device
        records = [table.record.name for table in self.layout.tables.values()]
        if AXIS not in self.world.names.structs or device.space("").unit != WORD:
            return
        for table in self.layout.tables.values():
            words = (table.record.size or 0) // 2
            if device.space_name(table.table.space) != device.space_name("") or words > self.world.words.high + 1:
                continue
            record = table.record.name
            name = record if records.count(record) == 1 else f"{table.name}_element"
            for field in table.record.fields:
                if is_user_field(field) and field.value is not None and not field.is_list:
                    ways = ["read", *(["write"] if writable(table.access(field.field)) and table.writable else [])]
                    arguments = f"{self._parameter('Number')} := {table.table.index_from}"
                    yield self._usage(field.field.place.path, ways, name, record, arguments, field.name)

    def telegrams(self) -> Iterator[Usage]:
        """The code for the fields of process data."""
        spelling = self.declared.dialect.spelling
        for message in telegrams(self.layout):
            for record, deed in ((message.request, "pack"), (message.response, "unpack")):
                if record.name not in self.world.names.structs:
                    continue
                function = spelling.routine.format(self.world.routine(deed, record.name, "bytes"))
                variable = self._variable("stData")
                kind = spelling.struct.format(self.world.struct(record.name).name)
                for field in record.fields:
                    if not is_user_field(field) or field.value is None or field.is_list:
                        continue
                    member = f"{variable}.@2@"
                    if deed == "pack":
                        text = f"// {variable} : @0@;\n{member} := value;\n// then @1@ makes the bytes that are sent\n"
                    else:
                        text = f"// {variable} : @0@; @1@ has filled it from the bytes received\nvalue := {member};\n"
                    text = text.replace("value", spelling.variable.format("value"), 1)
                    name = self.world.member(record.name, field.name)
                    yield Usage(field.field.place.path, text, (kind, function, name))

    def parameters(self) -> Iterator[Usage]:
        """The code for the numbers of parameters."""
        variable = self._variable("uiNumber")
        for parameter_set in self.layout.device.parameters.values():
            for row in parameter_set.parameters:
                constant = self.constants.get(row.place.path)
                if constant is not None and not row.reserved:
                    yield Usage(row.place.path, f"{variable} := @0@;\n", (constant,))

    def _parameter(self, name: str) -> str:
        return parameter(name, self.declared.dialect.spelling)

    def _variable(self, name: str) -> str:
        """A variable of the program: `stData`, or `#data` for Siemens, where an instance is `#instRead`."""
        spelling = self.declared.dialect.spelling
        is_instance = spelling.siemens_names and name.startswith("fb")
        return spelling.variable.format(f"inst{bare(name)}" if is_instance else parameter(name, spelling))

    def _groups(self) -> Iterator[RegisterGroup]:
        device = self.layout.device
        if AXIS in self.world.names.structs and device.space("").unit == WORD:
            for group in device.groups:
                if device.space_name(group.space) == device.space_name(""):
                    yield group

    def _usage(self, path: str, ways: list[str], block: str, struct: str, arguments: str, member: str) -> Usage:
        """The calls of the blocks that read and write, and the member of the struct that they transfer."""
        spelling, world = self.declared.dialect.spelling, self.world
        axis, data = self._variable("stAxis"), self._variable("stData")
        text = ""
        names: list[str] = [
            arguments,
            world.member(struct, member),
            spelling.struct.format(world.struct(AXIS).name),
            spelling.struct.format(world.struct(struct).name),
        ]
        for direction in ways:
            names.append(spelling.struct.format(world.block(direction, block)))
            text += f"// {self._variable(f'fb{direction.title()}')} : @{len(names) - 1}@;\n"
        text += f"// {axis} : @2@; a client block serves it in each scan\n// {data} : @3@;\n"
        for direction in ways:
            if direction == "write":
                text += f"{data}.@1@ := {spelling.variable.format('value')};\n"
            block, execute = (self._variable(f"{prefix}{direction.title()}") for prefix in ("fb", "x"))
            lent = f"{self._parameter('Axis')} := {axis}, {self._parameter('Data')} := {data}"
            text += f"{block}({self._parameter('Execute')} := {execute}, @0@, {lent});\n"
            if direction == "read":
                value = spelling.variable.format("value")
                text += f"IF {block}.{self._parameter('Done')} THEN\n    {value} := {data}.@1@;\nEND_IF;\n"
        return Usage(path, text, tuple(names))
