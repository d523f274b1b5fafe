"""Which facts of a device an output has to leave out because of those that it cannot express."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.registers import Parameter, Table
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class Cause:
    """Why a fact is absent: in words, and the finding about the fact that the output cannot express."""

    reason: str
    finding: Diagnostic


Causes = tuple[Cause, ...]


@dataclass(frozen=True, slots=True)
class Absences:
    """The absent facts of each kind by name, with the reasons; `bodies` are by message and direction.

    A message is absent if one of its bodies is. `parameters` are by the names of their sets and their own.
    `findings` are those that forbid the output: they are about frames, which every message needs.
    """

    registers: Mapping[str, Causes]
    records: Mapping[str, Causes]
    bodies: Mapping[tuple[str, str], Causes]
    messages: Mapping[str, Causes]
    tables: Mapping[str, Causes]
    parameters: Mapping[tuple[str, str], Causes]
    conversions: Mapping[str, Causes]
    findings: tuple[Diagnostic, ...]

    def each(self) -> Iterator[tuple[str, str, Causes]]:
        """The kind and the name of each absent fact, with the reasons."""
        for kind, absent in (
            ("register", self.registers),
            ("table", self.tables),
            ("record", self.records),
            ("message", self.messages),
            ("conversion", self.conversions),
        ):
            for name, causes in absent.items():
                yield kind, name, causes
        for (set_name, name), causes in self.parameters.items():
            yield "parameter", f"{set_name}/{name}", causes


def absences(layout: DeviceLayout, refusals: Iterable[Refusal], reads_exceptions: bool = True) -> Absences:
    """The facts that have to be absent: each refused fact, all facts that contain it, and all facts that are read with
    it.

    An output that reads exception responses cannot do without their records.
    """
    return _Search(layout, refusals).result(reads_exceptions)


class _Search:
    """A search for absent facts, from the innermost ones on."""

    def __init__(self, layout: DeviceLayout, refusals: Iterable[Refusal]) -> None:
        self.layout = layout
        self.refused: dict[str, list[Diagnostic]] = {}
        for refusal in refusals:
            self.refused.setdefault(refusal.path, []).append(refusal.finding)
        self.registers: dict[str, Causes] = {}
        self.records: dict[str, Causes] = {}

    def result(self, reads_exceptions: bool) -> Absences:
        """All absences. Without the records of exception responses, an output that reads these is impossible."""
        layout, device = self.layout, self.layout.device
        self._find_registers()
        for record in layout.records.values():
            if causes := (*self._own_causes(record.record.place.path), *self._in_record(record)):
                self.records[record.name] = causes
        bodies = {
            (message.name, direction): causes
            for message in layout.messages.values()
            for direction in ("request", "response")
            if (causes := (*self._in_record(message.data(direction)), *self._own_causes(message.message.place.path)))
        }
        messages = {
            message.name: causes for message in layout.messages.values() if (causes := _of_message(message, bodies))
        }
        conversions = {
            name: causes
            for name, own in device.conversions.items()
            if (causes := tuple(self._own_causes(own.place.path)))
        }
        tables = {name: causes for name, table in device.tables.items() if (causes := tuple(self._in_table(table)))}
        parameters = {
            (parameter_set.name, parameter.name): causes
            for parameter_set in device.parameters.values()
            for parameter in parameter_set.parameters
            if (causes := tuple(self._in_parameter(parameter)))
        }
        stated = (self.registers, self.records, bodies, tables, parameters, conversions)
        expressed = {id(cause.finding) for absent in stated for causes in absent.values() for cause in causes}
        required = {id(finding) for finding in self._in_exceptions()} if reads_exceptions else set[int]()
        findings = [finding for findings in self.refused.values() for finding in findings]
        return Absences(
            self.registers,
            self.records,
            bodies,
            messages,
            tables,
            parameters,
            conversions,
            tuple(finding for finding in findings if id(finding) in required or id(finding) not in expressed),
        )

    def _own_causes(self, path: str) -> Iterator[Cause]:
        """The reasons why the fact with a path itself is refused."""
        for finding in self.refused.get(path, ()):
            yield Cause(finding.message, finding)

    def _find_registers(self) -> None:
        for layout in self.layout.registers:
            if causes := tuple(self._own_causes(layout.register.place.path)):
                self.registers[layout.name] = causes
        before = -1
        while before != len(self.registers):
            before = len(self.registers)
            for layout in self.layout.registers:
                causes = tuple(self._in_exponent(layout.register.value))
                if causes and layout.name not in self.registers:
                    self.registers[layout.name] = causes

    def _in_exponent(self, value: Value | None) -> Iterator[Cause]:
        """The reasons why the register with the exponent of a scale is absent."""
        if value is not None and value.scale_by:
            yield from _because(f"the exponent of its scale is in {value.scale_by}", self.registers.get(value.scale_by))

    def _in_record(self, record: RecordLayout) -> Iterator[Cause]:
        for field in record.fields:
            yield from self._in_field(field)

    def _in_field(self, field: FieldLayout) -> Iterator[Cause]:
        yield from self._own_causes(field.field.place.path)
        for case in field.cases:
            yield from self._own_causes(case.case.place.path)
        yield from self._in_exponent(field.value)
        if field.record is not None:
            yield from self.records.get(field.record.name, ())

    def _in_table(self, table: Table) -> Iterator[Cause]:
        yield from self._own_causes(table.place.path)
        yield from self.records.get(table.record, ())
        yield from _because(f"its number of elements is in {table.count_by}", self.registers.get(table.count_by))
        yield from _because(f"its address is in {table.base_by}", self.registers.get(table.base_by))

    def _in_parameter(self, parameter: Parameter) -> Iterator[Cause]:
        yield from self._own_causes(parameter.place.path)
        for inner in parameter.subindices:
            yield from self._own_causes(inner.place.path)

    def _in_exceptions(self) -> Iterator[Diagnostic]:
        """The findings about the records of exception responses, which tell that a message was not carried out."""
        for link in self.layout.links.values():
            exception = link.link.exception_response
            for cause in self.records.get(exception.record, ()) if exception is not None else ():
                yield cause.finding


def _of_message(message: MessageLayout, bodies: Mapping[tuple[str, str], Causes]) -> Causes:
    return tuple(
        dict.fromkeys(
            cause for direction in ("request", "response") for cause in bodies.get((message.name, direction), ())
        )
    )


def _because(reason: str, causes: Causes | None) -> Iterator[Cause]:
    """The findings of some reasons with another reason, which comes of them."""
    for cause in causes or ():
        yield Cause(f"{reason}, which is left out: {cause.reason}", cause.finding)
