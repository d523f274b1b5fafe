"""A register dump of a real device, decoded and compared with the spec."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.explain.values import DecodedValue, decode_value
from fieldspec.codec.layout.bases import at_bases, moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.checks.finding import range_key
from fieldspec.language.diagnostics import Diagnostic, Label, Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.value import Value
from fieldspec.language.reading.findings import bounded
from fieldspec.tools.audit.addressed_values import Address, AddressedValue, addressed_values
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable
from fieldspec.tools.lists.addresses import HEXADECIMAL
from fieldspec.tools.lists.dump import Dump, Entry
from fieldspec.tools.lists.words import folded

WORD = 16
_ALL = (1 << WORD) - 1

_RANGE = "dump_value_within_range"
_KNOWN = "dump_value_known"
_CLEAR = "dump_reserved_clear"
_WHOLE = "dump_value_whole"
_ADDRESS = "dump_address_known"
_REASONS = {"out_of_range": _RANGE, "unknown_value": _KNOWN, "wrong_const": _KNOWN}


@dataclass(frozen=True, slots=True)
class DumpValue:
    """A value of a dump: its rows, its decoded value, and the set bits without a meaning (`spare`)."""

    name: str
    where: str
    fact: Fact
    value: Value
    rows: tuple[int, ...]
    decoded: DecodedValue
    spare: tuple[int, ...]
    reserved: bool
    unread: bool = False

    @property
    def number(self) -> object:
        """The raw value."""
        return self.decoded.number

    @property
    def text(self) -> str:
        """The meaning of the value in a few words."""
        names = [meaning.name or f"bit {meaning.bits}" for meaning in self.decoded.meanings]
        if self.value.flags:
            return "[" + ", ".join(names) + "]"
        return ", ".join(text for text in (*names, self.decoded.text) if text)

    @property
    def differs(self) -> bool:
        """Whether it is not the initial value that the manual prints."""
        default = self.value.default
        judged = not self.decoded.reason and not self.reserved and not self.unread
        return default is not None and judged and self.number != default


@dataclass(frozen=True, slots=True)
class Hole:
    """A value of which the dump has only some words."""

    name: str
    fact: Fact
    rows: tuple[int, ...]
    missing: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class DumpReport:
    """A dump compared with a device.

    `base` is how its addresses were read; `twice` has rows that contradict an earlier row.
    """

    base: str
    read: tuple[DumpValue, ...]
    holes: tuple[Hole, ...]
    unknown: tuple[Entry, ...]
    too_great: tuple[tuple[Entry, AddressedValue], ...]
    twice: tuple[tuple[Entry, int], ...]


def compared(layout: DeviceLayout, dump: Dump, offset: int = 0) -> DumpReport:
    """A dump compared with a device, with the base that has the fewest unknown addresses, then the fewest errors."""
    reports = [_report(layout, base, dump.entries(base), offset) for base in dump.bases]
    return max(reports, key=lambda report: (-len(report.unknown), -_doubtful(report)))


def _doubtful(report: DumpReport) -> int:
    """The number of errors with a base."""
    wrong = sum(1 for read in report.read if read.decoded.reason or read.spare)
    return wrong + len(report.holes) + len(report.too_great) + len(report.twice)


def _report(layout: DeviceLayout, base: str, entries: Sequence[Entry], offset: int) -> DumpReport:
    """A dump compared with a device, whose tables begin where the dump says."""
    report = _placed_report(layout, base, entries, offset)
    numbers = {read.name: read.number for read in report.read if not read.decoded.reason}
    bases = {
        name: number
        for name, register in moving_tables(layout).items()
        if isinstance(number := numbers.get(register.name), int)
    }
    return _placed_report(at_bases(layout, bases), base, entries, offset) if bases else report


def _placed_report(layout: DeviceLayout, base: str, entries: Sequence[Entry], offset: int) -> DumpReport:
    device_values = list(addressed_values(layout))
    starts: dict[Address, AddressedValue] = {}
    known: dict[Address, AddressedValue] = {}
    for slot in device_values:
        starts.setdefault((slot.space, slot.address), slot)
        for address in slot.addresses:
            known.setdefault(address, slot)
    words: dict[Address, tuple[int, int]] = {}
    unknown: list[Entry] = []
    too_great: list[tuple[Entry, AddressedValue]] = []
    twice: list[tuple[Entry, int]] = []
    parameters: list[DumpValue] = []
    for entry in entries:
        first = entry.address - offset
        read = (
            list(_parameters(layout.device, entry, first)) if not device_values or _names_a_space(layout, entry) else []
        )
        if read:
            parameters += read
            continue
        space = _space(layout.device, entry)
        start_value = starts.get((space, first))
        split = _split(layout.device, entry, start_value)
        if split is None and (space, first) in known:
            too_great.append((entry, start_value or known[space, first]))
            continue
        if split is None or not any((space, first + index) in known for index in range(len(split))):
            unknown.append(entry)
            continue
        for index, word in enumerate(split):
            before = words.setdefault((space, first + index), (word, entry.row))
            if before[0] != word:
                twice.append((entry, before[1]))
    values, holes = [], []
    for slot in device_values:
        present = [address for address in slot.addresses if address in words]
        if len(present) == slot.words:
            values.append(_decode_value(layout.device, slot, words))
        elif present:
            lacking = tuple(address[1] for address in slot.addresses if address not in words)
            holes.append(Hole(slot.name, slot.fact, tuple(words[address][1] for address in present), lacking))
    return DumpReport(base, (*values, *parameters), tuple(holes), tuple(unknown), tuple(too_great), tuple(twice))


def _space(device: Device, entry: Entry) -> str:
    """The address space that a row names; the first one where it names none, or an unknown one."""
    spaces_by_name = {folded(name): name for name in device.spaces}
    return spaces_by_name.get(folded(entry.space), device.space_name("")) if entry.space else device.space_name("")


def _names_a_space(layout: DeviceLayout, entry: Entry) -> bool:
    """Whether a row names a space of parameters."""
    spaces = {folded(parameter_set.space) for parameter_set in layout.device.parameters.values()}
    return bool(entry.space) and folded(entry.space) in spaces


def _split(device: Device, entry: Entry, slot: AddressedValue | None) -> list[int] | None:
    """The words of a row; a great number is divided like the value at its address. None if it does not fit."""
    if len(entry.values) == 1:
        number = entry.values[0]
        wide = slot.words if slot is not None and slot.words > 1 else 1
        if wide > 1 and (entry.words == wide or not -(1 << (WORD - 1)) <= number <= _ALL):
            bits = WORD * wide
            if not -(1 << (bits - 1)) <= number < 1 << bits:
                return None
            number &= (1 << bits) - 1
            parts = [number >> WORD * index & _ALL for index in reversed(range(wide))]
            return parts if device.word_order == "big" else parts[::-1]
    if any(not -(1 << (WORD - 1)) <= number <= _ALL for number in entry.values):
        return None
    return [number & _ALL for number in entry.values]


def _decode_value(device: Device, slot: AddressedValue, words: Mapping[Address, tuple[int, int]]) -> DumpValue:
    addresses = slot.addresses
    order = "big" if device.byte_order == "big" else "little"
    data = b"".join(words[address][0].to_bytes(2, order) for address in addresses)  # type: ignore[arg-type]
    data = data[slot.skip : slot.skip + slot.value.size]
    decoded = decode_value(
        device,
        slot.value,
        data,
        slot.order,
        slot.swapped,
        slot.reserved or slot.unread,
    )
    rows = tuple(dict.fromkeys(words[address][1] for address in addresses))
    spare = _spare(device, slot.value, decoded, slot.reserved or slot.unread)
    return DumpValue(
        slot.name,
        f"0x{slot.address:04X}",
        slot.fact,
        slot.value,
        rows,
        decoded,
        spare,
        slot.reserved,
        slot.unread,
    )


def _spare(device: Device, value: Value, decoded: DecodedValue, reserved: bool) -> tuple[int, ...]:
    """The set bits without a meaning."""
    word = device.flags.get(value.flags)
    if word is None or reserved or not isinstance(decoded.number, int):
        return ()
    used = sum(bit.mask for bit in word.bits if not bit.reserved)
    left = decoded.number & ((1 << 8 * value.type.size) - 1) & ~used
    return tuple(bit_number for bit_number in range(left.bit_length()) if left >> bit_number & 1)


def _parameters(device: Device, entry: Entry, number: int) -> Iterator[DumpValue]:
    """The values of the parameter with a number on the wire."""
    spaces = dict.fromkeys(parameter_set.space for parameter_set in device.parameters.values())
    chosen_spaces = [space for space in spaces if folded(space) == folded(entry.space)] or list(spaces)
    for space in chosen_spaces:
        match = device.parameter_at(space, number)
        parameter = match[0].numbered(match[1]) if match is not None else None
        if match is None or parameter is None:
            continue
        for index, raw_value in enumerate(entry.values):
            yield _parameter(device, match[0].number_text(match[1]), parameter, index, raw_value, entry)
        return


def _parameter(
    device: Device, number_text: str, parameter: Parameter, index: int, number: int, entry: Entry
) -> DumpValue:
    element = parameter.element(index)
    value = element.value if element is not None else parameter.value
    reserved = parameter.reserved or (element is not None and element.reserved)
    name = parameter.name + (f"[{index}]" if parameter.elements or len(entry.values) > 1 else "")
    bits = 8 * value.size
    if is_exact(value.encoding) and -(1 << (bits - 1)) <= number < 1 << bits:
        data = (number & ((1 << bits) - 1)).to_bytes(value.size, "big")
        decoded = decode_value(device, value, data, "big", False, reserved)
    else:
        decoded = DecodedValue(number).judged(False, f"{value.size} bytes of {value.type.name}", "out_of_range")
    spare = _spare(device, value, decoded, reserved)
    return DumpValue(name, number_text, element or parameter, value, (entry.row,), decoded, spare, reserved)


def judged(report: DumpReport, file: SourceFile, rows: Mapping[int, int]) -> list[Diagnostic]:
    """The findings about a dump; `rows` has the offset of each row in the file.

    Findings of one rule are limited as those about a spec are: a dump may have a hundred thousand rows.
    """
    by_rule: dict[str, list[Diagnostic]] = {}
    for finding in _findings(report, file, rows):
        by_rule.setdefault(finding.code, []).append(finding)
    return [finding for findings in by_rule.values() for finding in bounded(findings)]


def _findings(report: DumpReport, file: SourceFile, rows: Mapping[int, int]) -> list[Diagnostic]:

    def row_span(row: int) -> Span:
        start = rows.get(row, 0)
        end = file.text.find("\n", start)
        return Span(file, start, len(file.text) if end < 0 else end)

    findings = [finding for read in report.read for finding in _wrong(read, row_span(read.rows[0]))]
    for hole in report.holes:
        lacking = ", ".join(f"0x{address:04X}" for address in hole.missing)
        text = f"{hole.name} has more words than the dump: {lacking} is missing"
        findings.append(
            finding(_WHOLE, text, row_span(hole.rows[0]), hole.fact, "read all of its words, in one request")
        )
    for entry, slot in report.too_great:
        text = f"{slot.name} has {slot.words} words; {max(entry.values, key=abs)} does not fit into them"
        findings.append(finding(_RANGE, text, row_span(entry.row), slot.fact, "read it again, or correct the address"))
    for entry, before in report.twice:
        label = Label(row_span(before), "another value")
        text = "an address has two values"
        findings.append(Diagnostic(_WHOLE, text, row_span(entry.row), (label,), "use a dump with each address once"))
    for entry in report.unknown:
        text = f"the spec does not have the address 0x{entry.address:04X}"
        help = "transcribe it, or use --base or --offset if the dump counts addresses differently"
        findings.append(Diagnostic(_ADDRESS, text, row_span(entry.row), help=help, severity=Severity.WARNING))
    return findings


def _wrong(read: DumpValue, span: Span) -> Iterator[Diagnostic]:
    """The findings about a value of the dump."""
    if read.decoded.reason:
        raw_text = read.number.hex(" ") if isinstance(read.number, bytes) else read.number
        text = f"{read.name} is {raw_text}; it {read.decoded.verdict.removeprefix('wrong: ')}"
        yield finding(
            _REASONS.get(read.decoded.reason, _KNOWN), text, span, read.fact, "the device, or the spec, is wrong"
        )
    for note in read.decoded.notes if not read.decoded.reason and read.value.enum and not read.decoded.meanings else ():
        yield finding(_KNOWN, f"{read.name}: {note}", span, read.fact, "transcribe it if the manual has it", False)
    if read.spare:
        bits = ", ".join(map(str, read.spare))
        text = f"{read.name} has bits set that have no meaning: {bits}"
        yield finding(_CLEAR, text, span, read.fact, "transcribe them if the manual has them")
    resting = read.value.const if read.value.const is not None else read.value.default or 0
    if read.reserved and isinstance(read.number, int) and read.number != resting:
        text = f"{read.name} is reserved and holds {read.number}"
        yield finding(_CLEAR, text, span, read.fact, "transcribe it if the manual describes it", False)


def finding(code: str, text: str, span: Span, fact: Fact, help: str, grave: bool = True) -> Diagnostic:
    """A finding about a value, with the place of the spec that it contradicts; a warning if it is not `grave`."""
    label = Label(fact.place[range_key(fact.place) if code == _RANGE else "name"], "what the spec says")
    return Diagnostic(code, text, span, (label,), help, Severity.ERROR if grave else Severity.WARNING)


def section(report: DumpReport, findings: Sequence[Diagnostic], skipped: int) -> Section:
    """The section of a dump; `skipped` is how many rows have no address or no value."""
    wrong = [read for read in report.read if read.decoded.reason or read.spare]
    differing = [read for read in report.read if read.differs]
    base = "hexadecimal" if report.base == HEXADECIMAL else report.base
    paragraphs = [f"Addresses were read as {base}."]
    if skipped:
        paragraphs.append(f"{skipped} rows have no address or no value.")
    figures = (
        Figure("values decoded", len(report.read)),
        Figure("values that are impossible, or have reserved bits set", len(wrong), len(report.read), not wrong),
        Figure("values with missing words", len(report.holes), None, not report.holes),
        Figure("addresses that are not in the spec", len(report.unknown), None, not report.unknown),
        Figure("values that differ from the initial values", len(differing), len(report.read)),
    )
    tables = (
        _values("wrong", "Values that cannot be", wrong, "bad"),
        _defaults(differing),
        _unknown(report.unknown),
        _values("values", "All values", report.read, ""),
    )
    return Section("dump", "Values of the device", tuple(paragraphs), figures, tables, tuple(findings))


def _values(name: str, title: str, reads: Sequence[DumpValue], kind: str) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    for read in reads:
        number = read.number
        raw: Cell = number.hex(" ") if isinstance(number, bytes) else str(number)
        verdict = read.decoded.verdict.removeprefix("wrong: ") if read.decoded.reason else ""
        if read.spare:
            verdict = f"without a meaning: bits {', '.join(map(str, read.spare))}"
        rows.append((read.where, read.name, raw, read.text, verdict, read.rows[0]))
    columns = ("address", "name", "raw", "meaning", "verdict", "row")
    return SectionTable(name, title, columns, tuple(rows), (kind,) * len(rows), detail=name == "values")


def _defaults(reads: Sequence[DumpValue]) -> SectionTable:
    rows = tuple(
        (
            dump_value.where,
            dump_value.name,
            str(dump_value.number),
            str(dump_value.value.default),
            dump_value.text,
            dump_value.rows[0],
        )
        for dump_value in reads
    )
    columns = ("address", "name", "raw", "initial", "meaning", "row")
    return SectionTable("defaults", "Values that differ from the initial values", columns, rows)


def _unknown(entries: Sequence[Entry]) -> SectionTable:
    rows = tuple((f"0x{entry.address:04X}", ", ".join(map(str, entry.values)), entry.row) for entry in entries)
    return SectionTable("unknown", "Addresses that are not in the spec", ("address", "raw", "row"), rows)
