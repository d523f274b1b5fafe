"""Electronic data sheets and device configurations (EDS and DCF, CiA 306) as rows: an object or an element for each.

The library canopen reads them, object by object, so that one that cannot be read does not hide the others. It says
neither where an object is nor what it has not used: the lines and keys of the file do.
"""

from __future__ import annotations

import io
import logging
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any

from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.formats.format_rows import FormatRows, decimal
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.object_rows import OBJECTS, TEXT_BYTES, object_of
from fieldspec.tools.lists.row_reading import PARAMETER, ListRow
from fieldspec.tools.lists.sheet import MOST_ROWS, ListError, Sheet
from fieldspec.tools.lists.type_words import Typed, with_sign

SIGNS = re.compile(
    r"^[ \t]*\[(?:FileInfo|DeviceInfo|DeviceComissioning|DeviceCommissioning|DummyUsage|MandatoryObjects)\]",
    re.IGNORECASE | re.MULTILINE,
)
"""What such a file begins with, after comments."""

_TYPES = {
    0x01: "bool8",
    0x02: "i8",
    0x03: "i16",
    0x04: "i32",
    0x05: "u8",
    0x06: "u16",
    0x07: "u32",
    0x08: "f32",
    0x09: "text",
    0x0C: "bytes",
    0x0D: "bytes",
    0x10: "i24",
    0x11: "f64",
    0x12: "i40",
    0x13: "i48",
    0x14: "i56",
    0x15: "i64",
    0x16: "u24",
    0x18: "u40",
    0x19: "u48",
    0x1A: "u56",
    0x1B: "u64",
}
"""The types by the numbers that CiA 301 has for them. Texts have no length there, and what is missing has no size."""

_ACCESSES = {"ro": "ro", "const": "ro", "wo": "wo", "rw": "rw", "rwr": "rw", "rww": "rw"}
_TEXT = "text"
_TIME_BYTES = 6
_LAST_SUBINDEX = 0xFE
_SECTION = re.compile(r"\s*\[([^\]]*)\]")
_OBJECT = re.compile(r"([0-9A-Fa-f]{4})(?:sub([0-9A-Fa-f]{1,2}))?", re.IGNORECASE)
_NAMES = re.compile(r"([0-9A-Fa-f]{4})Name", re.IGNORECASE)
_LISTS = re.compile(r"(?:Mandatory|Optional|Manufacturer)Objects", re.IGNORECASE)
_NODE = ("DeviceComissioning", "DeviceCommissioning")

_ROLES = {
    "Index": "address",
    "ParameterName": "name",
    "ObjectType": "kind",
    "DataType": "type",
    "AccessType": "access",
    "LowLimit": "min",
    "HighLimit": "max",
    "DefaultValue": "default",
    "SubNumber": "elements",
    "CompactSubObj": "equal elements",
    "Unit": "unit",
    "Factor": "scale",
}
_NOTES = ("ParameterValue", "Denotation", "Description")


@dataclass(slots=True)
class _Section:
    """A section of the file: the line and the text of its heading, and its keys with their texts and lines."""

    line: int
    name: str
    pairs: dict[str, str] = field(default_factory=dict)
    lines: dict[str, int] = field(default_factory=dict)

    def text(self) -> str:
        return f"[{self.name}]\n" + "".join(f"{key}={value}\n" for key, value in self.pairs.items())


@dataclass(frozen=True, slots=True)
class _Element:
    """A value: its line, the section that describes it, and the variable that the library has of it."""

    line: int
    section: _Section
    variable: Any


