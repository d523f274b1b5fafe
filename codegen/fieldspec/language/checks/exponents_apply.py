"""A register or a field whose scale is read from the device is a whole number without a scale, offset or names of its
own. Its `scale_by` names another register or, for a field, another field of the same record: a single readable whole
number without a scale, whose `range` is within -22..22. The register with the exponent is in the same address space as
the scaled register, or as the tables with the scaled field.

Why: programs read the exponent, and compute quantities with it. Beyond 10^22, a power of ten is not an exact
floating-point
number.

Example: `scale_by: power_sf`, where `power_sf` is a `u16` without a `range`.

Fix: Give the exponent its printed `range`, such as -10..10, and its value for "not available" under `sentinels`. State
bounds of the scaled value in counts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.checks.inferred_keys_present import has_key
from fieldspec.language.model.access import readable
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.registers import Register, Table
from fieldspec.language.model.table_records import table_records
from fieldspec.language.model.value import MOST_PLACES, Value

_OWN = ("scale", "offset", "enum", "flags", "const", "parameter", "measures", "reserved")


def exponents_apply(device: Device) -> Findings:
    registers = {register.name: register for register in device.registers()}
    for register in registers.values():
        if not register.value.scale_by:
            continue
        yield from _scaled(register, register.value)
        exponent = registers.get(register.value.scale_by)
        if exponent is not None:
            yield from _unfit(register, exponent, _no_exponent(device, register, exponent))
    uses = table_records(device)
    for layer in layers(device):
        tables = [use.table for use in uses.get(layer.name, ())]
        for field in layer.fields:
            if field.value is not None and field.value.scale_by:
                yield from _scaled(field, field.value)
                yield from _of_field(device, layer, field, registers, tables)


def _of_field(
    device: Device, layer: Record, field: Field, registers: Mapping[str, Register], tables: Sequence[Table]
) -> Findings:
    """The findings of the exponent of a field, which is another field or a register. `tables` have its record."""
    name = field.value.scale_by if field.value is not None else ""
    sibling, register = layer.named(name), registers.get(name)
    if sibling is not None and register is not None:
        text = f"both a field of {layer.name} and a register have the name {name}"
        yield finding(field.place, "scale_by", text, "rename one of them")
    elif sibling is not None:
        yield from _unfit(field, sibling, _no_exponent_beside(field, sibling))
    elif register is not None:
        wrong = _no_register(register)
        for table in tables:
            if device.space_name(table.space) != device.space_name(register.space):
                wrong = wrong or f"{table.name} is in another address space"
        yield from _unfit(field, register, wrong)


def _scaled(fact: Register | Field, value: Value) -> Findings:
    """The findings of a value that takes its scale from an exponent and cannot do so."""
    if not is_count(value.encoding):
        text = f"{fact.name} is {value.type.name}, to which `scale_by` does not apply"
        yield finding(fact.place, "scale_by", text, "remove it, or use an integer type")
    for key in _OWN:
        is_stated = value.scale != 1 if key == "scale" else has_key(fact, key)
        if is_stated and not (key == "reserved" and isinstance(fact, Register)):
            text = f"{fact.name} has `{key}`, and takes its scale from {value.scale_by}"
            yield finding(fact.place, key, text, "remove one of them")


def _unfit(fact: Register | Field, exponent: Register | Field, wrong: str) -> Findings:
    if wrong:
        kind = "register" if isinstance(exponent, Register) else "field"
        text = f"{exponent.name} cannot be the exponent of {fact.name}: {wrong}"
        yield finding(fact.place, "scale_by", text, f"name the {kind} with the power of ten")


def _no_exponent(device: Device, register: Register, exponent: Register) -> str:
    """The reason why a register cannot be the exponent of another one; empty where it can."""
    if exponent is register:
        return "it is the register itself"
    if device.space_name(exponent.space) != device.space_name(register.space):
        return "it is in another address space"
    return _no_register(exponent)


def _no_register(exponent: Register) -> str:
    """The reason why a register cannot be an exponent; empty where it can."""
    if not _is_number(exponent.value):
        return _NO_NUMBER
    if exponent.count > 1:
        return f"it stands for {exponent.count} registers"
    if exponent.reserved or exponent.trigger or not readable(exponent.access):
        return "the spec does not say that it can be read"
    return _wrong_ranges(exponent.value)


def _no_exponent_beside(field: Field, exponent: Field) -> str:
    """Why a field is not the exponent of another one of its record; empty where it may be."""
    if exponent is field:
        return "it is the field itself"
    if exponent.value is None or not _is_number(exponent.value):
        return _NO_NUMBER
    if exponent.count is not None or exponent.repeat is not None:
        return "it is a list"
    if exponent.reserved or exponent.measures is not None or exponent.value.const is not None:
        return "programs do not read it as a number of its own"
    return _wrong_ranges(exponent.value)


_NO_NUMBER = "it is not a whole number without a scale and without names"


def _is_number(value: Value) -> bool:
    """Whether a value is a whole number without a scale and without names."""
    return is_count(value.encoding) and not (value.scaled or value.scale_by or value.enum or value.flags)


def _wrong_ranges(value: Value) -> str:
    """Why the numbers of a value are not exponents; empty where they are."""
    if value.write_ranges is not None:
        return "its `write_range` differs from what it may be"
    if value.ranges is None or value.ranges.low < -MOST_PLACES or value.ranges.high > MOST_PLACES:
        return f"its `range` is not within -{MOST_PLACES}..{MOST_PLACES}"
    special = merged(value.special_intervals)
    if any(uncovered(low, high, special) != [(low, high)] for low, high in value.ranges.intervals):
        return "a special value is within its `range`"
    return ""
