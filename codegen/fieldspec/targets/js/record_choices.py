"""The functions of a record that has several layouts, of which the value of its selector chooses one."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import members_of, shapes_of, slot_of
from fieldspec.targets.js.number_bytes import place
from fieldspec.targets.js.record_reading import CHOOSES_NOTHING, size_check
from fieldspec.targets.js.text import function, literal, object_of
from fieldspec.targets.js.values import throw_wrong_number


def choosing_functions(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The functions that read a record, write it and count its bytes in the layout that it chooses; none for others.

    A selector that may not be sent is refused before all other fields, as in the other codecs.
    """
    selector = record.selector
    if selector is None:
        return []
    slot, rows, choices = slot_of(selector, names), [], {"__proto__": "null"}
    for index, (suffix, shape) in enumerate(shapes_of(record)):
        size = f"size{name}{suffix}" if shape.size is None else f"() => {shape.size}"
        rows.append(f"  {{ read: read{name}{suffix}, write: write{name}{suffix}, size: {size} }},")
        choices |= {str(number): str(index) for number, own in record.chosen.items() if own is shape}

    def chosen(number: str, position: str, call: str) -> list[str]:
        wrong = throw_wrong_number("unknown_value", selector.name, number, literal(CHOOSES_NOTHING), position)
        find = [f"const chosen = cases{name}[choices{name}[{number}]];", f"if (chosen === undefined) {wrong}"]
        return [*find, f"return chosen.{call};"]

    number, position = slot.number("o", selector.offset), place("o", selector.offset)
    key = next(member.key for member in members_of(record) if member.field.name == selector.name)
    is_sendable = all(any(low <= number <= high for low, high in slot.sendable) for number in record.chosen)
    refusals = [] if is_sendable else list(slot.refusals(f"value.{key}"))
    writing = {"write": "value, b, o"} | ({"size": "value"} if record.size is None else {})
    lines = [f"const cases{name} = [", *rows, "];", f"const choices{name} = {object_of(choices)};"]
    lines += function(f"read{name}", "b, o, end", [size_check(record), *chosen(number, position, "read(b, o, end)")])
    for verb, parameters in writing.items():
        body = [*refusals, *chosen(f"value.{key}", "null", f"{verb}({parameters})")]
        lines += function(f"{verb}{name}", parameters, body)
    return lines
