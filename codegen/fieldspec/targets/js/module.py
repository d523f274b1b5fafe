"""The module of a version: its declarations in order, and the helpers that they import."""

from __future__ import annotations

import re
from collections.abc import Sequence

from fieldspec.codec.layout.carrying import carries
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.omissions import Expressed, Omission, expressed, listing
from fieldspec.codec.layout.package_codecs import codec_refusals
from fieldspec.foundation.names import Name
from fieldspec.targets.explainer.codecs import codec_constants, javascript
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.enums import declare_enum, declare_flags
from fieldspec.targets.js.links import declare_link, declare_message
from fieldspec.targets.js.naming import IMPORTS
from fieldspec.targets.js.parameters import declare_parameters
from fieldspec.targets.js.records import declare_record
from fieldspec.targets.js.registers import declare_accesses, declare_register, declare_table
from fieldspec.targets.js.text import comment, literal
from fieldspec.targets.js.units import declare_conversion

_WORDS = re.compile(r'"(?:[^"\\]|\\.)*"|[A-Za-z_$][\w$]*')


def remaining(layout: DeviceLayout) -> Expressed:
    """A device without what needs a codec that has no JavaScript."""
    return expressed(layout, codec_refusals(layout, "JavaScript", javascript))


def declarations(names: Names, is_for_names: bool = False) -> list[Declaration]:
    """Everything that the module of a version declares, in an order in which nothing is used before it.

    Enums, words of flags, records, messages and registers are added to the names. If it `is_for_names`, the
    declarations of enums, words of flags and registers are left out: usages need only their names.
    """
    layout, scope = names.layout, names.scope
    device = layout.device
    for enum in device.enums.values():
        names.enums[enum.name] = scope.take(Name.of(enum.name).pascal(), f"{Name.of(enum.name).pascal()}Code")
    for flags in device.flags.values():
        names.flags[flags.name] = scope.take(Name.of(flags.name).pascal(), f"{Name.of(flags.name).pascal()}Flags")
    for name in layout.records:
        names.records[name] = scope.take(Name.of(name).pascal(), f"{Name.of(name).pascal()}Record")
    for message in layout.messages.values():
        for body in message.bodies:
            names.records[body.name] = scope.take(Name.of(body.name).pascal(), f"{Name.of(body.name).pascal()}Data")
        names.messages[message.name] = scope.take(
            Name.of(message.name).pascal(), f"{Name.of(message.name).pascal()}Message"
        )
    rows = [Declaration(codec_constants(layout), [])]
    if not is_for_names:
        rows += [declare_enum(enum, names.enums[enum.name]) for enum in device.enums.values()]
        rows += [declare_flags(flags, names.flags[flags.name], device.enums) for flags in device.flags.values()]
    rows += [
        declare_record(record, names.records[name], names, sentence(Name.of(name).title()))
        for name, record in layout.records.items()
    ]
    for message in layout.messages.values():
        rows += _bodies(message, names)
        rows.append(declare_message(message, names))
    rows += [
        declare_link(link, names)
        for link in layout.links.values()
        if any(carries(link, message) for message in layout.messages.values())
    ]
    rows += [declare_conversion(conversion, names) for conversion in device.conversions.values()]
    for register in layout.registers:
        names.registers[register.name] = scope.take(Name.of(register.name).upper())
    rows += [] if is_for_names else [declare_register(register, names) for register in layout.registers]
    rows += [declare_table(table, names) for table in layout.tables.values()]
    if layout.registers or layout.tables:
        rows.append(declare_accesses(names))
    rows += [declare_parameters(parameter_set, names) for parameter_set in device.parameters.values()]
    return rows


def _bodies(message: MessageLayout, names: Names) -> list[Declaration]:
    title = message.message.title or Name.of(message.name).title()
    return [
        declare_record(body, names.records[body.name], names, sentence(f"{title}: the {direction}"))
        for direction, body in zip(message.message.directions, message.bodies, strict=True)
    ]


def module_texts(
    layout: DeviceLayout, rows: Sequence[Declaration], omissions: Sequence[Omission] = ()
) -> tuple[str, str]:
    """The module of a version that declares these `rows`, and its types."""
    head = comment([*about(layout), *listing(omissions, str)])
    device = layout.device
    constants = [("DEVICE", device.id), ("VERSION", device.version), ("IDENTITY", layout.identity)]
    code = [line for row in rows for line in row.code]
    used = {word for line in code for word in _WORDS.findall(line) if not word.startswith('"')}
    imports = [
        f'import {{ {", ".join(names)} }} from "../runtime/{module}.js";'
        for module, known in IMPORTS.items()
        if (names := [name for name in known.split() if name in used])
    ]
    lines = [*head, *imports, "", *(f"export const {name} = {literal(value)};" for name, value in constants), "", *code]
    types = [
        *head,
        *TYPES,
        "",
        *(f"export declare const {name}: {literal(value)};" for name, value in constants),
        "",
        *(line for row in rows for line in row.types),
    ]
    return "\n".join(lines).rstrip("\n") + "\n", "\n".join(types).rstrip("\n") + "\n"


TYPES = (
    "import type {",
    "  Conversion, ExceptionFrame, Flags, Framer, Link, Message, Parameter, ParameterSet, RecordCodec, RecordTable,",
    "  Register, RegisterArray, RequestOf, Unit,",
    '} from "../runtime/index.js";',
)
"""The import of the types of the runtime. Only types are imported, so unused ones cost nothing."""


def about(layout: DeviceLayout) -> Sequence[str]:
    """The paragraphs about a version."""
    device = layout.device
    manual = f"Manual: {device.manual.title}" + (f", {device.manual.edition}" if device.manual.edition else "")
    return [
        sentence(f"{device.vendor} {device.name}, version {device.version}"),
        sentence(device.title),
        sentence(manual),
        f"Generated by fieldspec from the spec of {device.id}; do not edit. Identity {layout.identity}.",
    ]
