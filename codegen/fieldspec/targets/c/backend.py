"""The files of the C output: for each version two headers, a self-test and a fuzz target, and the header that selects.

One of the headers has the constants of a version, and the other one, which includes it, the functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.omissions import Expressed, Omission, expressed, listing
from fieldspec.codec.layout.package_codecs import codec_refusals
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.names import Name, stem, version_word
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.targets.c.absent import AbsentValue, absent_values, declare_absent, declare_out_of_range, ranged_values
from fieldspec.targets.c.blocks import Block, FactBlock, print_block
from fieldspec.targets.c.checksums import checksum_parts, declare_checksums
from fieldspec.targets.c.conversions import declare_conversion
from fieldspec.targets.c.declarations import (
    Declaration,
    Define,
    Directive,
    comment,
    describe_fact,
    escape_comment,
)
from fieldspec.targets.c.enums import code_tables, declare_code_texts, declare_enum
from fieldspec.targets.c.escapes import declare_escapes
from fieldspec.targets.c.flags import declare_flags
from fieldspec.targets.c.frames import declare_link
from fieldspec.targets.c.fuzzing import write_fuzz_target
from fieldspec.targets.c.inner_lists import sent_size
from fieldspec.targets.c.literals import hexadecimal, string, unsigned
from fieldspec.targets.c.messages import declare_messages
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.parameters import declare_parameters
from fieldspec.targets.c.printer import Printer
from fieldspec.targets.c.quantities import declare_fixed_quantity, declare_quantity, fixed_values, scaled_values
from fieldspec.targets.c.records import declare_record
from fieldspec.targets.c.registers import declare_register, declare_signal, declare_table
from fieldspec.targets.c.runtime_files import all_records, copy_numbers, copy_runtime, runtime_macros
from fieldspec.targets.c.selftest import write_selftest
from fieldspec.targets.c.subcodes import has_subcode, subcodes_of
from fieldspec.targets.c.usages import usage_rows, version_usages
from fieldspec.targets.pieces import facts_of, register_runs, version_piece
from fieldspec.targets.templates import fill
from fieldspec.targets.usages import Rows, Usage, VersionUsages, cache_spelling, restore_spelling, spelling

_OWN_TYPES = ("codec_status", "code_text", "selftest")
_OWN_MACROS = (
    "included",
    "constants_included",
    "version",
    "identity",
    "with_texts",
    "without_double",
    "wide_crc_table",
)
_SELECT, _LATEST = "select", "latest"


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The refusals of codecs without C."""
    return [finding for layout in versions for finding in _remaining(layout).findings]


def _remaining(layout: DeviceLayout) -> Expressed:
    return expressed(layout, codec_refusals(layout, "C", lambda codec: codec.c))


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """For each version of a device its headers, a self-test and a fuzz target; and the header that takes a version."""
    texts = _selecting_header(versions)
    for layout in versions:
        version_texts, rows = version_piece("c", layout, (), _version)
        texts |= version_texts
        restore_spelling("c", layout, rows)
    return texts


