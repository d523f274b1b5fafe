"""Registers, arrays of them and tables of records, and the functions that make requests for them."""

from __future__ import annotations

import json
from collections.abc import Sequence

from fieldspec.codec.layout.carrying import carries_words
from fieldspec.codec.layout.device import TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.ranges import Ranges
from fieldspec.targets.fact_texts import described
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.members import members_of
from fieldspec.targets.js.text import comment, flag, literal, object_of
from fieldspec.targets.js.units import POWER_UNIT, absent_of, power_unit_of, unit_of
from fieldspec.targets.js.values import Slot, value_functions


def declare_register(layout: RegisterLayout, names: Names) -> Declaration:
    """The object of a register, or of an array of registers."""
    register, device = layout.register, names.layout.device
    name = names.registers[layout.name]
    size = layout.size if register.value.type.name == BIT else register.value.size
    request = Slot(
        layout.name, register.value, size, layout.order, register.value.write_swapped(layout.swapped), device
    )
    answer = register.answer
    read = Slot(layout.name, answer, size, layout.order, layout.swapped, device)
    properties = [
        f"{key}: true" for key, is_set in (("atomic", register.atomic), ("trigger", register.trigger)) if is_set
    ]
    properties += [f"space: {literal(device.space_name(register.space))}"] if device.several_spaces else []
    properties += ["unitSize: 1"] if register.unit_size == 1 else []
    exponent = device.register(register.value.scale_by) if register.value.scale_by else None
    if exponent is not None:
        units, unit_type = power_unit_of(register.value, exponent.value), POWER_UNIT
    else:
        units, unit_type = unit_of(register.value), "Unit"
    properties += [f"units: {units}"] if units else []
    absent = absent_of(device, answer, register.trigger)
    properties += [f"absent: {absent}"] if absent else []
    arguments = [
        literal(layout.name),
        f"0x{layout.address:04X}",
        str(layout.words),
        literal(register.access),
        *value_functions(read, request),
        *([f"{{ {', '.join(properties)} }}"] if properties else []),
    ]
    kinds = [names.type_of(answer), unit_type if units else "null"]
    kinds += [writable] if (writable := names.type_of(register.value)) != kinds[0] else []
    unit = "word" if register.unit_size > 1 else "byte"
    words = "a bit" if register.value.type.name == BIT else f"{layout.words} {unit}{'s' if layout.words > 1 else ''}"
    facts = [f"Address 0x{layout.address:04X}, {words}."]
    if register.access:
        facts.append({"ro": "Read only.", "rw": "Read and write.", "wo": "Write only."}[register.access])
    ranges = register.value.writable_ranges
    facts += [f"{ranges.text()}."] if ranges is not None else []
    facts += [f"The {register.value.write_order_text}."] if register.value.write_word_order else []
    facts += [f"In counts of {register.value.unit}."] if register.value.scale_by else []
    documentation = comment(described(Name.of(layout.name).title(), register, " ".join(facts)))
    if layout.count > 1:
        call = f"registerArray({layout.count}, {register.index_from}, {layout.stride}, {', '.join(arguments)})"
        type_ = f"RegisterArray<{', '.join(kinds)}>"
    else:
        call, type_ = f"register({', '.join(arguments)})", f"Register<{', '.join(kinds)}>"
    return Declaration(
        [f"export const {name} = /* @__PURE__ */ {call};"],
        [*documentation, f"export declare const {name}: {type_};", ""],
    )


def declare_table(layout: TableLayout, names: Names) -> Declaration:
    """The object of a table of records."""
    table, device = layout.table, names.layout.device
    name = names.scope.take(Name.of(layout.name).upper())
    record = names.records[table.record]
    options = f", {{ space: {literal(device.space_name(table.space))} }}" if device.several_spaces else ""
    count = names.registers[table.count_by] if table.count_by else "null"
    base = names.registers[table.base_by] if table.base_by else ""
    options = f"{options or ', {}'}, {count}{f', {base}' if base else ''}" if table.count_by or base else options
    access = table.access if layout.writable else "ro"
    call = (
        f"table({table.count}, {table.index_from}, {table.stride}, {literal(layout.name)}, 0x{table.base:04X},"
        f" {literal(access)}, {record}{options})"
    )
    count_text = (
        f"Up to {table.count}, as {names.registers[table.count_by]} says," if table.count_by else str(table.count)
    )
    place = f"where {base} says, usually at 0x{table.base:04X}" if base else f"at 0x{table.base:04X}"
    facts = f"{count_text} records of {layout.words} words, {table.stride} words apart, the first {place}."
    return Declaration(
        [f"export const {name} = /* @__PURE__ */ {call};"],
        [
            *comment(described(table.title or Name.of(table.name).title(), table, facts)),
            f"export declare const {name}: RecordTable<{record}>;",
            "",
        ],
    )


@dataclass(frozen=True, slots=True)
class Access:
    """A message that reads or writes up to `most` words of a space; `single` where it is always one word.

    `bit` is empty in a space of words. Else it says how bits are carried: the numbers of a bit that is 0 and of one
    that is 1, or none where they are packed into bytes. `links` are those that carry it; empty where links do not
    differ.
    """

    message: MessageLayout
    space: str
    operation: str
    start: str
    count: str
    values: str
    most: int
    single: bool
    bit: str
    links: tuple[str, ...] = ()


