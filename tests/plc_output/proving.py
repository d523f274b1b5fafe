"""Values of the reference codec as arguments and results of generated functions, and back."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from dataclasses import field as fresh_each_time
from typing import Any

from st_machine import Machine

from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.model.value import Kind, Value
from fieldspec.plc.routines.expressions import BITS, EnumType, Type
from fieldspec.plc.routines.frames import head_members
from fieldspec.plc.routines.records import is_user_field
from fieldspec.plc.routines.routine import STATUSES
from fieldspec.plc.routines.world import World
from fieldspec.plc.routines.wrapping import link_words

STATUS = {number: name for number, (name, _) in enumerate(STATUSES)}
REASONS = {"wrong_const": "wrong_constant", "not_hex": "not_hexadecimal"}
"""The statuses of the reasons that the reference calls otherwise."""


@dataclass
class Proof:
    """A machine that has loaded what is generated for a device, and the names in it."""

    world: World
    machine: Machine
    ran: set[str] = fresh_each_time(default_factory=set)

    def run(self, name: str, **given: Any) -> tuple[str, dict[str, Any]]:
        """The status that a function returns, and its outputs by name."""
        self.ran.add(name)
        found = self.machine.named(name, **given)
        return STATUS[found.pop(name.lower())], found

    def positional(self, name: str, *given: Any) -> tuple[str, list[Any]]:
        """The same, with what is given and the outputs in the order of their declaration."""
        variables = self.machine.unit.functions[name.lower()].variables
        wanted = [one for role, one, _, _ in variables if role in ("VAR_INPUT", "VAR_IN_OUT")]
        status, found = self.run(name, **dict(zip(wanted, given, strict=True)))
        return status, list(found.values())

    def into(self, value: Value, kind: Type, raw: Any) -> Any:
        """A raw value of the reference as a variable holds it."""
        if value.type.kind is Kind.TEXT:
            return list(raw.encode("ascii", "replace").ljust(value.size, b"\0"))
        if value.type.kind is Kind.BYTES:
            return list(raw)
        if value.type.kind in (Kind.BOOLEAN, Kind.FLOAT):
            return raw
        return raw if isinstance(kind, EnumType) or not _bits(kind) else raw & ((1 << (8 * value.size)) - 1)

    def out(self, value: Value, kind: Type, held: Any) -> Any:
        """What a variable holds, as a raw value of the reference."""
        if value.type.kind is Kind.TEXT:
            return bytes(held).rstrip(b"\0").decode("ascii")
        if value.type.kind is Kind.BYTES:
            return bytes(held)
        if value.type.signed and value.type.kind is Kind.INTEGER and _bits(kind) and held > value.type.high:
            return held - (1 << (8 * value.size))
        return held

    def struct_in(self, record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
        """A variable of a record's struct."""
        fresh = self.machine.fresh(self.world.names.structs[record.name].lower())
        for one in record.fields:
            if is_user_field(one):
                fresh[self.world.member(record.name, one.name).lower()] = self.field_in(one, values[one.name])
        return dict(fresh)

    def struct_out(self, record: RecordLayout, held: dict[str, Any]) -> dict[str, Any]:
        """The values of a variable of a record's struct."""
        return {
            one.name: self.field_out(one, held[self.world.member(record.name, one.name).lower()])
            for one in _given(record)
        }

    def field_in(self, one: FieldLayout, raw: Any) -> Any:
        """The variable of a field."""
        return [self._one_in(one, item) for item in raw] if one.is_list else self._one_in(one, raw)

    def field_out(self, one: FieldLayout, held: Any) -> Any:
        """The value of a field's variable."""
        return [self._one_out(one, item) for item in held] if one.is_list else self._one_out(one, held)

    def _one_in(self, one: FieldLayout, raw: Any) -> Any:
        if one.record is not None:
            return self.struct_in(one.record, raw)
        assert one.value is not None
        return self.into(one.value, self.world.type_of(one.value), raw)

    def _one_out(self, one: FieldLayout, held: Any) -> Any:
        if one.record is not None:
            return self.struct_out(one.record, held)
        assert one.value is not None
        return self.out(one.value, self.world.type_of(one.value), held)

    def register_in(self, laid: RegisterLayout, raw: list[Any]) -> Any:
        """The variable of a register, of the values of its elements."""
        value = laid.register.value
        made = [self.into(value, self.world.type_of(value), one) for one in raw]
        return made if laid.count > 1 else made[0]

    def register_out(self, laid: RegisterLayout, held: Any) -> list[Any]:
        """The values of a register's elements."""
        value = laid.register.value
        kind = self.world.type_of(value)
        return [self.out(value, kind, one) for one in (held if laid.count > 1 else [held])]

    def fresh(self, kind: Type) -> Any:
        """A fresh array."""
        return [0] * (kind.high - kind.low + 1)  # type: ignore[union-attr]

    def build(self, link: LinkLayout, message: MessageLayout, values: dict[str, Any]) -> tuple[str, bytes]:
        """The status and the request that a generated function builds."""
        arguments: list[Any] = []
        for part in head_members(link.request):
            assert part.value is not None
            arguments.append(self.into(part.value, self.world.type_of(part.value), values[part.name]))
        arguments += self._body_in(message, message.request, values)
        frame = self.fresh(self.world.frame)
        name = self.world.routine("build", *link_words(self.world, link), message.name)
        status, outputs = self.positional(name, *arguments, frame)
        return status, bytes(frame[: outputs[-1]])

    def _body_in(self, message: MessageLayout, record: RecordLayout, values: dict[str, Any]) -> list[Any]:
        arguments: list[Any] = []
        for one in _given(record):
            raw = values[one.name]
            if one.cases:
                arguments += [_filled(self._chosen_in(record, one, raw, values), one), len(raw)]
            elif one.field.repeat is not None:
                held = self.field_in(one, raw)
                size = len(self.fresh(self.world.words)) if _registers(message, one) else one.field.repeat.high
                arguments += [held + [held[-1] if held else self._empty(one)] * (size - len(held)), len(raw)]
            else:
                arguments.append(self.field_in(one, raw))
        lent = (list, dict)
        return [
            *(one for one in arguments if not isinstance(one, lent)),
            *(o for o in arguments if isinstance(o, lent)),
        ]

    def _empty(self, one: FieldLayout) -> Any:
        if one.record is not None:
            return self.machine.fresh(self.world.names.structs[one.record.name].lower())
        return 0

    def _chosen_in(self, record: RecordLayout, one: FieldLayout, raw: list[Any], values: dict[str, Any]) -> list[int]:
        """The elements of a field with cases as bits."""
        assert record.selector is not None
        case = next(case for case in one.cases if values[record.selector.name] in case.numbers)
        size = case.value.size
        if case.value.type.kind is Kind.FLOAT:
            return [int.from_bytes(struct.pack(">f", item), "big") for item in raw]
        return [int(item) & ((1 << (8 * size)) - 1) for item in raw]

    def parse(self, link: LinkLayout, message: MessageLayout, frame: bytes) -> tuple[str, dict[str, Any]]:
        """The status of a response that a generated function parses, and its values by the names of parts and fields.

        Those of an error reply are there where it is one.
        """
        name = self.world.routine("parse", *link_words(self.world, link), message.name)
        variables = self.machine.unit.functions[name.lower()].variables
        roles = {one: role for role, one, _, _ in variables}
        kinds = {one: kind for _, one, kind, _ in variables}
        held: dict[str, Any] = {one: self.machine.fresh(kinds[one]) for one in roles if roles[one] == "VAR_IN_OUT"}
        held["aframe"][: len(frame)] = frame
        lent = dict(held)
        status, outputs = self.run(name, ilength=len(frame), **lent)
        given_back = [
            one for one in roles if roles[one] == "VAR_OUTPUT" or (roles[one] == "VAR_IN_OUT" and one != "aframe")
        ]
        found = {one: outputs.get(one, lent.get(one)) for one in given_back}
        values: dict[str, Any] = {}
        queue = _Queue(found, roles)
        for part in head_members(link.response):
            assert part.value is not None
            values[part.name] = self.out(part.value, self.world.type_of(part.value), queue.next("VAR_OUTPUT"))
        self._body_out(message, message.response, queue, values)
        error = link.link.exception_response
        if error is not None and status == "refused":
            values = {}
            for one in _given(self.world.layout.records[error.record]):
                values[one.name] = self.field_out(one, queue.next("VAR_OUTPUT"))
        return status, values

    def _body_out(self, message: MessageLayout, record: RecordLayout, queue: _Queue, values: dict[str, Any]) -> None:
        for one in _given(record):
            if one.cases:
                held, count = queue.next("VAR_IN_OUT"), queue.next("VAR_OUTPUT")
                values[one.name] = self._chosen_out(record, one, held[:count], values)
            elif one.field.repeat is not None:
                held, count = queue.next("VAR_IN_OUT"), queue.next("VAR_OUTPUT")
                values[one.name] = self.field_out(one, held[:count])
            else:
                lent = one.is_list or one.record is not None or (one.value and one.value.type.letter == "s")
                values[one.name] = self.field_out(one, queue.next("VAR_IN_OUT" if lent else "VAR_OUTPUT"))

    def _chosen_out(self, record: RecordLayout, one: FieldLayout, held: list[int], values: dict[str, Any]) -> list[Any]:
        assert record.selector is not None
        case = next((case for case in one.cases if values[record.selector.name] in case.numbers), one.cases[0])
        kind, size = case.value.type, case.value.size
        if kind.kind is Kind.FLOAT:
            return [struct.unpack(">f", item.to_bytes(4, "big"))[0] for item in held]
        if kind.kind is Kind.BOOLEAN:
            return [bool(item) for item in held]
        return [item - (1 << (8 * size)) if kind.signed and item > kind.high else item for item in held]


