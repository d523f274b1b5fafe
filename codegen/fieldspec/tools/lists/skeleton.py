"""Writes the first spec of a device from a register list."""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.primitives import PRIMITIVES, Kind
from fieldspec.language.model.units import standard_units
from fieldspec.language.schema import schema
from fieldspec.tools.lists.column_roles import folded
from fieldspec.tools.lists.exponents import bounds, exponents, is_open
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.listing import ListRow
from fieldspec.tools.lists.sheet import ListError

_NAME = schema()["$defs"]["name"]
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")
_ASIDE = re.compile(r"\([^()]*\)|\[[^\[\]]*\]")
_LONGEST = 48


def named(texts: Iterable[str], address: int) -> str:
    """A name from the first text in English, `register_2000` if there is none."""
    for text in texts:
        name = snake(text)
        if name:
            return name
    return f"register_{address:04x}"


def snake(text: str) -> str:
    """`Target Position (0.01 mm)` as `target_position`; empty if the words are not English."""
    ascii_text = unicodedata.normalize("NFKD", _ASIDE.sub(" ", text))
    ascii_text = "".join(sign for sign in ascii_text if not unicodedata.combining(sign))
    if any(sign.isalpha() and not sign.isascii() for sign in ascii_text):
        return ""
    name = ""
    for word in _WORD.findall(ascii_text):
        longer = f"{name}_{word}".strip("_").lower()
        if len(longer) > _LONGEST:
            break
        name = longer
    return name if re.fullmatch(_NAME["pattern"], name) and len(name) > 1 else ""


_MOST_WORDS = 1 << 20
_BY_WORDS = {1: "u16", 2: "u32", 4: "u64"}
_UNITS = {
    folded(symbol) or symbol: unit.symbol
    for unit in reversed(standard_units().values())
    for symbol in (*unit.others, unit.symbol)
}
_BARE_SCALAR = re.compile(r"[A-Za-z][A-Za-z0-9_./-]*")

_HEAD = """\
# Written from a list, and not verified. Compare each row with the manual, cite its section and line as the source, and
# take `unverified` away. Then put the manual's own title, file and hash below, and add how frames look: `fieldspec new
# device` shows it.
"""


@dataclass(frozen=True, slots=True)
class Origin:
    """The file of a list, its hash and its number of lines."""

    file: str
    sha256: str
    lines: int


@dataclass(frozen=True, slots=True)
class _Shape:
    type: str
    words: int
    doubts: tuple[str, ...]
    inferred: bool


def skeleton(device: str, origin: Origin, rows: Sequence[ListRow]) -> str:
    """The text of a spec file. Raises ListError for two rows about one word, and for spaces other than registers."""
    other = next((row for row in rows if folded(row.texts.get("space", "")) not in ("", REGISTERS)), None)
    if other is not None:
        space = other.texts["space"]
        raise ListError(f"has the space {space} in row {other.row}; only a list of registers can be imported")
    shapes = [_shape(row) for row in rows]
    _refuse_overlaps(rows, shapes)
    lines = [_HEAD + "device:"]
    lines += [f"  id: {device}", f"  name: {device}", "  vendor: unknown"]
    title = f"The list {origin.file}"
    lines += ["  manual:", f"    title: {_quoted(title)}", f"    file: {_quoted(origin.file)}"]
    lines += [f'    sha256: "{origin.sha256}"', f"    lines: {origin.lines}", ""]
    lines += ["registers:", "  - group: listed", '    section: "1"', "    unverified: true"]
    addresses = [row.address for row in rows]
    if addresses == sorted(set(addresses)):
        lines += _gaps(rows, shapes)
    else:
        lines.append("    order: as_listed")
    lines.append("    rows:")
    used_names: set[str] = set()
    names = [_fresh(named(row.names, row.address), row.address, used_names) for row in rows]
    scaled = exponents(rows, [shape.type for shape in shapes])
    labels: set[str] = set()
    for place, (row, shape) in enumerate(zip(rows, shapes, strict=True)):
        scale_by = names[scaled[place]] if place in scaled else ""
        lines.append(_register_line(row, shape, names[place], scale_by, place in scaled.values(), labels))
    return "\n".join(lines) + "\n"


