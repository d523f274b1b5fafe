"""Records and the data of messages: structs, and what they are to hold."""

from __future__ import annotations

from fieldspec.backends.c.choices import union_lines
from fieldspec.backends.c.coding import decode_function, encode_function
from fieldspec.backends.c.comments import of_value, told
from fieldspec.backends.c.fields import count_member, members, most, wire
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.packing import pack_functions, packed
from fieldspec.backends.c.text import comment, indented
from fieldspec.backends.c.values import declaration
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device


def record_lines(naming: Naming, device: Device, record: RecordLayout, doc: list[str]) -> list[str]:
    """The struct of a record, if it has members, and its functions."""
    name = naming.type("record", record.name)
    held = members(record)
    size = f"{record.size} bytes" if record.size is not None else f"{record.least} to {record.most} bytes"
    lines = [f"#define {naming.macro('record', record.name, 'size')} {record.most}u"]
    if held:
        lines += [*doc, f"typedef struct {name} {{"]
        for field in held:
            told_of = told(field.field, of_value(field.value))
            lines += indented([*told_of, *_declared(naming, record, field)])
        lines += [f"}} {name};"]
    else:
        lines += comment("There is nothing to give: no struct is needed.")
    if packed(record):
        lines += ["", *pack_functions(naming, device, record)]
    lines += ["", *comment(f"Writes {name}: {size}.", "Length receives how many bytes were written.")]
    lines += encode_function(naming, device, record)
    lines += ["", *comment(f"Reads {name} from exactly {size}.")]
    return [*lines, *decode_function(naming, device, record)]


def _declared(naming: Naming, record: RecordLayout, field: FieldLayout) -> list[str]:
    count = most(field) if field.is_list else None
    if field.cases:
        lines = union_lines(field, count)
    elif field.record is not None:
        times = f"[{count}]" if count is not None else ""
        lines = [f"{naming.type('record', field.record.name)} {member(field.name)}{times};"]
    else:
        lines = [declaration(wire(field), member(field.name), count) + ";"]
    if field.field.repeat is not None:
        lines.append(f"size_t {count_member(record, field)};")
    return lines
