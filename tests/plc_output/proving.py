"""Values of the reference codec as arguments and results of generated functions, and back."""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import field as fresh_each_time
from typing import Any

from st_machine import Machine

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Real,
    Text,
    Truth,
    Whole,
    is_array,
    is_octets,
    is_text,
    number_of,
    real_bits,
    real_number,
    whole_bits,
    whole_number,
)
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.frames import head_members
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import link_words
from fieldspec.targets.controllers.statements.expressions import BITS, EnumType, Type
from fieldspec.targets.controllers.statements.routine import STATUSES

STATUS = {number: name for number, (name, _) in enumerate(STATUSES)}
REASONS = {"wrong_const": "wrong_constant", "not_hex": "not_hexadecimal"}
"""The statuses of the reasons that the reference calls otherwise."""


@dataclass
class Proof:
    """A machine that has loaded what is generated for a device, and the names in it."""

    world: World
    machine: Machine
    ran: set[str] = fresh_each_time(default_factory=set)

    def run(self, name: str, **value: Any) -> tuple[str, dict[str, Any]]:
        """The status that a function returns, and its outputs by name."""
        self.ran.add(name)
        named_item = self.machine.named(name, **value)
        return STATUS[named_item.pop(name.lower())], named_item

    def positional(self, name: str, *value: Any) -> tuple[str, list[Any]]:
        """The same, with what is given and the outputs in the order of their declaration."""
        variables = self.machine.unit.functions[name.lower()].variables
        wanted = [variable for role, variable, _, _ in variables if role in ("VAR_INPUT", "VAR_IN_OUT")]
        status, run_result = self.run(name, **dict(zip(wanted, value, strict=True)))
        return status, list(run_result.values())

    def into(self, value: Value, kind: Type, raw: Any) -> Any:
        """A raw value of the reference as a variable holds it."""
        if is_text(value.encoding):
            return list(raw.encode("ascii", "replace").ljust(value.size, b"\0"))
        if is_octets(value.encoding):
            return list(raw)
        whole = number_of(value.encoding)
        if whole is None or isinstance(kind, EnumType) or not _bits(kind):
            return raw
        return whole_bits(whole, raw) & ((1 << whole.bits) - 1)

    def out(self, value: Value, kind: Type, plc_value: Any) -> Any:
        """What a variable holds, as a raw value of the reference."""
        if is_text(value.encoding):
            return bytes(plc_value).rstrip(b"\0").decode("ascii", "replace")  # where it is refused
        if is_octets(value.encoding):
            return bytes(plc_value)
        whole = number_of(value.encoding)
        return whole_number(whole, plc_value) if whole is not None and _bits(kind) else plc_value

    def struct_in(self, record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
        """A variable of a record's struct."""
        fresh = self.machine.fresh(self.world.names.structs[record.name].lower())
        for field in record.fields:
            if is_user_field(field):
                fresh[self.world.member(record.name, field.name).lower()] = self.field_in(field, values[field.name])
        return dict(fresh)

    def struct_out(self, record: RecordLayout, value: dict[str, Any]) -> dict[str, Any]:
        """The values of a variable of a record's struct."""
        return {
            field.name: self.field_out(field, value[self.world.member(record.name, field.name).lower()])
            for field in _input_fields(record)
        }

    def field_in(self, field: FieldLayout, raw: Any) -> Any:
        """The variable of a field."""
        return [self._value_in(field, item) for item in raw] if field.is_list else self._value_in(field, raw)

    def field_out(self, field: FieldLayout, value: Any) -> Any:
        """The value of a field's variable."""
        return [self._value_out(field, item) for item in value] if field.is_list else self._value_out(field, value)

    def _value_in(self, field: FieldLayout, raw: Any) -> Any:
        if field.record is not None:
            return self.struct_in(field.record, raw)
        assert field.value is not None
        return self.into(field.value, self.world.type_of(field.value), raw)

    def _value_out(self, field: FieldLayout, value: Any) -> Any:
        if field.record is not None:
            return self.struct_out(field.record, value)
        assert field.value is not None
        return self.out(field.value, self.world.type_of(field.value), value)

    def register_in(self, register: RegisterLayout, raw: list[Any]) -> Any:
        """The variable of a register, of the values of its elements."""
        value = register.register.value
        result = [self.into(value, self.world.type_of(value), item) for item in raw]
        return result if register.count > 1 else result[0]

    def register_out(self, register: RegisterLayout, plc_value: Any) -> list[Any]:
        """The values of a register's elements."""
        value = register.register.value
        kind = self.world.type_of(value)
        return [self.out(value, kind, variable) for variable in (plc_value if register.count > 1 else [plc_value])]

    def fresh(self, kind: Type) -> Any:
        """A fresh array."""
        return [0] * (kind.high - kind.low + 1)  # type: ignore[union-attr]

    def build(self, link: LinkLayout, message: MessageLayout, values: dict[str, Any]) -> tuple[str, bytes]:
        """The status and the request that a generated function builds."""
        frame = self.fresh(self.world.frame)
        name = self.world.routine("build", *link_words(self.world, link), message.name)
        status, outputs = self.positional(name, *self.asked(link, message, values), frame)
        return status, bytes(frame[: outputs[-1]])

    def asked(self, link: LinkLayout, message: MessageLayout, values: dict[str, Any]) -> list[Any]:
        """The values of a request as arguments in the order of their declaration, lists and structs at the end."""
        arguments: list[Any] = []
        for part in head_members(link.request):
            assert part.value is not None
            arguments.append(self.into(part.value, self.world.type_of(part.value), values[part.name]))
        return arguments + self._body_in(message, message.request, values)

    def _body_in(self, message: MessageLayout, record: RecordLayout, values: dict[str, Any]) -> list[Any]:
        arguments: list[Any] = []
        for field in _input_fields(record):
            raw = values[field.name]
            if field.cases:
                arguments += [_filled(self._chosen_in(record, field, raw, values), field), len(raw)]
            elif field.field.repeat is not None:
                field_in = self.field_in(field, raw)
                is_bits = self.world.layout.device.bit_access(message.message) is not None
                shared = self.world.bits if is_bits else self.world.words
                size = len(self.fresh(shared)) if _registers(message, field) else field.field.repeat.high
                arguments += [
                    field_in + [field_in[-1] if field_in else self._empty(field)] * (size - len(field_in)),
                    len(raw),
                ]
            else:
                arguments.append(self.field_in(field, raw))
        lent = (list, dict)
        return [
            *(argument for argument in arguments if not isinstance(argument, lent)),
            *(o for o in arguments if isinstance(o, lent)),
        ]

    def _empty(self, field: FieldLayout) -> Any:
        if field.record is not None:
            return self.machine.fresh(self.world.names.structs[field.record.name].lower())
        return 0

    def _chosen_in(self, record: RecordLayout, field: FieldLayout, raw: list[Any], values: dict[str, Any]) -> list[int]:
        """The elements of a field with cases as bits."""
        assert record.selector is not None
        case = next(case for case in field.cases if values[record.selector.name] in case.numbers)
        encoding = case.value.encoding
        match encoding:
            case Real():
                return [real_bits(encoding.precision, item) for item in raw]
            case Whole():
                return [whole_bits(encoding, item) & ((1 << encoding.bits) - 1) for item in raw]
            case Truth():
                return [int(item) for item in raw]
            case Digits() | Text() | Octets():
                raise AssertionError("no function converts it")
            case _:
                assert_never(encoding)

    def parse(self, link: LinkLayout, message: MessageLayout, frame: bytes) -> tuple[str, dict[str, Any]]:
        """The status of a response that a generated function parses, and its values by the names of parts and fields.

        Those of an error reply are there where it is one.
        """
        name = self.world.routine("parse", *link_words(self.world, link), message.name)
        variables = self.machine.unit.functions[name.lower()].variables
        roles = {variable: role for role, variable, _, _ in variables}
        kinds = {variable: kind for _, variable, kind, _ in variables}
        value: dict[str, Any] = {role: self.machine.fresh(kinds[role]) for role in roles if roles[role] == "VAR_IN_OUT"}
        value["aframe"][: len(frame)] = frame
        lent = dict(value)
        status, outputs = self.run(name, ilength=len(frame), **lent)
        output_names = [
            role for role in roles if roles[role] == "VAR_OUTPUT" or (roles[role] == "VAR_IN_OUT" and role != "aframe")
        ]
        result = {item: outputs.get(item, lent.get(item)) for item in output_names}
        values: dict[str, Any] = {}
        queue = _Queue(result, roles)
        for part in head_members(link.response):
            assert part.value is not None
            values[part.name] = self.out(part.value, self.world.type_of(part.value), queue.next("VAR_OUTPUT"))
        self._body_out(message, message.response, queue, values)
        error = link.link.exception_response
        if error is not None and status == "refused":
            values = {}
            for field in _input_fields(self.world.layout.records[error.record]):
                values[field.name] = self.field_out(field, queue.next("VAR_OUTPUT"))
        return status, values

    def _body_out(self, message: MessageLayout, record: RecordLayout, queue: _Queue, values: dict[str, Any]) -> None:
        for field in _input_fields(record):
            if field.cases:
                value, count = queue.next("VAR_IN_OUT"), queue.next("VAR_OUTPUT")
                values[field.name] = self._chosen_out(record, field, value[:count], values)
            elif field.field.repeat is not None:
                value, count = queue.next("VAR_IN_OUT"), queue.next("VAR_OUTPUT")
                values[field.name] = self.field_out(field, value[:count])
            else:
                lent = field.is_list or field.record is not None or (field.value and is_array(field.value.encoding))
                values[field.name] = self.field_out(field, queue.next("VAR_IN_OUT" if lent else "VAR_OUTPUT"))

    def _chosen_out(
        self, record: RecordLayout, field: FieldLayout, value: list[int], values: dict[str, Any]
    ) -> list[Any]:
        assert record.selector is not None
        case = next((case for case in field.cases if values[record.selector.name] in case.numbers), field.cases[0])
        encoding = case.value.encoding
        match encoding:
            case Real():
                return [real_number(encoding.precision, item) for item in value]
            case Whole():
                return [whole_number(encoding, item) for item in value]
            case Truth():
                return [bool(item) for item in value]
            case Digits() | Text() | Octets():
                raise AssertionError("no function converts it")
            case _:
                assert_never(encoding)


def without(record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
    """The values that users get: no constants, no measures, nothing reserved."""
    shape = record.of_number(values.get(record.selector.name)) if record.selector is not None else record
    assert shape is not None
    remaining = {}
    for field in shape.fields:
        constant = field.value is not None and field.value.const is not None
        if constant or field.field.measures or field.field.reserved:
            continue
        value = values[field.name]
        if field.record is not None:
            inner = field.record
            value = [without(inner, item) for item in value] if field.is_list else without(inner, value)
        remaining[field.name] = value
    return remaining


class _Queue:
    """Variables in the order of their declaration, taken by their roles."""

    def __init__(self, result: dict[str, Any], roles: dict[str, str]) -> None:
        self._found = {
            role: [result[text] for text in result if roles[text] == role] for role in ("VAR_OUTPUT", "VAR_IN_OUT")
        }

    def next(self, role: str) -> Any:
        """The next variable with a role."""
        return self._found[role].pop(0)


def _input_fields(record: RecordLayout) -> list[FieldLayout]:
    return [field for field in record.fields if is_user_field(field)]


def _registers(message: MessageLayout, field: FieldLayout) -> bool:
    access = message.message.single_access
    return access is not None and field.name == access.values


def _filled(value: list[int], field: FieldLayout) -> list[int]:
    repeat = field.field.repeat
    assert repeat is not None
    return value + [0] * (repeat.high - len(value))


def _bits(kind: Type) -> bool:
    return kind in BITS.values()