def without(record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
    """The values that users get: no constants, no measures, nothing reserved."""
    shape = record.of_number(values.get(record.selector.name)) if record.selector is not None else record
    assert shape is not None
    kept = {}
    for field in shape.fields:
        constant = field.value is not None and field.value.const is not None
        if constant or field.field.measures or field.field.reserved:
            continue
        held = values[field.name]
        if field.record is not None:
            inner = field.record
            held = [without(inner, item) for item in held] if field.is_list else without(inner, held)
        kept[field.name] = held
    return kept


class _Queue:
    """Variables in the order of their declaration, taken by their roles."""

    def __init__(self, found: dict[str, Any], roles: dict[str, str]) -> None:
        self._found = {
            role: [found[one] for one in found if roles[one] == role] for role in ("VAR_OUTPUT", "VAR_IN_OUT")
        }

    def next(self, role: str) -> Any:
        """The next variable with a role."""
        return self._found[role].pop(0)


def _given(record: RecordLayout) -> list[FieldLayout]:
    return [one for one in record.fields if is_user_field(one)]


def _registers(message: MessageLayout, one: FieldLayout) -> bool:
    access = message.message.accesses
    return access is not None and one.name == access.values


def _filled(held: list[int], one: FieldLayout) -> list[int]:
    repeat = one.field.repeat
    assert repeat is not None
    return held + [0] * (repeat.high - len(held))


def _bits(kind: Type) -> bool:
    return kind in BITS.values()