def object_dictionary(text: str) -> tuple[Sheet, Listing]:
    """The list of an electronic data sheet. Raises ListError."""
    try:
        from canopen.objectdictionary import eds
    except ImportError:
        raise ListError(
            "is an electronic data sheet (EDS or DCF), which needs more packages: pip install 'fieldspec[lists]'"
        ) from None
    rows = FormatRows("an electronic data sheet (EDS or DCF)", _ROLES, _NOTES)
    sections = list(_sections(text))
    if len(sections) > MOST_ROWS:
        raise ListError(f"has more than {MOST_ROWS} sections; a data sheet has fewer")
    node = next((decimal(part.pairs.get("NodeID", "")) for part in sections if part.name in _NODE), None)
    groups: dict[int, list[_Section]] = {}
    types = {part.name.casefold(): part for part in sections}
    earlier: set[str] = set()
    for section in sections:
        match = _OBJECT.fullmatch(section.name) or _NAMES.fullmatch(section.name)
        if match is None:
            continue
        if section.name.casefold() in earlier:
            rows.refuse(section.line, _cells(section), "stands there twice")
            continue
        earlier.add(section.name.casefold())
        groups.setdefault(int(match[1], 16), []).append(section)
    logging.getLogger(eds.__name__).disabled = True  # what it warns of is refused or noted here
    for number, group in groups.items():
        _add_object(rows, eds, number, group, types, int(node) if node is not None else None)
    for number, line in _absent(sections, groups):
        cells = {"Index": f"{number:04X}"}
        rows.refuse(line, cells, f"is in the list of objects, and has no section [{number:04X}]", "Index")
    rows.items.sort(key=lambda item: item.line)
    return rows.listing(text.count("\n") + 1)


def _sections(text: str) -> Iterator[_Section]:
    section: _Section | None = None
    for number, line in enumerate(text.splitlines(), 1):
        if heading := _SECTION.match(line):
            if section is not None:
                yield section
            section = _Section(number, heading[1].strip())
        elif section is not None and "=" in line and not line.lstrip().startswith(";"):
            key, _, text = (part.strip() for part in line.partition(" ;")[0].partition("="))
            section.pairs.setdefault(key, text)
            section.lines.setdefault(key, number)
    if section is not None:
        yield section


def _absent(sections: Sequence[_Section], groups: Mapping[int, object]) -> Iterator[tuple[int, int]]:
    """The objects that the file counts among its own and does not describe, each with a line."""
    for section in sections:
        if _LISTS.fullmatch(section.name):
            for key, text in section.pairs.items():
                number = decimal(text)
                if key.isdecimal() and number is not None and int(number) not in groups:
                    yield int(number), section.lines[key]


def _cells(section: _Section) -> dict[str, str]:
    return {"Index": section.name, **section.pairs}


def _add_object(
    rows: FormatRows, eds: Any, number: int, group: Sequence[_Section], types: Mapping[str, _Section], node: int | None
) -> None:
    """Adds an object and its elements."""
    head, *parts = sorted(group, key=lambda section: len(section.name))
    by_subindex = {int(match[2], 16): part for part in parts if (match := _OBJECT.fullmatch(part.name)) and match[2]}
    if not re.fullmatch("[0-9A-Fa-f]{4}", head.name):
        for section in group:
            rows.refuse(section.line, _cells(section), f"has no section [{number:04X}], which says what it is")
        return
    whole = _read(eds, [head, *(part for part in parts if _NAMES.fullmatch(part.name))], types, node)
    if isinstance(whole, str):
        for section in group:
            rows.refuse(section.line, _cells(section), whole)
        return
    entry = whole[number]
    if not hasattr(entry, "subindices"):
        _add(rows, _Element(head.line, head, entry), None)
        for part in parts:
            rows.refuse(part.line, _cells(part), f"is an element of [{head.name}], which has none")
        return
    elements: dict[tuple[int, int], _Element] = {}
    for subindex, part in sorted(by_subindex.items()):
        element = _read(eds, [head, part], types, node)
        if isinstance(element, str):
            rows.refuse(part.line, _cells(part), element)
        else:
            elements[subindex, subindex] = _Element(part.line, part, element[number].subindices[subindex])
    names = next((part for part in parts if _NAMES.fullmatch(part.name)), None)
    last = int(decimal(head.pairs.get("CompactSubObj", "")) or 0)
    for subindex, variable in entry.subindices.items() if last else ():
        place = (subindex, min(last, _LAST_SUBINDEX) if subindex and names is None else subindex)
        line = names.lines.get(str(subindex), names.line) if names is not None and subindex else 0
        key = "DataType" if subindex else "CompactSubObj"
        number_of_entries = {"DataType": "0x0005", "AccessType": "ro", "DefaultValue": str(last)}
        section = head if subindex else _Section(head.line, head.name, number_of_entries)
        elements.setdefault(place, _Element(line or head.lines.get(key, head.line), section, variable))
    _add_elements(rows, head, number, elements)


