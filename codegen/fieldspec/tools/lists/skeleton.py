"""Writes the first spec of a device from a register list."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.encoding import is_count, is_real
from fieldspec.language.model.fact import PAGES
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.assumption import Refusal
from fieldspec.tools.lists.cells import whole
from fieldspec.tools.lists.entries import SPACES, Entry
from fieldspec.tools.lists.exponents import bounds, exponents, is_open
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.meaning_text import meant
from fieldspec.tools.lists.message_entries import place_of
from fieldspec.tools.lists.message_parts import links, messages
from fieldspec.tools.lists.naming import fresh, named, snake
from fieldspec.tools.lists.number_keys import numbers
from fieldspec.tools.lists.orders import order_keys
from fieldspec.tools.lists.own_parts import parameters, spaces, tables
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.row_reading import FIELD, MESSAGE, PARAMETER, REGISTER, SIGNAL, ListRow
from fieldspec.tools.lists.shapes import BIT
from fieldspec.tools.lists.yaml_text import commented, quoted

_HEAD = """\
# Written from a list, and not verified. Compare each row with the manual, cite its section and line as the source, and
# take `unverified` away. Then put the manual's own title, file and hash below.
"""
_CITING_HEAD = """\
# Written from an export, which cites the manual. Put the manual's own title, file, hash and number of lines below.
"""
_HAS_IT_SO = "The list has it so."
_ORDER = "sources_ascending"  # an object may cite the line of its first element, whose order is right


@dataclass(frozen=True, slots=True)
class Origin:
    """The file of a list, its hash and its number of lines."""

    file: str
    sha256: str
    lines: int


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The contents of a spec apart from the rows: remarks for its head, the facts from a protocol, and allowances.

    `uses` has lines by section and is empty for a spec without frames. `allowed` has the rules that a row
    may break, by its number, and those that an enum or a bit field may break, by the beginning of its line. `names` are
    those that the protocol has for numbers of parameters, and for subindices.
    """

    remarks: Sequence[str] = ()
    uses: Mapping[str, Sequence[str]] = field(default_factory=dict)
    names: Mapping[tuple[int, int | None], str] = field(default_factory=dict)
    allowed: Mapping[int | str, Sequence[str]] | None = None


_NOTHING = Surroundings()


@dataclass(frozen=True, slots=True)
class Spec:
    """The text of a spec, the row of the list that each line comes from, by its number, and the rows with notes.

    `declared` are the beginnings of the lines of enums and bit fields, by the numbers of the lines.
    """

    text: str
    rows: Mapping[int, int]
    noted: Sequence[int]
    declared: Mapping[int, str]


def skeleton(
    device: str,
    origin: Origin,
    registers: Sequence[Entry],
    refused: Sequence[Refusal] = (),
    surroundings: Surroundings = _NOTHING,
) -> Spec:
    """The spec of a device with the registers of a list. Rows that are refused become comments."""
    writer = _Writer(registers, surroundings)
    cited = [entry.row.cited for entry in registers if entry.row.cited]
    by_page = bool(cited) and cited[0].mark == PAGES
    last = max([0 if by_page else origin.lines, *(citation.first() for citation in cited)])
    lines = [*(_CITING_HEAD if cited else _HEAD).splitlines(), *map(commented, surroundings.remarks), "device:"]
    lines += [f"  id: {device}", f"  name: {device}", "  vendor: unknown"]
    title = f"The {'manual of the ' if cited else ''}list {origin.file}"
    lines += ["  manual:", f"    title: {quoted(title)}", f"    file: {quoted(origin.file)}"]
    lines += [f'    sha256: "{origin.sha256}"', f"    {'pages' if by_page else 'lines'}: {last}", ""]
    rows: dict[int, int] = {}
    declared: dict[int, str] = {}
    for line, number in writer.sections(surroundings.uses):
        lines.append(line if number or not by_page else line.replace("source: 1 L1", f"source: 1 {PAGES}1"))
        if number:
            rows[len(lines)] = number
        if line in writer.declared:
            declared[len(lines)] = _beginning(line)
    if refused:
        lines.append("# Rows and cells of the list that are not facts here:")
        lines += [commented(refusal.text()) for refusal in refused]
    return Spec("\n".join(lines) + "\n", rows, sorted(writer.noted), declared)