def _version(whole: DeviceLayout) -> tuple[dict[str, str], Rows]:
    remaining = _remaining(whole)
    layout = remaining.layout
    name, naming = stem(layout.device.id, layout.device.version), Naming(layout.device.id)
    texts = headers(layout, naming, remaining.omissions)
    texts[f"{name}_selftest.c"] = write_selftest(layout, naming, f"{name}.h")
    texts[f"{name}_fuzz.c"] = write_fuzz_target(layout, naming, f"{name}.h")
    return texts, cache_spelling("c", layout, partial(usage_rows, layout, naming))


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for each version of a device, by the version."""
    return {
        layout.device.version: version_usages(layout, spelling("c", layout, partial(_spell, layout)))
        for layout in (_remaining(layout).layout for layout in versions)
    }


def _spell(layout: DeviceLayout) -> Iterator[Usage]:
    return usage_rows(layout, _claimed_names(layout))


def shared() -> dict[str, str]:
    """No files: every file of this output belongs to one device."""
    return {}


def headers(layout: DeviceLayout, naming: Naming, omissions: Sequence[Omission] = ()) -> dict[str, str]:
    """The headers of a version by path. They decide the names: other files of the version need the same naming."""
    device, name = layout.device, stem(layout.device.id, layout.device.version)
    _claim_names(naming, device.version, [version.id for line in device.lines for version in line.versions])
    algorithms = {part.algorithm for part in checksum_parts(layout)}
    constants, functions = _print_sections(naming, layout)
    described = {
        "title": escape_comment(f"{device.name} ({device.vendor}), version {device.version}"),
        "manual": escape_comment(f"{device.manual.title} {device.manual.edition}".strip()),
        "identity": layout.identity,
        "omissions": listing(omissions, escape_comment),
    }
    switches = _describe_switches(
        naming,
        algorithms,
        bool(code_tables(device)),
        bool(device.conversions or scaled_values(layout) or fixed_values(layout)),
    )
    return {
        f"{name}_constants.h": fill(
            "c/constants.h.j2",
            **described,
            header=f"{name}.h",
            guard=naming.own_macro("constants_included"),
            version_guard=naming.own_macro("version", "is", device.version),
            version_macro=naming.own_macro("version"),
            version=string(device.version).text,
            identity_macro=naming.own_macro("identity"),
            identity_text=string(layout.identity).text,
            enum_size=copy_runtime(naming, "enum_size.h").text,
            sections=constants,
        ),
        f"{name}.h": fill(
            "c/header.h.j2",
            **described,
            constants=f"{name}_constants.h",
            guard=naming.own_macro("included"),
            switches=switches,
            sections=functions,
        ),
    }


def _sections(naming: Naming, layout: DeviceLayout) -> tuple[tuple[str, Iterable[Block | FactBlock]], ...]:
    """The sections of a header with their declarations. Names are claimed in this order, while they are declared."""
    device = layout.device
    return (
        ("Compilers and machines", ([copy_runtime(naming, "machine.h")],)),
        ("Results of codec calls", ([copy_runtime(naming, "status.h")],)),
        ("Numbers and characters", copy_numbers(naming, layout)),
        ("Checksums", declare_checksums(naming, layout)),
        ("Escapes", declare_escapes(naming, layout)),
        ("Enums and codes", _enums(naming, device)),
        ("Bit fields", _flags(naming, device)),
        ("Signals", (declare_signal(naming, signal) for signal in device.signals.values())),
        ("Conversions, which need double", _conversions(naming, layout)),
        ("Records", _records(naming, layout)),
        ("Data of requests and responses", _messages(naming, layout)),
        ("Registers", _registers(naming, layout)),
        ("Record tables", (declare_table(naming, device, table) for table in layout.tables.values())),
        (
            "Parameters",
            (
                block
                for parameters in device.parameters.values()
                for block in declare_parameters(naming, layout, parameters)
            ),
        ),
        (
            "Frames",
            (
                [*declare_link(naming, layout, link), *declare_messages(naming, layout, link)]
                for link in layout.links.values()
            ),
        ),
        ("Texts of codes, in UTF-8", _code_texts(naming, layout)),
        ("Values that stand for a state", _absent_values(naming, layout)),
        ("Values out of range", _out_of_range(naming, layout)),
    )


def _claimed_names(layout: DeviceLayout) -> Naming:
    """All names of a header, which belong to what they would be printed for."""
    naming, device = Naming(layout.device.id), layout.device
    _claim_names(naming, device.version, [version.id for line in device.lines for version in line.versions])
    for _, blocks in _sections(naming, layout):
        for block in blocks:
            for inner in (block, *block.blocks()) if isinstance(block, FactBlock) else ():
                inner.declare()
    return naming


def _enums(naming: Naming, device: Device) -> Iterator[FactBlock]:
    for enum in device.enums.values():
        yield FactBlock("enum", (enum,), (), partial(declare_enum, naming, enum))


def _flags(naming: Naming, device: Device) -> Iterator[FactBlock]:
    for word in device.flags.values():
        facts = (word, *(device.enums.get(bit.enum) for bit in word.bits))
        yield FactBlock("flags", facts, (), partial(declare_flags, naming, word, device.enums))


def _registers(naming: Naming, layout: DeviceLayout) -> Iterator[FactBlock]:
    for run, facts in register_runs(layout):
        blocks = partial(map, partial(_register, naming, layout.device), run)
        yield FactBlock("registers", facts, tuple(layout.device.spaces), blocks=blocks)


def _register(naming: Naming, device: Device, register: RegisterLayout) -> FactBlock:
    fact = register.register
    space = device.space_name(fact.space) if device.several_spaces else ""
    facts = (fact, *facts_of(device, fact.value))
    declare = partial(declare_register, naming, device, register)
    return FactBlock("register", facts, (*register.numbers, space), declare)


def _print_sections(naming: Naming, layout: DeviceLayout) -> tuple[list[str], list[str]]:
    """The C text of all sections, each under its heading: the constants, and what is not constant."""
    printer = Printer()
    constants: list[str] = []
    functions: list[str] = []
    for name, blocks in _sections(naming, layout):
        pairs = [print_block(printer, naming, block) for block in blocks if block]
        for texts, own in ((constants, [pair[0] for pair in pairs]), (functions, [pair[1] for pair in pairs])):
            if any(own):
                texts += [f"\n/* ---- {name} ---- */\n", *own]
    return constants, functions


def _conversions(naming: Naming, layout: DeviceLayout) -> Iterator[Block]:
    conversions, scaled = layout.device.conversions.values(), scaled_values(layout)
    if conversions or scaled:
        yield [Directive("ifndef", naming.own_macro("without_double"))]
        yield from (declare_conversion(naming, layout.device, conversion) for conversion in conversions)
        if scaled:
            yield [copy_runtime(naming, "powers.h")]
        yield from (declare_quantity(naming, value) for value in scaled)
        yield [Directive("endif")]


def _absent_values(naming: Naming, layout: DeviceLayout) -> Iterator[Block]:
    """The functions that tell sentinels from quantities, then the conversions that refuse sentinels."""
    yield from (declare_absent(naming, absent) for absent in absent_values(layout))
    fixed = fixed_values(layout)
    if fixed:
        yield [Directive("ifndef", naming.own_macro("without_double"))]
        yield from (declare_fixed_quantity(naming, absent) for absent in fixed)
        yield [Directive("endif")]


def _out_of_range(naming: Naming, layout: DeviceLayout) -> Iterator[FactBlock]:
    device = layout.device

    def block(ranged: AbsentValue) -> FactBlock:
        facts, words = facts_of(device, ranged.value), (ranged.noun, ranged.names, ranged.trigger)
        return FactBlock("out of range", facts, words, partial(declare_out_of_range, naming, device, ranged))

    for facts, values in ranged_values(layout):
        if facts:
            yield FactBlock("all out of range", facts, (), blocks=partial(_each, block, values))
        else:
            yield from map(block, values())


def _each(
    block: Callable[[AbsentValue], FactBlock], values: Callable[[], Iterable[AbsentValue]]
) -> Iterator[FactBlock]:
    return map(block, values())


def _messages(naming: Naming, layout: DeviceLayout) -> Iterator[Block]:
    """For each message its code and number, then the data of its request and of its response."""
    for layout_of_message in layout.messages.values():
        message = layout_of_message.message
        companions = f"Sent only together with {', '.join(message.supplements)}." if message.supplements else ""
        links = f"On {', '.join(message.links)}." if message.links and len(layout.links) > 1 else ""
        sender = "" if message.is_requested else "Only the device sends it, of its own accord."
        if message.remote is not None:
            sender = f"A remote request with the DLC {message.remote}."
        description = " ".join(
            text for text in (message.title and f"{message.title}.", links, companions, sender) if text
        )
        subcodes = subcodes_of(layout, layout_of_message)
        subcode = subcodes[0][0] if len(subcodes) == 1 and subcodes[0][0] == subcodes[0][1] else None
        codes = [("code", message.code_of("request"))]
        codes += [("response_code", message.code_of("response"))] if message.has_response_code else []
        numbers = (*codes, ("subcode", subcode), ("number", message.number))
        comment_of_message = describe_fact(message, description)
        block: list[Declaration] = [comment_of_message] if comment_of_message.lines else []
        block += [
            Define(naming.macro("message", layout_of_message.name, name), unsigned(number))
            for name, number in numbers
            if number is not None
        ]
        if subcodes and subcode is None:
            explanation = comment("Whether an opened frame with the code and this subcode is of the message.")
            block += [explanation, has_subcode(naming, layout, layout_of_message.name, subcodes)]
        access = message.single_access
        if access is not None and access.set is not None:
            block += [
                Define(naming.macro("message", layout_of_message.name, name), hexadecimal(number, 2))
                for name, number in (("bit_set", access.set), ("bit_clear", access.clear))
            ]
        yield block
        for data in layout_of_message.bodies:
            yield declare_record(naming, layout.device, data, comment())


def _records(naming: Naming, layout: DeviceLayout) -> Iterator[Block]:
    elements = {field.record.name for record in all_records(layout) for field in record.fields if field.record}
    for record in layout.records.values():
        declarations = declare_record(naming, layout.device, record, describe_fact(record.record))
        tells_size = record.name in elements and record.size is None
        yield [*declarations, *sent_size(naming, record)] if tells_size else declarations


def _code_texts(naming: Naming, layout: DeviceLayout) -> Iterator[Block]:
    tables = code_tables(layout.device)
    if tables:
        yield [Directive("ifdef", naming.own_macro("with_texts")), copy_runtime(naming, "code_text.h")]
        *leading, last = tables
        yield from (declare_code_texts(naming, enum) for enum in leading)
        yield [*declare_code_texts(naming, last), Directive("endif")]


def _claim_names(naming: Naming, version: str, versions: Sequence[str]) -> None:
    """Claims the names of every header before the names of the device."""
    for name in _OWN_TYPES:
        naming.own(name)
    for name in (*_OWN_MACROS, *runtime_macros()):
        naming.own_macro(name)
    naming.own_macro("version", "is", version)
    # Those of the header that selects stay free in the headers of all versions.
    for words in ((), (_LATEST,), *((version_word(name),) for name in versions)):
        naming.own_macro(_SELECT, *words)


def _describe_switches(naming: Naming, algorithms: set[str], texts: bool, conversions: bool) -> str:
    """What may be defined before the header is included, as lines of a comment."""
    known = (
        ("with_texts", "adds the texts of codes, which take memory", texts),
        ("without_double", "leaves out the conversions, which need double", conversions),
        ("wide_crc_table", "takes a table of 512 bytes for a faster CRC", "crc16_modbus" in algorithms),
    )
    lines = [f" *   {naming.own_macro(name)} {effect}\n" for name, effect, used in known if used]
    return "".join([" *\n * Define before you include it:\n", *lines] if lines else [])


def _selecting_header(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The header that includes the one of the requested version, or of the only one; `versions` are of one device."""
    device = versions[-1].device
    naming = Naming(device.id)
    names = [(version, layout) for layout in versions for version in (layout.device.version, *layout.equal_versions)]
    macros = {version: naming.own_macro(_SELECT, version_word(version)) for version, _ in names}
    select = naming.own_macro(_SELECT)
    headers = [(macros[version], f"{stem(device.id, layout.device.version)}.h", layout) for version, layout in names]
    usage = f"Selects the header of a version. Define {select} before you include this header, or on the command line:"
    choices, latest = ", ".join(macros.values()), naming.own_macro(_SELECT, _LATEST)
    otherwise = f'#error "define {select} as one of {choices} or {latest}"\n'
    if len(headers) == 1:
        usage = f"Includes the header of the only version. You may define {select} to rely on that version:"
        otherwise = f'#include "{headers[0][1]}"\n'
    text = fill(
        "c/selection.h.j2",
        title=escape_comment(f"{device.name} ({device.vendor}), in any of its versions"),
        identity=versions[-1].identity,
        select=select,
        latest=latest,
        newest=macros[device.version],
        versions=[f" * {macro}: {name}, identity {layout.identity}\n" for macro, name, layout in headers],
        defined=[f"#define {macro} {number}\n" for number, (macro, _, _) in enumerate(headers, 1)],
        included=[f'#elif {select} + 0 == {macro}\n#include "{name}"\n' for macro, name, _ in headers],
        choices=choices,
        usage=usage,
        otherwise=otherwise,
    )
    return {f"{Name.of(device.id).snake()}.h": text}
