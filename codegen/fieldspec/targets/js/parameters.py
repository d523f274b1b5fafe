"""Sets of numbered parameters."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import described
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.members import members_of
from fieldspec.targets.js.naming import property_scope
from fieldspec.targets.js.text import PURE, comment, literal, object_of
from fieldspec.targets.js.units import absent_of, unit_of
from fieldspec.targets.js.values import Slot, sign_literal, value_functions
from fieldspec.targets.runtime_values import kind_of

_ACCESS = {"ro": "read only", "rw": "read and write", "wo": "write only"}


_VALUE_IN = [
    "  /** The value of a parameter, or of one element, in the response to its request. Throws CodecError. */",
    "  valueIn<T>(response: object, parameter: Parameter<T>, subindex?: number): T;",
]


def declare_parameters(parameter_set: ParameterSet, names: Names) -> Declaration:
    """A set of parameters: an object with each by name, and by its number on the wire in `byNumber`."""
    name = names.scope.take(Name.of(parameter_set.name).pascal(), f"{Name.of(parameter_set.name).pascal()}Parameters")
    scope = property_scope()
    rows = [(scope.take(Name.of(row.name).camel()), row) for row in parameter_set.parameters]
    code = [f"export const {name} = /* @__PURE__ */ parameterSet({literal(parameter_set.name)}, {{"]
    carrier = _carrier(parameter_set, names.layout)
    code += [f"  {key}: {_parameter(row, parameter_set, names, carrier)}," for key, row in rows]
    carried = _carried_bytes(parameter_set, names.layout)
    code += [f"}}, {carried});" if carried else "});", ""]
    types = comment(described(parameter_set.title or Name.of(parameter_set.name).title(), parameter_set))
    types.append(f"export declare const {name}: ParameterSet<{{")
    for key, row in rows:
        types += comment(described(Name.of(row.name).title(), row, _facts(row, parameter_set)), 2)
        kind = f"Parameter<{_type(row, names)}, {'Unit' if unit_of(row.value) else 'null'}>"
        types.append(f"  readonly {key}: {kind if row.count == 1 else f'readonly {kind}[]'};")
    types += [*(["}> & {", *_VALUE_IN, "};"] if carried else ["}>;"]), ""]
    return Declaration(code, types)


def _carried_bytes(parameter_set: ParameterSet, layout: DeviceLayout) -> str:
    """The properties of responses with the bytes of a value, and how many count; empty where no response has them."""
    for message in layout.messages.values():
        keys = {member.field.name: member.key for member in members_of(message.response)}
        for field in message.response.fields:
            part = field.value.parameter if field.value is not None else None
            if part is None or not field.carries_bytes or part.set not in (parameter_set.name, parameter_set.space):
                continue
            properties = {"bytes": literal(keys[field.name])}
            if part.sizes is not None:
                sizes = ", ".join(f"{number}: {size}" for number, size in field.sizes.items())
                properties |= {"by": literal(keys[part.sizes.by]), "sizes": f"{{ __proto__: null, {sizes} }}"}
            return object_of(properties)
    return ""


def _carrier(parameter_set: ParameterSet, layout: DeviceLayout) -> FieldLayout | None:
    """The field of a message that carries the values of a set as numbers of one type."""
    fields = (field for message in layout.messages.values() for body in message.bodies for field in body.fields)
    for field in fields:
        part = field.value.parameter if field.value is not None else None
        if part is None or part.set not in (parameter_set.name, parameter_set.space):
            continue
        if part.part in ("value", "values"):
            return field if field.value is not None and is_count(field.value.encoding) else None
    return None


def _carried_signed(row: Parameter, carrier: FieldLayout | None) -> str:
    """The sign of the number in a message, if the value has the same size but a different sign."""
    if carrier is None or carrier.value is None or row.subindices or carrier.size != row.value.size:
        return ""
    sign = sign_literal(carrier.value)
    return sign if is_count(row.value.encoding) and sign != sign_literal(row.value) else ""


def _parameter(row: Parameter, parameter_set: ParameterSet, names: Names, carrier: FieldLayout | None) -> str:
    read, write = _functions(row.name, row.value, row.trigger, names)
    default = row.value.default
    properties = {
        "type": literal(row.value.type.name),
        "kind": _kind(row.value),
        "size": str(row.value.size),
        "signed": sign_literal(row.value),
        "carriedSigned": _carried_signed(row, carrier),
        "places": _places(row.value, names),
        "default": "" if default is None else literal(default) if isinstance(default, str) else str(default),
        "elements": "" if row.elements is None else str(row.elements),
        "units": unit_of(row.value),
        "absent": absent_of(names.layout.device, row.value.as_answer(row.trigger), row.trigger),
        "subindices": ", ".join(_subindex(row, subindex, names) for subindex in row.subindices),
        "printedName": literal(row.printed_name or parameter_set.number_text(row.number)) if row.count == 1 else "",
    }
    if properties["subindices"]:
        properties["subindices"] = f"[{properties['subindices']}]"
    facts = object_of({key: expression for key, expression in properties.items() if expression})
    identity = [literal(row.name), str(row.number), str(parameter_set.base), literal(row.access)]
    call = ", ".join([*identity, read, write, facts])
    return f"{PURE} parameter({call})" if row.count == 1 else f"{PURE} parameters({row.count}, {call})"


def _subindex(row: Parameter, subindex: Subindex, names: Names) -> str:
    """The object of an element, or of a run of them, with a meaning of its own."""
    read, write = _functions(f"{row.name}.{subindex.name}", subindex.value, row.trigger, names)
    absent = absent_of(names.layout.device, subindex.value.as_answer(row.trigger), row.trigger)
    return object_of(
        {
            "name": literal(subindex.name),
            "indices": f"[{', '.join(f'[{low}, {high}]' for low, high in subindex.indices.intervals)}]",
            "size": str(subindex.value.size),
            "signed": sign_literal(subindex.value),
            "places": _places(subindex.value, names),
            "kind": _kind(subindex.value),
            **({"access": literal(subindex.access)} if subindex.access else {}),
            **({"absent": absent} if absent else {}),
            "read": read,
            "write": write,
        }
    )


def _functions(name: str, value: Value, trigger: bool, names: Names) -> tuple[str, str]:
    """The functions that read and write a value in its own bytes."""
    return value_functions(_slot(name, value.as_answer(trigger), names), _slot(name, value, names))


def _slot(name: str, value: Value, names: Names) -> Slot:
    device = names.layout.device
    return Slot(name, value, value.size, *Orders(device.byte_order, device.word_order).of(value), device)


def _places(value: Value, names: Names) -> str:
    """The places of the bytes of a value, the most significant one first."""
    return str(list(_slot("", value, names).places))


def _kind(value: Value) -> str:
    return literal(kind_of(value.encoding))


def _type(row: Parameter, names: Names) -> str:
    kinds = [names.type_of(row.value.as_answer(row.trigger))]
    kinds += [names.type_of(subindex.value.as_answer(row.trigger)) for subindex in row.subindices]
    return " | ".join(dict.fromkeys(kinds))


def _facts(row: Parameter, parameter_set: ParameterSet) -> str:
    facts = [f"Number {row.printed_name or parameter_set.number_text(row.number)}", row.value.type.name]
    facts += [f"{row.elements} elements"] if row.elements is not None else []
    ranges = row.value.writable_ranges
    facts += [ranges.text()] if ranges is not None else []
    facts += [_ACCESS[row.access]] if row.access else []
    subindex_texts = [f"{inner.name} {_ACCESS[inner.access]}" for inner in row.subindices if inner.access]
    return f"{', '.join([*facts, *subindex_texts])}."