class _Writer:
    """Writes the sections of a spec as lines, each with the row that it comes from, or 0."""

    def __init__(self, registers: Sequence[Entry], surroundings: Surroundings) -> None:
        self._registers = registers = [_widened(entry, surroundings.names) for entry in registers]
        self._allowed = surroundings.allowed or {}
        known = self._protocol_names = surroundings.names
        self._labels: dict[str, set[str]] = defaultdict(set)
        self.noted: set[int] = set()
        self.declared: set[str] = set()
        used: dict[str, dict[str, int]] = defaultdict(dict)
        self._names = [
            fresh(known.get(_number(entry)) or _name(entry), f"{entry.row.address:04x}", used[_namespace(entry)])
            for entry in registers
        ]
        scaled = exponents([entry.row for entry in registers], [entry.shape.type for entry in registers])
        self._scale_by = {place: self._names[other] for place, other in scaled.items()}
        self._exponents = set(scaled.values())
        enums: dict[object, str] = {}
        enum_names: dict[str, int] = {}
        self._meant = [
            meant(entry, name, enums, enum_names, place in self._exponents or place in self._scale_by)
            for place, (entry, name) in enumerate(zip(registers, self._names, strict=True))
        ]

    def sections(self, uses: Mapping[str, Sequence[str]]) -> list[tuple[str, int]]:
        """The lines of what a protocol gives, units, enums, bit fields and registers."""
        lines: list[tuple[str, int]] = []
        for section, used_lines in uses.items():
            if used_lines and section not in ("enums", "flags", "records"):
                lines += [(f"{section}:", 0), *((line, 0) for line in used_lines)]
        lines += links(self._registers)
        if not uses and any(entry.row.is_own for entry in self._registers):
            lines += [(line, 0) for line in spaces(self._registers)]
        lines += self._units()
        for section in ("enums", "flags"):
            declarations = [
                (self._declaration(line), entry.row.row)
                for entry, meaning in zip(self._registers, self._meant, strict=True)
                for line in (meaning.enum_lines if section == "enums" else (meaning.flags_line,))
                if line
            ]
            used = [(line, 0) for line in uses.get(section, ())]
            lines += [(f"{section}:", 0), *used, *declarations] if used or declarations else []
        space_names = dict.fromkeys((*SPACES, *(entry.space for entry in self._registers)))
        groups = {
            space: [n for n, entry in enumerate(self._registers) if entry.space == space and entry.kind == REGISTER]
            for space in space_names
        }
        lines += tables(self._registers, self._fact, uses.get("records", ()))
        lines += [("registers:", 0)] if any(groups.values()) else []
        for space, places in groups.items():
            lines += self._group(space, places) if places else []
        lines += messages(self._registers, self._fact)
        return [*lines, *parameters(self._registers, self._fact, self._protocol_names)]

    def _declaration(self, line: str) -> str:
        """The line of an enum or of a bit field, with what it may break before its source, which is its last key."""
        if allowed := _allowance(self._allowed.get(_beginning(line), ())):
            line, _, source = line.rpartition(", source: ")
            line = f"{line}, {allowed}, source: {source}"
        self.declared.add(line)
        return line

    def _units(self) -> Iterator[tuple[str, int]]:
        """The units that the language does not have."""
        first_rows: dict[str, ListRow] = {}
        for entry in self._registers:
            for list_row in (entry.row, *(bit.row for bit in entry.bits if bit.row is not None)):
                if list_row.unit and not known_unit(list_row.unit):
                    first_rows.setdefault(list_row.unit, list_row)
        used: dict[str, int] = {}
        if first_rows:
            yield "units:", 0
        for unit, row in first_rows.items():
            name = fresh(snake(unit) or "unit", "unit", used)
            yield f"  - {{symbol: {quoted(unit)}, name: {name}, {', '.join(row.source())}}}", row.row

    def _group(self, space: str, places: Sequence[int]) -> Iterator[tuple[str, int]]:
        name = "listed" if space == REGISTERS else f"listed_{space}"
        yield f"  - group: {name}", 0
        if space != REGISTERS:
            yield f"    space: {space}", 0
        registers = [self._registers[place] for place in places]
        if not all(entry.row.is_verified for entry in registers):
            yield from (('    section: "1"', 0), ("    unverified: true", 0))
        addresses = [entry.row.address for entry in registers]
        has_tables = any(
            entry.space == space and (entry.kind == FIELD or (entry.rows and entry.row.stride > entry.shape.words))
            for entry in self._registers
        )
        if addresses == sorted(set(addresses)) and not has_tables:
            yield from ((line, 0) for line in _gaps(registers))
        else:
            yield "    order: as_listed", 0
        yield "    rows:", 0
        for place in places:
            yield f"      - {{{self._fact(place)}}}", self._registers[place].row.row

    def _fact(self, place: int) -> str:
        """The keys of a register, of a field or of a parameter."""
        entry, name, meaning = self._registers[place], self._names[place], self._meant[place]
        row, own_shape, texts = entry.row, entry.shape, entry.row.texts
        type_name = meaning.type or own_shape.type
        kind = PRIMITIVES[type_name]
        doubts = [*own_shape.doubts, *row.doubts, *meaning.doubts]
        inferred = {"type": own_shape.inferred} if own_shape.inferred else {}
        if place in self._exponents and is_open(row):
            low, high = bounds(row)
            row = replace(row, low=low, high=high)
            inferred["range"] = "The list does not say it; that of SunSpec is taken."
        if place in self._exponents and not row.access:
            row = replace(row, access="ro")
            inferred["access"] = "Other rows have it as their exponent."
        parts = _head(entry, name, type_name)
        parts += [f"access: {row.access}"] if row.access else []
        parts += order_keys(row.order, kind, _bytes(entry) if "digits" in row.form else kind.size)
        unit = known_unit(row.unit) or row.unit
        if unit and not meaning.flags_line and (is_count(kind.encoding) or is_real(kind.encoding)):
            parts.append(f"unit: {quoted(unit)}")
        elif unit:
            doubts.append(f"Unit in the list: {texts.get('unit', unit)}.")
        if scale_by := self._scale_by.get(place, ""):
            parts.append(f"scale_by: {quoted(scale_by)}")
            doubts = [doubt for doubt in doubts if not doubt.startswith(("Scale in the list", "Formula in the list"))]
        parts += numbers(row, kind, bool(scale_by), doubts)
        parts += meaning.keys
        allowed = [rule for rule in self._allowed.get(row.row, ()) if row.subindices is None or rule != _ORDER]
        if entry.is_own:
            parts += _words(row, name, self._labels[_list_of(entry)], allowed)
        parts += filter(None, [_allowance(allowed)])
        if inferred:
            parts.append(f"inferred: {{{', '.join(f'{key}: {reason}' for key, reason in inferred.items())}}}")
        if doubts:
            self.noted.add(row.row)
            parts.append(f"notes: [{', '.join(map(quoted, doubts))}]")
        parts += row.source("" if entry.kind in (REGISTER, FIELD) else "1 ")
        return ", ".join(parts)