def _shape(row: ListRow) -> _Shape:
    """The type and the words of a register. If the list contradicts itself, its words count."""
    known = row.type.of_words(row.words) if row.type else ""
    if not known:
        known = _BY_WORDS.get(row.words or 1, "bytes")
        if row.low is not None and row.low < 0 and known != "bytes":
            known = known.replace("u", "i")
    size = PRIMITIVES[known].size
    if not size:
        return _Shape(known, row.words or 1, (), row.type is None)
    if row.words is None or row.words == (size + 1) // 2:
        return _Shape(known, (size + 1) // 2, (), row.type is None)
    doubt = f"The list says {row.texts.get('type', known)}, and {row.words} words."
    return _Shape(_BY_WORDS.get(row.words, "bytes"), row.words, (doubt,), False)


def _refuse_overlaps(rows: Sequence[ListRow], shapes: Sequence[_Shape]) -> None:
    rows_by_address: dict[int, int] = {}
    twice: list[tuple[int, int, int]] = []
    for row, shape in zip(rows, shapes, strict=True):
        stride = row.stride or shape.words
        if len(rows_by_address) + row.count * shape.words > _MOST_WORDS:
            raise ListError(f"has more words than a device, up to row {row.row}")
        for address in (row.address + n * stride + word for n in range(row.count) for word in range(shape.words)):
            first = rows_by_address.setdefault(address, row.row)
            if first != row.row and (not twice or twice[-1][1] != row.row):
                twice.append((first, row.row, address))
    if twice:
        rows_text = "; ".join(f"rows {a} and {b} hold 0x{address:04X}" for a, b, address in twice[:5])
        rest_text = f"; and {len(twice) - 5} more" if len(twice) > 5 else ""
        raise ListError(f"has two rows about the same word: {rows_text}{rest_text}; correct their addresses or words")


def _gaps(rows: Sequence[ListRow], shapes: Sequence[_Shape]) -> Iterator[str]:
    """The lines of the gaps between the first register and the last. The rows ascend."""
    gaps = []
    end = rows[0].address
    for row, shape in zip(rows, shapes, strict=True):
        if row.address > end:
            gaps.append((end, row.address - 1))
        end = max(end, row.address + (row.count - 1) * (row.stride or shape.words) + shape.words)
    if gaps:
        yield "    gaps:"
    for low, high in gaps:
        address_text = f"0x{low:04X}" if low == high else f"0x{low:04X}..0x{high:04X}"
        yield f"      - {{at: {address_text}, reason: The list leaves them out.}}"


def _register_line(row: ListRow, shape: _Shape, name: str, scale_by: str, is_exponent: bool, labels: set[str]) -> str:
    """The line of a register; `scale_by` is the name of the register with the exponent of its scale, or empty."""
    texts = row.texts
    doubts = list(shape.doubts)
    kind = PRIMITIVES[shape.type]
    inferred = {"type": "The list does not say it."} if shape.inferred else {}
    if is_exponent and is_open(row):
        low, high = bounds(row)
        row = replace(row, low=low, high=high)
        inferred["range"] = "The list does not say it; that of SunSpec is taken."
    parts = [f"at: 0x{row.address:04X}", f"name: {_quoted(name)}", f"type: {shape.type}", f"words: {shape.words}"]
    if row.count > 1:
        parts += [f"count: {row.count}", f"stride: {row.stride or shape.words}"]
    if row.access:
        parts.append(f"access: {row.access}")
    elif "access" in texts:
        doubts.append(f"Access in the list: {texts['access']}.")
    unit = texts.get("unit", "")
    if unit:
        known = _UNITS.get(folded(unit) or unit)
        parts += [f"unit: {_quoted(known)}"] if known else []
        doubts += [] if known else [f"Unit in the list: {unit}."]
    parts += [f"scale_by: {_quoted(scale_by)}"] if scale_by else []
    parts += _numbers(row, kind.kind is Kind.INTEGER, kind.low, kind.high, bool(scale_by), doubts)
    parts += _words(row, name, labels)
    if "type" in texts and row.type is None:
        doubts.append(f"Type in the list: {texts['type']}.")
    if inferred:
        parts.append(f"inferred: {{{', '.join(f'{key}: {reason}' for key, reason in inferred.items())}}}")
    if doubts:
        parts.append(f"notes: [{', '.join(map(_quoted, doubts))}]")
    parts += [f"source: L{row.row}", "unverified: true"]
    return f"      - {{{', '.join(parts)}}}"


def _numbers(
    row: ListRow, is_integer: bool, lowest: int, highest: int, has_exponent: bool, doubts: list[str]
) -> list[str]:
    """Scale, range, default and constant, if they are whole counts of the type; else they become doubts."""
    texts, parts = row.texts, []
    scale = _decimal(texts.get("scale", ""))
    if has_exponent:
        pass
    elif scale is not None and scale > 0 and is_integer:
        parts += [f"scale: {scale:f}"] if scale != 1 else []
    elif "scale" in texts:
        doubts.append(f"Scale in the list: {texts['scale']}.")
    low, high = row.low, row.high
    ranged = low is not None and high is not None and is_integer and _counts(low, high, lowest, highest)
    if ranged:
        parts.append(f"range: {low:f}..{high:f}")
    else:
        unread = {"Least value": texts.get("min"), "Greatest value": texts.get("max"), "Range": texts.get("range")}
        doubts += [f"{heading} in the list: {text}." for heading, text in unread.items() if text]
    permitted = (low, high) if ranged and low is not None and high is not None else (lowest, highest)
    for key, word, number in (("default", "Default", row.default), ("const", "Constant", row.const)):
        if key in texts and number is not None and is_integer and _counts(number, number, *permitted):
            parts.append(f"{key}: {number:f}")
        elif key in texts:
            doubts.append(f"{word} in the list: {texts[key]}.")
    return parts


def _counts(low: Decimal, high: Decimal, lowest: Decimal | int, highest: Decimal | int) -> bool:
    """Whether two numbers are whole, in order, and fit a type."""
    whole = low == low.to_integral_value() and high == high.to_integral_value()
    return whole and lowest <= low <= high <= highest


def _words(row: ListRow, name: str, labels: set[str]) -> Iterator[str]:
    """The printed name and the label of a register, with the allowances that two equal ones or a broken one need."""
    texts = row.texts
    printed = texts.get("printed_name", "") or texts.get("name", "")
    label = texts.get("label", "")
    allowed = []
    if "_" in printed and len(printed.split()) > 1 and printed != name:
        allowed.append("printed_names_whole: The list has it so.")
    is_repeated = False
    for key, text in (("printed_name", printed), ("label", label)):
        if text and text != name:
            is_repeated |= f"{key} {text}" in labels
            labels.add(f"{key} {text}")
            yield f"{key}: {_quoted(text)}"
    if is_repeated:
        allowed.append("labels_unique: The list has it twice.")
    if allowed:
        yield f"allow: {{{', '.join(allowed)}}}"


def _fresh(name: str, address: int, names: set[str]) -> str:
    """A name that no other register has, which is added to `names`."""
    fresh_name, number = name, 1
    while fresh_name in names:
        fresh_name = f"{name}_{address:04x}" if number == 1 else f"{name}_{address:04x}_{number}"
        number += 1
    names.add(fresh_name)
    return fresh_name


def _decimal(text: str) -> Decimal | None:
    if re.fullmatch(r"[0-9]{1,12}(\.[0-9]{1,12})?", text):
        return Decimal(text)
    return None


def _quoted(text: str) -> str:
    """A text as YAML writes it within brackets, without quotes if it is a word."""
    if _BARE_SCALAR.fullmatch(text) and text.casefold() not in (
        "true",
        "false",
        "yes",
        "no",
        "on",
        "off",
        "null",
        "y",
        "n",
    ):
        return text
    escaped = (sign if sign.isprintable() or sign == " " else f"\\U{ord(sign):08X}" for sign in text)
    return '"' + "".join(json.dumps(sign)[1:-1] if sign in '"\\' else sign for sign in escaped) + '"'
