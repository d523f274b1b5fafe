"""Requests that read and write numbered parameters."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.access import readable
from fieldspec.tools.simulator.memory import element_value, numbers_of
from fieldspec.tools.simulator.refusal import Refusal
from fieldspec.tools.simulator.register_requests import invalid
from fieldspec.tools.simulator.target import Target

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.codec.layout.values import Raw
    from fieldspec.tools.simulator.engine import Engine


def part_of(record: RecordLayout, part: str) -> FieldLayout | None:
    """The field of a record that is a part of a parameter access: number, subindex, value or values."""
    fields = (*record.fields, *(field for chosen in record.chosen.values() for field in chosen.fields))
    for field in fields:
        value = field.value if field.value is not None else None
        if value is not None and value.parameter is not None and value.parameter.part == part:
            return field
        for case in field.cases:
            if case.value.parameter is not None and case.value.parameter.part == part:
                return field
    return None


def count_field(record: RecordLayout, size: str = "") -> FieldLayout | None:
    """The field that says how many elements are meant: the only one that nothing else decides.

    `size` names a field with the number of bytes of a value, which is another one.
    """
    free = [
        field
        for field in record.fields
        if field.value is not None
        and not field.field.reserved
        and field.value.const is None
        and field.value.parameter is None
        and field.field.measures is None
        and field is not record.selector
        and field.name != size
    ]
    return free[0] if len(free) == 1 else None


def target_of(engine: Engine, record: RecordLayout, values: Mapping[str, Any], size: str = "") -> Target | None:
    """The parameter that a request names; None where it names none. Raises Refusal for one that does not exist.

    `size` names a field with the number of bytes of its value, empty without one.
    """
    numbered = part_of(record, "number")
    if numbered is None or numbered.value is None or numbered.value.parameter is None:
        return None
    device, wire_number = engine.layout.device, int(values[numbered.name])
    known = device.parameter_at(numbered.value.parameter.set, wire_number)
    if known is None:
        raise Refusal("unknown_address", f"no parameter has the number {wire_number}")
    indexed = part_of(record, "subindex")
    amount = count_field(record, size) if indexed is not None else None
    count = int(values[amount.name]) if amount is not None and values[amount.name] else None
    first = int(values[indexed.name]) if indexed is not None and (amount is None or count is not None) else 0
    carried = part_of(record, "value")
    content = values.get(carried.name) if carried is not None else None
    if count is not None and isinstance(content, list) and len(content) != count:
        raise Refusal("count_invalid", f"{len(content)} values for {count} elements")
    parameter = known[0].numbered(known[1])
    if parameter is None:
        return Target(known[0].name, known[1], None, first, count)
    element_count = parameter.elements or 1
    if count is not None and parameter.elements is None and (first or count > 1):
        raise Refusal("no_array", f"{parameter.name} has one value")
    if first + (count or 1) > element_count:
        raise Refusal("subindex_invalid", f"{parameter.name} has {element_count} elements")
    return Target(known[0].name, known[1], parameter, first, count)


def read_parameter(engine: Engine, target: Target) -> list[Raw]:
    """The raw values of the elements. Raises Refusal."""
    if target.parameter is None:
        keys = [(target.set_name, target.number, index) for index in target.elements]
        if not all(key in engine.memory.elements for key in keys):
            raise Refusal("unknown_address", f"nothing is known of parameter {target.number}, and nothing was written")
        return [engine.memory.elements[key] for key in keys]
    for index in target.elements:
        if not readable(target.parameter.element_access(index) or "rw"):
            raise Refusal("read_forbidden", f"{target.parameter.name} can only be written")
    return [engine.memory.elements[target.set_name, target.number, index] for index in target.elements]


def write_parameter(engine: Engine, target: Target, raws: list[Raw]) -> None:
    """Writes the elements and lets the behaviour follow. Raises Refusal, and then nothing is written."""
    parameter = target.parameter
    if len(raws) != len(target.elements):
        raise Refusal("count_invalid", f"{len(raws)} values for {len(target.elements)} elements")
    if parameter is None:
        for index, raw in zip(target.elements, raws, strict=True):
            engine.memory.elements[target.set_name, target.number, index] = raw
        return
    refuse_unwritable(target)
    for index, raw in zip(target.elements, raws, strict=True):
        objection = "" if parameter.reserved else invalid(engine, element_value(parameter, index), raw)
        if objection:
            raise Refusal("value_invalid", f"{parameter.name} cannot be {spec_text(raw)}: {objection}")
    elements = engine.memory.elements
    before = {index: elements[target.set_name, target.number, index] for index in target.elements}
    for index, raw in zip(target.elements, raws, strict=True):
        elements[target.set_name, target.number, index] = raw
    try:
        engine.follow_write([parameter.place.path, *(inner.place.path for inner in parameter.subindices)])
    except Refusal:
        for index, raw in before.items():
            elements[target.set_name, target.number, index] = raw
        raise


def refuse_unwritable(target: Target) -> None:
    """Raises Refusal for elements that can only be read."""
    parameter = target.parameter
    if parameter is not None and any(parameter.element_access(index) == "ro" for index in target.elements):
        raise Refusal("write_forbidden", f"{parameter.name} can only be read")


def all_values(engine: Engine, name: str, is_list: bool) -> list[Raw] | Raw:
    """The values of all parameters of a set or of a space, in the order of their numbers; that of a single one."""
    numbers = numbers_of(engine.layout.device.sets(name))
    values = [engine.memory.elements[set_name, number, 0] for set_name, number, _ in numbers]
    return values if is_list else values[0]


def write_all(engine: Engine, name: str, values: list[Raw] | Raw) -> None:
    """Writes all parameters of a set; `values` is one value for a set of one. Raises Refusal."""
    rows = numbers_of(engine.layout.device.sets(name))
    raws = values if isinstance(values, list) else [values]
    for (_, _, parameter), raw in zip(rows, raws, strict=True):
        objection = "" if parameter.reserved else invalid(engine, parameter.value, raw)
        if objection:
            raise Refusal("value_invalid", f"{parameter.name} cannot be {spec_text(raw)}: {objection}")
    for (set_name, number, parameter), raw in zip(rows, raws, strict=True):
        write_parameter(engine, Target(set_name, number, parameter, 0, None), [raw])