def accesses(names: Names) -> list[Access]:
    """The messages that read and write registers, the first one of each kind for each space; of each link where links
    have different ones. The link of the factory settings comes first.
    """
    device, candidates = names.layout.device, []
    links = sorted(names.layout.links.values(), key=lambda link: link.name != device.default_link)
    for message in names.layout.messages.values():
        access = device.register_access(message.message) or device.bit_access(message.message)
        if access is None or not any(carries_words(link, message) for link in links):
            continue
        keys = {member.field.name: member for member in members_of(message.request)}
        holder = message.response if access.operation == "read" else message.request
        values = next((member for member in members_of(holder) if member.field.name == access.values), None)
        settable = {member.field.name for member in keys.values() if member.key} <= {
            access.start,
            access.count,
            access.values,
        }
        if access.start not in keys or not keys[access.start].key or values is None or not settable:
            continue
        count = keys[access.count].key if access.count in keys else ""
        bits = device.bit_access(message.message) is not None
        repeat = values.field.field.repeat
        if bits and repeat is not None:
            repeat = Ranges(tuple((8 * low, 8 * high) for low, high in repeat.intervals))
        limit = _greatest_count(message.request, access.count, repeat) if values.field.is_list else 1
        numbers = [] if access.set is None else [access.clear, access.set]
        candidates.append(
            Access(
                message,
                device.space_name(access.space) if device.several_spaces else "",
                access.operation,
                keys[access.start].key,
                count,
                values.key,
                limit,
                not values.field.is_list,
                json.dumps(numbers) if bits else "",
            )
        )
    shared = _by_space(candidates)
    by_link = {link.name: _by_space([row for row in candidates if carries_words(link, row.message)]) for link in links}
    if all(shared[key] == rows for own in by_link.values() for key, rows in own.items()):
        return [row for row in candidates if shared[row.space, row.operation].get(row.single) is row]
    different: dict[int, list[str]] = {}
    for name, own in by_link.items():
        for row in (row for rows in own.values() for row in rows.values()):
            different.setdefault(candidates.index(row), []).append(name)
    return [replace(candidates[number], links=tuple(names)) for number, names in different.items()]


def _by_space(candidates: Sequence[Access]) -> dict[tuple[str, str], dict[bool, Access]]:
    """The first message for one word and for several, by space and operation."""
    kinds: dict[tuple[str, str], dict[bool, Access]] = {}
    for row in candidates:
        kinds.setdefault((row.space, row.operation), {}).setdefault(row.single, row)
    return kinds


def _greatest_count(request: RecordLayout, count: str, repeat: Ranges | None) -> int:
    bounds = [repeat.high] if repeat is not None else []
    field = request.named(count)
    if field is not None and field.value is not None and field.value.ranges is not None:
        bounds.append(field.value.ranges.high)
    return min(bounds, default=1)


_READ_TYPES = """\
/** The requests that read a register, several where one cannot read all words. Throws CodecError. */
export declare function readRequests(entry: Register<unknown, unknown, never>): (REQUESTS)[];
/** The value of a register from the data of the responses, in order. Throws CodecError. */
export declare function readValue<T>(
  entry: Register<T, unknown, never>,
  ...responses: readonly object[]
): T;
"""
_WRITE_TYPES = """\
/** The requests that write a register. Throws CodecError for a value that is out of range. */
export declare function writeRequests<T>(
  entry: Register<unknown, unknown, T>,
  value: NoInfer<T>,
): (REQUESTS)[];
"""
_LINK_DOC = (
    "The functions for registers with the messages of a link; those without it have the messages of LINK. "
    "Throws RangeError for a link that no message of registers has."
)


def declare_accesses(names: Names) -> Declaration:
    """The functions that make the requests for a register, and read its value from the responses."""
    rows = accesses(names)
    links = list(dict.fromkeys(literal(name) for row in rows for name in row.links))
    functions: dict[str, str] = {}
    types: list[str] = []
    if reads := _union(names, rows, "read"):
        functions |= {"readRequests": "entry", "readValue": "entry, ...responses"}
        types += _READ_TYPES.replace("REQUESTS", reads).split("\n")
    if writes := _union(names, rows, "write"):
        functions["writeRequests"] = "entry, value"
        types += _WRITE_TYPES.replace("REQUESTS", writes).split("\n")
    if not functions:
        return Declaration([], [])
    order = literal(names.layout.device.byte_order or "big")
    head, link = ("export const", f"link = {links[0]}") if links else ("const", "")
    code = [
        f"{head} registersOn = ({link}) => registerFunctions([",
        *(_access_row(row, names) for row in rows),
        f"], {order}{', link' if links else ''});",
        *(f"export const {name} = ({own}) => registersOn().{name}({own});" for name, own in functions.items()),
        "",
    ]
    if links:
        types += comment([_LINK_DOC.replace("LINK", links[0])])
        types.append(f"export declare function registersOn(link: {' | '.join(links)}): {{")
        types += [*(f"  {name}: typeof {name};" for name in functions), "};", ""]
    return Declaration(code, types)


def _access_row(row: Access, names: Names) -> str:
    """The row of a message in the table by which requests for registers are made."""
    properties = {
        "message": names.messages[row.message.name],
        "space": literal(row.space),
        "operation": literal(row.operation),
        "start": literal(row.start),
        "count": literal(row.count),
        "values": literal(row.values),
        "most": str(row.most),
        "single": flag(row.single),
        **({"bit": row.bit} if row.bit else {}),
        **({"links": f"[{', '.join(map(literal, row.links))}]"} if row.links else {}),
    }
    return f"  {object_of(properties)},"


def _union(names: Names, rows: Sequence[Access], operation: str) -> str:
    kinds = [f"RequestOf<typeof {names.messages[row.message.name]}>" for row in rows if row.operation == operation]
    return " | ".join(dict.fromkeys(kinds))
