"""Every name that a fact refers to exists: enums, bit fields, bits, records, fields, signals, parameters,
links, messages, examples, and facts named by a path.

Why: without the referenced fact, a value has no meaning and no layout.

Example: `enum: homing_mod` where the enum has the name homing_mode.

Fix: Correct the name, or define the missing fact.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from fieldspec.language.checks.facts import cases, facts, layers, values
from fieldspec.language.checks.finding import Findings, finding, is_imported, near
from fieldspec.language.checks.numbers import body
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Place
from fieldspec.language.model.record import Field, Message, Record, RegisterAccess
from fieldspec.language.model.sizes import sent_on
from fieldspec.language.model.texts import Example, Lookup
from fieldspec.language.model.value import UNSPECIFIED, ParameterPart, Value

_PARTS = frozenset(
    (
        "causes",
        "elements",
        "exception_response",
        "frame_length",
        "data_words",
        "restated",
        "rows",
        "network",
        "serial",
        "unit_addresses",
    )
)
"""The names below a fact that a path may end in, although they are not facts."""

_SAVING = frozenset(("registers", "parameters", "messages", "records", "tables", "signals"))
"""The sections of what is written to a device or sent to it."""


def references_resolve(device: Device) -> Findings:
    for fact, value in values(device):
        if value.enum:
            yield from _named(fact.place, "enum", "enum", value.enum, device.enums)
        if value.flags:
            yield from _named(fact.place, "flags", "bit field", value.flags, device.flags)
        if value.parameter is not None:
            yield from _of_part(device, fact.place, value.parameter)
    for record in device.records.values():
        yield from _named(record.place, "same_as", "record", record.same_as, device.records)
        yield from _within(device, record, None, _codes(device, record))
    for message in device.messages.values():
        yield from _of_message(device, message)
    for group in device.groups:
        yield from _named(group.place, "space", "address space", group.space, device.spaces)
    for table in device.tables.values():
        yield from _named(table.place, "space", "address space", table.space, device.spaces)
        yield from _named(table.place, "record", "record", table.record, device.records)
    for link in device.links.values():
        request_parts = {part.name for part in link.request if part.role == "plain" and not part.reserved}
        for part in link.response:
            yield from _named(part.place, "same_as", "part of the request", part.same_as, request_parts)
        for part in link.request:
            if part.same_as:
                text = f"the part {part.name} of a request repeats nothing"
                yield finding(part.place, "same_as", text, "move `same_as` to the response")
        if link.exception_response is not None:
            yield from _named(
                link.place, "exception_response", "record", link.exception_response.record, device.records
            )
    for flags in device.flags.values():
        yield from _of_flags(device, flags)
    registers = {register.name for register in device.registers()}
    for register in device.registers():
        if register.same_as or register.copy_of:
            yield from _named(register.place, "same_as", "register", register.same_as, registers)
            yield from _named(register.place, "copy_of", "register", register.copy_of, registers)
        yield from _named(register.place, "scale_by", "register", register.value.scale_by, registers)
    for table in device.tables.values():
        yield from _named(table.place, "count_by", "register", table.count_by, registers)
        yield from _named(table.place, "base_by", "register", table.base_by, registers)
    for layer in layers(device):
        yield from _of_exponents(layer, registers)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            yield from _check_names(parameter.place, "messages", "message", parameter.messages, device.messages)
    paths = {fact.place.path for fact in facts(device)}
    for conversion in device.conversions.values():
        yield from _check_names(conversion.place, "signals", "signal", conversion.signals, device.signals)
        yield from _check_names(conversion.place, "references", "fact", conversion.references, paths)
    for fact in facts(device):
        handling = getattr(fact, "handling", UNSPECIFIED)
        if handling is not UNSPECIFIED:
            yield from _named(fact.place, "saved_by", "fact", handling.saved_by, paths)
            if handling.saved_by in paths and handling.saved_by.partition("/")[0] not in _SAVING:
                text = f"{handling.saved_by} saves nothing: it is neither written nor sent"
                help = "name a register, a parameter, a field of one, or a message"
                yield finding(fact.place, "saved_by", text, help)
            yield from _named(fact.place, "opposite_of", "fact", handling.opposite_of, paths)
    paths.update(f"examples/{example}" for example in device.examples)
    for note in device.notes:
        yield from _check_names(note.place, "about", "fact", map(_holder, note.about), paths)
    limits = {limit.place.path for limit in device.limits}
    for limit in device.limits:
        yield from _check_names(limit.place, "sum_of", "limit", limit.sum_of, limits)
        yield from _named(limit.place, "within", "limit", limit.within, limits)
    for line in device.lines:
        if line.detected_by is not None:
            yield from _named(line.detected_by.place, "fact", "fact", line.detected_by.fact, paths)
    for lookup in device.lookups:
        yield from _of_lookup(device, lookup)
    for example in device.examples.values():
        yield from _of_example(device, example)


def _named(place: Place, key: str, kind: str, name: str, known: Collection[str]) -> Findings:
    if name and name not in known:
        text = f"there is no {kind} `{name}`"
        yield finding(place, key, text, near(name, known))


def _of_exponents(layer: Record, registers: Collection[str]) -> Findings:
    """The exponents of the scales of fields, each of which is a field beside them or a register."""
    for field in layer.fields:
        if field.value is not None and field.value.scale_by:
            known = [*(other.name for other in layer.fields), *registers]
            yield from _named(field.place, "scale_by", "field or register", field.value.scale_by, known)


def _holder(path: str) -> str:
    """The path of the fact that holds what a path names; most paths name facts themselves."""
    steps = path.split("/")
    end = next((index for index in range(2, len(steps)) if steps[index] in _PARTS), len(steps))
    return "/".join(steps[:end])


def _check_names(place: Place, key: str, kind: str, names: Iterable[str], known: Collection[str]) -> Findings:
    for name in names:
        yield from _named(place, key, kind, name, known)


def _of_part(device: Device, place: Place, part: ParameterPart) -> Findings:
    sets = {*device.parameters, *(parameter_set.space for parameter_set in device.parameters.values())}
    yield from _named(place, "parameter", "parameter set", part.set, sets)
    if part.part == "values" and len(device.sets(part.set)) > 1:
        text = f"the values of {part.set} are in several sets without an order"
        yield finding(place, "parameter", text, "name one of the sets")


def _of_flags(device: Device, flags: Flags) -> Findings:
    for bit in flags.bits:
        if bit.enum:
            yield from _named(bit.place, "enum", "enum", bit.enum, device.enums)
    bits = {bit.name for bit in flags.bits}
    for state in flags.states:
        for key, names in (("set", state.set), ("clear", state.clear)):
            yield from _check_names(state.place, key, f"bit of {flags.name}", names, bits)


def _of_message(device: Device, message: Message) -> Findings:
    yield from _check_names(message.place, "links", "link", message.links, device.links)
    yield from _check_names(message.place, "answered_on", "link", message.answered_on or (), device.links)
    yield from _check_names(message.place, "supplements", "message", message.supplements, device.messages)
    yield from _within(device, message.request, None)
    yield from _within(device, message.response, message.request)
    for access in message.accesses:
        yield from _of_access(device, message, "accesses", access)


def _of_access(device: Device, message: Message, key: str, access: RegisterAccess) -> Findings:
    request_names = {field.name for field in message.request.fields}
    response_names = {field.name for field in message.response.fields}
    holder = response_names if access.operation == "read" else request_names
    place = message.place
    space = access.space
    if space and space not in device.spaces and is_imported(place, device):
        text = f"there is no address space `{space}`, which messages that {device.id} takes from protocols access"
        help = "add the space to `spaces`, or state under `uses` which messages the device has"
        yield finding(device.place, "id", text, help)
    else:
        yield from _named(place, key, "address space", space, device.spaces)
    for name in (access.start, access.count, access.and_mask, access.or_mask):
        yield from _named(place, key, "field of the request", name, request_names)
    yield from _named(place, key, "field", access.values, holder)


def _codes(device: Device, record: Record) -> frozenset[str]:
    """The parts with the code in the requests of each link whose exception responses have a record."""
    parts = [
        {part.name for part in link.request if part.role == "code"}
        for link in device.links.values()
        if link.exception_response is not None and link.exception_response.record == record.name
    ]
    return frozenset(set.intersection(*parts)) if parts else frozenset()


def _within(device: Device, layer: Record, request: Record | None, codes: frozenset[str] = frozenset()) -> Findings:
    """References of a layer's fields: to the layer itself, and to what was asked.

    `codes` are the parts of a request with its code, which exception responses may repeat.
    """
    own = {field.name for field in layer.fields}
    origin = {field.name for field in request.fields} if request is not None else codes
    numbers = own | {field.name for field in request.fields} if request is not None else own
    for field in layer.fields:
        yield from _named(field.place, "record", "record", field.record, device.records)
        if field.same_as and request is None and not codes:
            text = f"{field.name} is in no response, and only responses repeat what was asked"
            yield finding(field.place, "same_as", text, "remove `same_as`")
        else:
            yield from _named(field.place, "same_as", "field", field.same_as, origin)
        yield from _named(field.place, "signal", "signal", field.signal, device.signals)
        if (measure := field.stated_measure) is not None:
            yield from _named(field.place, "measures", "field here", measure.field, own)
        if (presence := field.presence) is not None:
            yield from _named(field.place, "present_if", "field here", presence.by, own)
            yield from _of_members(device, _enum_of(layer.named(presence.by)), field.place, "present_if", presence.when)
        if (continuation := field.continuation) is not None:
            element = device.records.get(field.record)
            if element is not None:
                names = [other.name for other in element.fields]
                yield from _named(field.place, "more_if", f"field of {element.name}", continuation.by, names)
            decider = element.named(continuation.by) if element is not None else field
            yield from _of_members(device, _enum_of(decider), field.place, "more_if", continuation.when)
        for value in [field.value, *(case.value for case in cases(field))]:
            yield from _parameter_references(field, value, numbers)
        if field.choice is not None:
            yield from _named(field.place, "choice", "field here", field.choice.by, own)
            for case in cases(field):
                enum = field.choice.enum_of(layer.named(field.choice.by), device.flags)
                yield from _of_members(device, enum, case.place, "when", case.when)


def _enum_of(decider: Field | None) -> str:
    return decider.value.enum if decider is not None and decider.value is not None else ""


def _of_members(device: Device, name: str, place: Place, key: str, names: tuple[str, ...]) -> Findings:
    """References to members of the enum of a field, or of some bits of it, that decides on another one."""
    enum = device.enums.get(name)
    if enum is not None:
        members = {member.name for member in enum.members}
        yield from _check_names(place, key, f"member of {enum.name}", names, members)


def _parameter_references(field: Field, value: Value | None, numbers: Collection[str]) -> Findings:
    part = value.parameter if value is not None else None
    if part is None or part.part not in ("value", "subindex"):
        return
    if not part.number:
        text = f"there is no parameter number for {field.name}"
        help = "name the field that contains it under `number`"
        yield finding(field.place, "parameter", text, help)
    yield from _named(field.place, "parameter", "field", part.number, numbers)


def _of_lookup(device: Device, lookup: Lookup) -> Findings:
    for index, column in enumerate(lookup.columns):
        if column.enum not in device.enums:
            yield from _named(lookup.place, "columns", "enum", column.enum, device.enums)
            continue
        enum = device.enums[column.enum]
        names = {member.name for member in enum.members}
        numbers = {member.value for member in enum.members}
        for row in lookup.rows:
            cell = row.cells[index] if index < len(row.cells) else None
            if cell is not None and cell not in names and cell not in numbers:
                text = f"{enum.name} has no member `{cell}`"
                yield finding(row.place, "cells", text, near(str(cell), names))


def _of_example(device: Device, example: Example) -> Findings:
    place = example.place
    yield from _named(place, "link", "link", example.link, device.links)
    yield from _named(place, "message", "message", example.message, device.messages)
    yield from _named(place, "reply_to", "example", example.reply_to, device.examples)
    if not example.message and not example.refused and not example.exception_response:
        text = f"{example.id} names no message"
        yield finding(place, "message", text, "name the message, or state why it is `refused`")
    link, message = device.links.get(example.link), device.messages.get(example.message)
    if link is not None and message is not None and not sent_on(link, message):
        text = f"{message.name} is not sent on the link {link.name}"
        yield finding(place, "link", text, "name the link, or the message, of the frame")
    if example.exception_response and link is not None and link.exception_response is None:
        text = f"the link {link.name} has no `exception_response`, so no response can be an exception response"
        yield finding(place, "exception_response", text, "add `exception_response` to the link")
    if link is not None and example.elided:
        names = [part.name for part in link.parts(example.direction)] + [field.name for field in body(device, example)]
        yield from _check_names(place, "elided", "part or field", [n.partition(".")[0] for n in example.elided], names)
    request = device.examples.get(example.reply_to)
    if request is not None and (request.direction, example.direction) != ("request", "response"):
        text = f"{example.id} cannot reply to {request.id}: only a response can reply, and only to a request"
        yield finding(place, "reply_to", text, "name the example with the request")
