"""The files of the C output."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.backends.c.comments import told
from fieldspec.backends.c.enums import coded, enum_lines, text_lines
from fieldspec.backends.c.frames import link_lines
from fieldspec.backends.c.fuzzing import target
from fieldspec.backends.c.machine import OWN_MACROS, machine_lines
from fieldspec.backends.c.naming import Naming, stem
from fieldspec.backends.c.parameters import parameter_lines
from fieldspec.backends.c.records import record_lines
from fieldspec.backends.c.registers import register_lines, table_lines
from fieldspec.backends.c.selection import claim_selection, selection
from fieldspec.backends.c.selftest import program
from fieldspec.backends.c.signals import conversion_lines, signal_lines
from fieldspec.backends.c.support import STATUSES, check_lines, number_lines, status_lines
from fieldspec.backends.c.text import folded, plain, string
from fieldspec.backends.c.words import flags_lines
from fieldspec.backends.forms import filled
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device

_OWN_TYPES = ("codec_status", "code_text", "selftest")
_OWN_MACROS = ("included", "version", "identity", "with_texts", "without_double", "wide_crc_table")


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """For each version of a device a header, a self-test and a fuzz target; and the header that takes one of these."""
    texts = selection(versions)
    for layout in versions:
        name = stem(layout.device.id, layout.device.version)
        naming = Naming(layout.device.id)
        texts[f"{name}.h"] = header(layout, naming)
        texts[f"{name}_selftest.c"] = program(layout, naming, f"{name}.h")
        texts[f"{name}_fuzz.c"] = target(layout, naming, f"{name}.h")
    return texts


def shared() -> dict[str, str]:
    """Nothing belongs to no device."""
    return {}


def header(layout: DeviceLayout, naming: Naming) -> str:
    """The header of a version. It settles the names, so whoever uses it must have the same naming."""
    device = layout.device
    _claim(naming, device.version, [version.id for line in device.lines for version in line.versions])
    algorithms = {
        part.algorithm
        for link in layout.links.values()
        for frame in (link.request, link.response)
        for part in frame.parts
        if part.algorithm
    }
    signals = [signal_lines(naming, signal) for signal in device.signals.values()]
    sections = [
        ("Compilers and machines", [machine_lines(naming)]),
        ("What functions return", [status_lines(naming)]),
        ("Numbers and characters, independent of the machine", number_lines(naming, layout)),
        ("Checks", check_lines(naming, algorithms)),
        ("Enums and codes", [enum_lines(naming, enum) for enum in device.enums.values()]),
        ("Words of flags", [flags_lines(naming, word) for word in device.flags.values()]),
        ("Signals", [lines for lines in signals if lines]),
        ("Conversions, which a machine without double leaves out", _conversions(naming, layout)),
        ("Records", [record_lines(naming, device, record, told(record.record)) for record in layout.records.values()]),
        ("Data of requests and responses", list(_messages(naming, layout))),
        ("Registers", [register_lines(naming, device, register) for register in layout.registers]),
        ("Tables of records", [table_lines(naming, device, table) for table in layout.tables.values()]),
        ("Parameters", [b for held in device.parameters.values() for b in parameter_lines(naming, device, held)]),
        ("Frames", [link_lines(naming, layout, link) for link in layout.links.values()]),
    ]
    return filled(
        "backends/c/header.h.in",
        title=plain(f"{device.name} ({device.vendor}), version {device.version}"),
        manual=plain(f"{device.manual.title} {device.manual.edition}".strip()),
        identity=layout.identity,
        guard=naming.own_macro("included"),
        version_guard=naming.own_macro("version", "is", device.version),
        version_macro=naming.own_macro("version"),
        version=string(device.version),
        identity_macro=naming.own_macro("identity"),
        identity_text=string(layout.identity),
        switches=_switches(naming, algorithms, bool(coded(device)), bool(device.conversions)),
        sections=[
            *(text for name, blocks in sections if blocks for text in _section(name, blocks)),
            *_texts(naming, device),
        ],
    )


def _section(name: str, blocks: Sequence[list[str]]) -> Iterator[str]:
    yield f"\n/* ---- {name} ---- */\n"
    yield from (_block(folded(block)) for block in blocks)


def _block(lines: Sequence[str]) -> str:
    """Lines behind an empty one."""
    return "\n".join(["", *lines, ""])


def _texts(naming: Naming, device: Device) -> Iterator[str]:
    """The texts of codes, where there are some."""
    held = coded(device)
    if held:
        yield filled(
            "backends/c/texts.h.in",
            macro=naming.own_macro("with_texts"),
            type=naming.own("code_text"),
            texts=[_block(text_lines(naming, enum)) for enum in held],
        )


def _claim(naming: Naming, version: str, versions: Sequence[str]) -> None:
    """Settles the names that every header has before those of the device are."""
    for name in _OWN_TYPES:
        naming.own(name)
    for name in (*_OWN_MACROS, *OWN_MACROS, *(status for status, _ in STATUSES)):
        naming.own_macro(name)
    naming.own_macro("version", "is", version)
    claim_selection(naming, versions)


def _switches(naming: Naming, algorithms: set[str], texts: bool, converting: bool) -> str:
    """What may be defined before the header is included, as lines of a comment."""
    known = (
        ("with_texts", "for the texts of codes, which take memory", texts),
        ("without_double", "to leave conversions out, which need double", converting),
        ("wide_crc_table", "for a faster check with a table of 512 bytes", "crc16_modbus" in algorithms),
    )
    lines = [f" *   {naming.own_macro(name)} {what}\n" for name, what, used in known if used]
    return "".join([" *\n * Before it is included there may be defined:\n", *lines] if lines else [])


def _conversions(naming: Naming, layout: DeviceLayout) -> list[list[str]]:
    blocks = [conversion_lines(naming, layout.device, one) for one in layout.device.conversions.values()]
    return [[f"#ifndef {naming.own_macro('without_double')}"], *blocks, ["#endif"]] if blocks else []


def _messages(naming: Naming, layout: DeviceLayout) -> Iterator[list[str]]:
    for message in layout.messages.values():
        held = message.message
        beside = f"Sent only beside {', '.join(held.supplements)}." if held.supplements else ""
        links = f"On {', '.join(held.links)}." if held.links and len(layout.links) > 1 else ""
        head = told(held, " ".join(text for text in (held.title and f"{held.title}.", links, beside) if text))
        for name, number in (("code", held.code), ("number", held.number)):
            if number is not None:
                head.append(f"#define {naming.macro('message', message.name, name)} {number}u")
        if head:
            yield head
        for data in (message.request, message.response):
            yield record_lines(naming, layout.device, data, [])