def _beginning(line: str) -> str:
    """The beginning of the line of an enum or of a bit field, which has its name."""
    return line.partition(",")[0]


def _allowance(rules: Sequence[str]) -> str:
    """The key of the rules that a fact may break; empty for none."""
    return "allow: {" + ", ".join(f"{rule}: {_HAS_IT_SO}" for rule in dict.fromkeys(rules)) + "}" if rules else ""


def _head(entry: Entry, name: str, type_name: str) -> list[str]:
    """The first keys of a fact: where it is, its name, its type and its size."""
    row, own_shape = entry.row, entry.shape
    is_sized = bool(PRIMITIVES[type_name].size) and "digits" not in row.form
    type_name = ", ".join([type_name, *(f"{key}: {text}" for key, text in row.form.items())])
    if entry.kind == PARAMETER:
        elements = [f"elements: {row.count}"] if row.count > 1 or row.subindices else []
        elements += [] if is_sized else [f"length: {row.texts.get('bytes')}"]
        if row.subindices is not None:
            first, last = row.subindices
            index = f"{first}" if first == last else f"{first}..{last}"
            return [f"index: {index}", f"name: {quoted(name)}", f"type: {type_name}", *elements[1:]]
        return [f"number: {row.address}", f"name: {quoted(name)}", f"type: {type_name}", *elements]
    if entry.kind == MESSAGE:
        return [f"name: {quoted(name)}"]
    if entry.kind == SIGNAL:
        return [f"name: {quoted(name)}", f"type: {type_name}"]
    if entry.kind == FIELD:
        length = [] if is_sized else [f"length: {_bytes(entry)}"]
        length += ["reserved: true"] if row.const is not None else []
        return [f"name: {quoted(name.rpartition('.')[2])}", f"type: {type_name}", *length]
    parts = [f"at: 0x{row.address:04X}", f"name: {quoted(name)}", f"type: {type_name}"]
    if not is_sized:
        parts.append(f"length: {_bytes(entry)}")
    elif type_name != BIT and (row.words is not None or not row.is_own):
        parts.append(f"checked: {{words: {own_shape.words}}}")
    if own_shape.count > 1:
        parts += [f"count: {own_shape.count}", f"stride: {row.stride or own_shape.words}"]
        first_number = whole(row.texts.get("first", ""))
        parts += [f"index_from: {first_number}"] if first_number else []
        if entry.rows:
            parts.append(f"element_sources: {quoted('L' + ', '.join(str(row.row) for row in entry.rows))}")
        if entry.element_name not in ("", f"{name}_{{n}}"):
            parts.append(f"element_name: {quoted(entry.element_name)}")
    return parts