def _add_elements(rows: FormatRows, head: _Section, number: int, elements: Mapping[tuple[int, int], _Element]) -> None:
    """Adds an object that consists of elements, and these; without one that has a size it is refused."""
    sized = [_row(part.section, part.variable, place) for place, part in elements.items() if _type(part.variable)]
    if not sized:
        rows.refuse(head.line, _cells(head), "has no element of a type whose size is known")
    else:
        name = head.pairs.get("ParameterName", "")
        whole = ListRow(0, number, names=(name,), texts={"label": name})
        rows.add(head.line, _cells(head), object_of(whole, sized))
    for place, element in sorted(elements.items()):
        _add(rows, element, place)


def _read(eds: Any, sections: Sequence[_Section], types: Mapping[str, _Section], node: int | None) -> Any:
    """The dictionary with one object, as the library reads its sections; a text if it does not."""
    own_types = {f"{int(decimal(part.pairs.get('DataType', '')) or 0):X}".casefold() for part in sections}
    definitions = [types[key] for name in own_types for key in (name, f"{name}sub1") if key in types]
    text = "[DeviceInfo]\n" + "".join(part.text() for part in (*definitions, *sections))
    try:
        return eds.import_eds(io.StringIO(text), node)
    except Exception as error:  # the library raises what it stumbles over: KeyError, NoOptionError, ValueError
        return f"cannot be read: {' '.join(str(error).split())[:200] or type(error).__name__}"


def _type(variable: Any) -> str:
    return _TYPES.get(variable.data_type, "")


def _bytes(variable: Any) -> str:
    """The size of a text or of bytes; empty for a number."""
    match _type(variable):
        case "text":
            return str(max(TEXT_BYTES, len(str(variable.default or "").encode())))
        case "bytes":
            return str(_TIME_BYTES)
        case _:
            return ""


def _add(rows: FormatRows, element: _Element, place: tuple[int, int] | None) -> None:
    """Adds an object of one value, or an element."""
    line, section, variable = element.line, element.section, element.variable
    name, access = _type(variable), section.pairs.get("AccessType", "")
    if not name:
        reason = f"has the data type 0x{variable.data_type:04X}, whose size such a file does not have"
        rows.refuse(line, _cells(section), reason, "DataType")
    elif access.casefold() not in _ACCESSES:
        rows.refuse(line, _cells(section), "is not an access of an object", "AccessType")
    else:
        if name == _TEXT and not any(assumption.subject == "texts" for assumption in rows.assumptions):
            reading = f"up to {TEXT_BYTES} bytes, or as long as their defaults"
            rows.assumptions.append(Assumption("texts", reading, "such a file has no lengths"))
        rows.add(line, _cells(section), _row(section, variable, place))


def _row(section: _Section, variable: Any, place: tuple[int, int] | None) -> ListRow:
    """The row of a value."""
    name = _type(variable)
    access = section.pairs.get("AccessType", "").casefold()
    keys = {"type": "DataType", "access": "AccessType", "min": "LowLimit", "max": "HighLimit", "unit": "Unit"}
    texts = {role: text for role, key in keys.items() if (text := section.pairs.get(key, ""))}
    texts |= {"space": OBJECTS, "bytes": _bytes(variable), "label": variable.name}
    initial = "const" if access == "const" else "default"
    text = section.pairs.get("DefaultValue", "")
    texts |= {initial: text} if text else {}
    by_node = isinstance(variable.default, int) and _number(text, name) is None
    value = Decimal(variable.default) if by_node else _number(text, name)
    is_factor = math.isfinite(variable.factor) and variable.factor > 0
    return ListRow(
        0,
        variable.index,
        names=(variable.name,),
        type=Typed(name),
        access=_ACCESSES.get(access, ""),
        low=_number(texts.get("min", ""), name),
        high=_number(texts.get("max", ""), name),
        default=value if initial == "default" else None,
        const=value if initial == "const" else None,
        texts=texts,
        kind=PARAMETER,
        subindices=place,
        space=OBJECTS,
        unit=variable.unit,
        scale=Fraction(str(variable.factor)) if is_factor else None,
    )


def _number(text: str, name: str) -> Decimal | None:
    """A number of a type. That of a signed one may be written as the bits that are sent, which the library has not."""
    number = decimal(text)
    return None if number is None else with_sign(number, PRIMITIVES[name])
