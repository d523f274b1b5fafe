"""The files of the C output."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.c.frames import link_lines
from fieldspec.backends.c.naming import Naming, stem
from fieldspec.backends.c.records import record_lines
from fieldspec.backends.c.registers import parameter_lines, register_lines, table_lines
from fieldspec.backends.c.selftest import program
from fieldspec.backends.c.support import check_lines, number_lines, status_lines
from fieldspec.backends.c.text import plain, string
from fieldspec.backends.c.words import enum_lines, flags_lines, text_lines, told
from fieldspec.backends.templates import fill
from fieldspec.layout.device import DeviceLayout

_PLAIN_KINDS = ("enum", "function", "type")


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """A header and a self-test for each version of a device."""
    texts = {}
    for layout in versions:
        name = stem(layout.device.id, layout.device.version)
        texts[f"{name}.h"] = _header(layout)
        texts[f"{name}_selftest.c"] = program(layout, Naming(layout.device.id), f"{name}.h")
    return texts


def shared() -> dict[str, str]:
    """Nothing belongs to no device."""
    return {}


def _header(layout: DeviceLayout) -> str:
    device = layout.device
    naming = Naming(device.id)
    algorithms = {
        part.algorithm
        for link in layout.links.values()
        for frame in (link.request, link.response)
        for part in frame.tail
        if part.algorithm
    }
    sections = [
        ("What functions return", [status_lines(naming)]),
        ("Numbers and characters, independent of the machine", number_lines(naming, layout)),
        ("Checks", check_lines(naming, algorithms)),
        ("Enums and codes", [enum_lines(naming, enum) for enum in device.enums.values()]),
        ("Words of flags", [flags_lines(naming, word) for word in device.flags.values()]),
        ("Records", [record_lines(naming, device, record, told(record.record)) for record in layout.records.values()]),
        ("Data of requests and responses", _messages(naming, layout)),
        ("Registers", [register_lines(naming, device, register) for register in layout.registers]),
        ("Tables of records", [table_lines(naming, table) for table in layout.tables.values()]),
        ("Parameters", [b for held in device.parameters.values() for b in parameter_lines(naming, layout, held)]),
        ("Frames", [link_lines(naming, layout, link) for link in layout.links.values()]),
    ]
    coded = [enum for enum in device.enums.values() if enum.kind not in _PLAIN_KINDS]
    return fill(
        "c/header.h.j2",
        title=plain(f"{device.name} ({device.vendor}), version {device.version}"),
        manual=plain(f"{device.manual.title} {device.manual.edition}".strip()),
        identity=layout.identity,
        guard=naming.macro("included"),
        version_guard=naming.macro("version", "is", device.version),
        version_macro=naming.macro("version"),
        version=string(device.version),
        identity_macro=naming.macro("identity"),
        identity_text=string(layout.identity),
        sections=[(name, ["\n".join(block) for block in blocks]) for name, blocks in sections if blocks],
        texts_macro=naming.macro("with_texts"),
        text_type=naming.type("code_text"),
        texts=["\n".join(text_lines(naming, enum)) for enum in coded],
    )


def _messages(naming: Naming, layout: DeviceLayout) -> list[list[str]]:
    blocks = []
    for message in layout.messages.values():
        code = message.message.code
        head = told(message.message)
        if code is not None:
            head.append(f"#define {naming.macro(message.name, 'code')} {code}u")
        blocks.append(head)
        blocks += [record_lines(naming, layout.device, data, []) for data in (message.request, message.response)]
    return blocks