def _bytes(entry: Entry) -> int:
    """The bytes of a value whose type does not say them."""
    return int(entry.row.texts.get("bytes") or entry.shape.words * 2)


def _widened(entry: Entry, names: Mapping[tuple[int, int | None], str]) -> Entry:
    """A parameter with elements, with at least the number that the protocol names; any other entry as it is."""
    row = entry.row
    if entry.kind != PARAMETER or row.subindices is not None or row.count == 1:
        return entry
    last = max((subindex or 0 for number, subindex in names if number == row.address), default=0)
    return replace(entry, row=replace(row, count=max(row.count, last + 1)))


def _number(entry: Entry) -> tuple[int, int | None]:
    """The number of a parameter and the subindex of an element; -1 for what is not a parameter."""
    row = entry.row
    return row.address if entry.kind == PARAMETER else -1, row.subindices[0] if row.subindices else None


def _namespace(entry: Entry) -> str:
    """The scope in which a name must be unique: elements of a parameter have names of their own."""
    if entry.row.subindices is not None or entry.kind == SIGNAL:
        return f"{entry.space} {entry.row.address}"
    return entry.space if entry.row.is_own else ""


def _list_of(entry: Entry) -> str:
    """The list that an entry is in, of which no two have the same label."""
    if entry.kind == FIELD:
        return entry.row.texts["name"].rpartition(".")[0]
    return f"{entry.kind} {entry.space}" if entry.row.subindices is None and entry.kind != SIGNAL else _namespace(entry)


def _name(entry: Entry) -> str:
    if entry.kind == FIELD:
        return entry.row.texts["name"]
    if entry.row.is_own and entry.row.subindices is not None:
        return entry.row.texts["name"].rpartition(".")[2]
    if entry.kind == SIGNAL and not entry.is_own:
        return f"word_{place_of(entry.row).first_byte}"
    kind = "object" if entry.kind == PARAMETER else "register"
    return named(entry.row.names if entry.is_own else (), entry.row.address, kind)


def _gaps(registers: Sequence[Entry]) -> Iterator[str]:
    """The lines of the gaps between the first register and the last. The registers ascend."""
    gaps = []
    end = registers[0].row.address
    for entry in registers:
        if entry.row.address > end:
            gaps.append((end, entry.row.address - 1))
        end = max(end, entry.row.address + _extent(entry))
    if gaps:
        yield "    gaps:"
    for low, high in gaps:
        address_text = f"0x{low:04X}" if low == high else f"0x{low:04X}..0x{high:04X}"
        yield f"      - {{at: {address_text}, reason: The list leaves them out.}}"


def _extent(entry: Entry) -> int:
    """The number of addresses from a register's first to its last."""
    words = entry.shape.words
    return (entry.shape.count - 1) * (entry.row.stride or words) + words


def _words(row: ListRow, name: str, labels: set[str], allowed: list[str]) -> Iterator[str]:
    """The printed name and the label of a register; two equal ones and broken ones are added to what is `allowed`."""
    texts = row.texts
    is_own_element = row.is_own and row.subindices is not None
    printed = texts.get("printed_name", "") or (row.names[0] if row.names and not is_own_element else "")
    label = texts.get("label", "")
    if "printed_name" in texts and not row.is_own and row.names and row.names[0] != printed:
        label = label or row.names[0]
    if printed == label and "printed_name" not in texts and "name" not in texts:
        printed = ""
    if "_" in printed and len(printed.split()) > 1 and printed != name:
        allowed.append("printed_names_whole")
    for key, text in (("printed_name", printed), ("label", label)):
        if text and text != name:
            if f"{key} {text}" in labels and not row.is_own and row.kind != MESSAGE:
                allowed.append("labels_unique")
            labels.add(f"{key} {text}")
            yield f"{key}: {quoted(text)}"
