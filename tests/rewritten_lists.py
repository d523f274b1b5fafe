"""Exports of random devices, rewritten as people keep such lists, and what of them came back wrong in silence.

The words below are those of vendors' lists, and not those of the importer.
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
import re
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

import openpyxl
from hypothesis import Phase, given, seed
from hypothesis import strategies as st

from fieldspec.cli import main
from fieldspec.command import pipeline
from fieldspec.command.sources import spec_files
from fieldspec.language.diagnostics import has_errors
from fieldspec.tools.lists.export import as_json
from fieldspec.tools.lists.item import items
from random_lists import list_devices
from steady_draws import steady

BATCH = 10

HEADINGS = {
    "space": ("Register type", "Registerart", "Area", "寄存器类型"),
    "address": ("Address", "Register address", "Address (dec)", "Adresse", "Dirección", "地址", "Modbus address"),
    "hex": ("Address (hex)", "Hex", "Adresse (hex)", "十六进制地址"),
    "name": ("Name", "Parameter name", "Bezeichnung", "Signal", "Variable", "名称", "Désignation"),
    "words": ("Words", "Length", "Number of registers", "Anzahl Register", "寄存器数量", "Size (words)"),
    "type": ("Type", "Data type", "Datentyp", "Format", "数据类型"),
    "access": ("Access", "R/W", "Zugriff", "读写", "Accès"),
    "unit": ("Unit", "Units", "Einheit", "单位", "Unité"),
    "scale": ("Scale", "Factor", "Faktor", "Resolution", "Scale factor"),
    "gain": ("Gain",),
    "divisor": ("Divisor", "Teiler"),
    "offset": ("Value offset", "Versatz", "Offset", "偏移量"),
    "min": ("Min", "Minimum", "Lower limit", "最小值"),
    "max": ("Max", "Maximum", "Upper limit", "最大值"),
    "range": ("Range", "Wertebereich", "范围"),
    "default": ("Default", "Factory setting", "Werkseinstellung", "默认值"),
    "const": ("Constant", "Festwert"),
    "values": ("Values", "Enumeration", "Options", "Werte", "枚举"),
    "special": ("Special values",),
    "bits": ("Bits",),
    "order": ("Word order", "Byte order", "Wortreihenfolge", "字序"),
    "printed_name": ("Mnemonic", "Kürzel", "Short name"),
    "number": ("No.", "Nr.", "序号"),
    "label": ("Description", "Beschreibung", "Label", "描述"),
    "bytes": ("Bytes",),
    "count": ("Count", "Elements"),
    "stride": ("Stride",),
    "first": ("First",),
    "subindex": ("Subindex", "Sub-Index", "Sub"),
}
TYPES = {
    "u16": ("u16", "UINT16", "WORD", "Unsigned 16", "uint16_t", "USHORT"),
    "i16": ("i16", "INT16", "INT", "Signed 16", "int16_t", "S16", "SHORT"),
    "u32": ("u32", "UINT32", "DWORD", "UDINT", "unsigned int32", "U32"),
    "i32": ("i32", "INT32", "DINT", "Signed 32", "S32"),
    "u64": ("u64", "UINT64", "ULINT", "LWORD"),
    "i64": ("i64", "INT64", "LINT"),
    "f32": ("f32", "FLOAT32", "REAL", "Float", "IEEE754"),
    "f64": ("f64", "FLOAT64", "LREAL", "Double"),
    "bit": ("bit", "BOOL", "Boolean"),
    "text": ("text", "STRING", "ASCII"),
}
ACCESSES = {
    "ro": ("ro", "R", "RO", "read", "Read only", "nur lesen", "只读"),
    "rw": ("rw", "R/W", "RW", "read/write", "Lesen/Schreiben", "读写"),
    "wo": ("wo", "W", "WO", "write only", "nur schreiben"),
}
AREAS = {
    "registers": ("registers", "Holding Register", "4x", "Holding"),
    "input_registers": ("input_registers", "Input Register", "3x"),
    "coils": ("coils", "Coil", "0x"),
    "discrete_inputs": ("discrete_inputs", "Discrete Input", "1x"),
}
ORDERS = {"CDAB": ("CDAB", "low word first", "LSW first")}


@dataclass
class Rewritten:
    """A list as somebody keeps it: its bytes, its headings by column of the export, and its cells by row.

    `places` are those of the rows of the export, by the numbers of rows in the file, `bits` the rows of their bits.
    """

    content: bytes
    headings: dict[str, str]
    places: dict[int, int] = field(default_factory=dict)
    bits: dict[int, list[int]] = field(default_factory=dict)
    cells: dict[int, dict[str, str]] = field(default_factory=dict)
    is_own: bool = False


def _number(value: object, comma: bool) -> str:
    if not isinstance(value, float):
        return str(value)
    text = f"{value:f}".rstrip("0").rstrip(".")
    return text.replace(".", ",") if comma else text


@st.composite
def rewritten(draw: Any, rows: Sequence[Mapping[str, Any]]) -> Rewritten:
    """A list with the columns of an export renamed, shuffled, split, joined and re-typed."""
    form = draw(st.sampled_from(("csv", "csv", "xlsx", "json")))
    separator = draw(st.sampled_from((",", ";", "\t"))) if form == "csv" else ";"
    if draw(st.integers(0, 9)) == 0:
        return _shuffled(draw, rows, form, separator)
    comma = separator != "," and form != "json" and draw(st.booleans())
    cell_rows = [{key: value for key, value in row.items() if value is not None} for row in rows]
    for row in cell_rows:
        for key in ("section", "line", "unverified", "ucum"):
            row.pop(key, None)
    has_rows_of_bits = draw(st.integers(0, 3)) == 0
    lines = list(_with_rows_of_bits(cell_rows) if has_rows_of_bits else enumerate(cell_rows))
    cell_rows = [row for _, row in lines]
    _retype(draw, cell_rows, comma)
    _join(draw, cell_rows, comma)
    is_numbered = draw(st.integers(0, 3)) == 0
    for number, row in enumerate(cell_rows if is_numbered else (), 1):
        row["number"] = number
    own = draw(st.integers(0, 5)) == 0
    keys = list(dict.fromkeys(key for row in cell_rows for key in row))
    headings = {key: key if own else draw(st.sampled_from(HEADINGS[key])) for key in keys}
    order = list(draw(st.permutations(keys)))
    titles = [["Register list of the device"]] if form != "json" and draw(st.integers(0, 3)) == 0 else []
    cells = [[_number(row[key], comma) if key in row else "" for key in order] for row in cell_rows]
    result = Rewritten(_bytes(form, separator, titles, [headings[key] for key in order], cells), headings)
    for number, (place, row) in enumerate(lines, 2 + len(titles)):
        if place is not None:
            result.places[number] = place
            result.cells[number] = {key: _number(value, comma) for key, value in row.items()}
        else:
            result.bits.setdefault(max(result.places), []).append(number)
    return result


def _shuffled(draw: Any, rows: Sequence[Mapping[str, Any]], form: str, separator: str) -> Rewritten:
    """An export with all its columns, whose columns and rows stand in another order."""
    keys = list(draw(st.permutations(list(rows[0]))))
    places = list(draw(st.permutations(range(len(rows)))))
    cells = [["" if rows[place][key] is None else _number(rows[place][key], False) for key in keys] for place in places]
    content = _bytes(form, separator, [], keys, cells)
    if form == "json":
        content = json.dumps([{key: rows[place][key] for key in keys} for place in places]).encode()
    result = Rewritten(content, {key: key for key in keys}, is_own=True)
    result.places = dict(enumerate(places, 2))
    result.cells = {number: dict(zip(keys, texts, strict=True)) for number, texts in enumerate(cells, 2)}
    return result


def _with_rows_of_bits(rows: Sequence[dict[str, Any]]) -> Iterator[tuple[int | None, dict[str, Any]]]:
    """Each row with its place, and after it those of its bits, which are not rows of the export."""
    for place, row in enumerate(rows):
        bits = str(row.pop("bits", "")) if "count" not in row else ""
        yield place, row
        for part in bits.split("; ") if bits else ():
            number, _, name = part.partition(" ")
            yield None, {"space": row["space"], "address": f"{row['address']}.{number}", "name": name}


def _retype(draw: Any, rows: Sequence[dict[str, Any]], comma: bool) -> None:
    """Spells types, accesses, spaces, orders, values and bits in other words, and addresses in other digits."""
    for key, words in (("type", TYPES), ("access", ACCESSES), ("space", AREAS), ("order", ORDERS)):
        place = draw(st.integers(0, 6))
        for row in rows:
            choices = words.get(row.get(key, ""), ())
            row |= {key: choices[place % len(choices)]} if choices else {}
    has_bits = any("." in str(row["address"]) for row in rows)
    addresses = "decimal" if has_bits else draw(st.sampled_from(("both", "decimal", "hex", "suffix", "0x")))
    digits = draw(st.sampled_from((" ", "=", ": ", " = ")))
    ends = draw(st.sampled_from(("; ", ", ", "\n"))) if digits != " " else "; "
    for row in rows:
        number = row["address"]
        if addresses in ("decimal",):
            row.pop("hex", None)
        elif addresses == "hex":
            row.pop("address")
        elif addresses != "both":
            row.pop("hex")
            row["address"] = f"0x{number:x}" if addresses == "0x" else f"{number:04X}h"
        if "values" in row:
            row["values"] = ends.join(re.sub(r"^(\S+) ", rf"\1{digits}", part) for part in row["values"].split("; "))
        if "bits" in row and digits != " ":
            row["bits"] = ends.join(re.sub(r"^(\S+) ", rf"bit \1{digits}", part) for part in row["bits"].split("; "))


def _join(draw: Any, rows: Sequence[dict[str, Any]], comma: bool) -> None:
    """Puts bounds into one column, scales and units together, units after names, and scales as gains or divisors."""
    if draw(st.booleans()):
        sign = draw(st.sampled_from(("..", " ~ ", " to ")))
        for row in rows:
            if "min" in row and "max" in row:
                row["range"] = f"{row.pop('min')}{sign}{row.pop('max')}"
    way = draw(st.sampled_from(("apart", "apart", "unit with scale", "name with unit", "gain", "divisor", "slash")))
    for row in rows:
        scale, unit = Fraction(str(row.get("scale", 1))), row.get("unit", "")
        if way == "unit with scale" and scale != 1 and unit not in ("", "%"):  # 0.1% is a unit itself
            row["unit"] = f"{_number(row.pop('scale'), comma)} {unit}"
        elif way == "name with unit" and unit:
            row["name"] = f"{row['name']} [{row.pop('unit')}]"
        elif way in ("gain", "divisor", "slash") and scale != 1 and (1 / scale).denominator == 1:
            row.pop("scale")
            row["scale" if way == "slash" else way] = f"/{1 / scale}" if way == "slash" else int(1 / scale)


def _bytes(
    form: str,
    separator: str,
    titles: Sequence[Sequence[str]],
    headings: Sequence[str],
    rows: Sequence[Sequence[str]],
) -> bytes:
    """The file, as CSV, a workbook or JSON."""
    if form == "json":
        objects = [{head: _json_value(cell) for head, cell in zip(headings, row, strict=True) if cell} for row in rows]
        return json.dumps(objects, ensure_ascii=False).encode()
    if form == "csv":
        text = io.StringIO()
        csv.writer(text, delimiter=separator).writerows([*titles, headings, *rows])
        return text.getvalue().encode("utf-8-sig")
    book = openpyxl.Workbook()
    for cells in [*titles, headings, *rows]:
        book.worksheets[0].append([int(cell) if re.fullmatch(r"-?[0-9]{1,15}", cell) else cell for cell in cells])
    buffer = io.BytesIO()
    book.save(buffer)
    return buffer.getvalue()


def _json_value(cell: str) -> object:
    """A number as such, unless it would lose a zero: `6.20` may be bit 20 of 6."""
    return json.loads(cell) if re.fullmatch(r"-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?", cell) else cell


FACTS = ("space", "address", "type", "words", "access", "unit", "scale", "offset", "min", "max", "default", "const")
TEXTS = ("values", "bits", "special", "order")
CELLS = {
    "scale": ("scale", "gain", "divisor", "unit"),
    "unit": ("unit", "name"),
    "min": ("min", "range"),
    "max": ("max", "range"),
    "address": ("address", "hex"),
    "special": ("special",),
}
"""The columns in which a fact may be noted of."""

ASSUMED = {
    "space": r"address space",
    "address": r"addresses",
    "scale": r"multipl|divid",
    "min": "bounds beside a scale",
    "max": "bounds beside a scale",
    "default": "beside a scale",
    "words": "lengths in",
    "bits": "bits: those that are cell_rows",
}


@dataclass
class Outcome:
    """What came back: of how many lists, how many facts are right, and which are wrong, noted or in silence."""

    lists: int = 0
    right: int = 0
    noted: list[str] = field(default_factory=list)
    silent: list[str] = field(default_factory=list)


def judged(
    rows: Sequence[Mapping[str, Any]], again: Sequence[Mapping[str, Any]], file: Rewritten, report: str, spec: str
) -> Outcome:
    """The facts of an export, compared with those of the export of what was imported."""
    outcome = Outcome()
    by_line: dict[int, Mapping[str, Any]] = {}
    counts = Counter(row["line"] for row in again)
    places = {(row["space"], row["address"], row["name"]): row for row in again}
    for row in again:
        by_line.setdefault(row["line"], row)
    refused = {int(number) for number in re.findall(r"(?:not used: |# )row (\d+)", report + spec)}
    unused = ", ".join(re.findall(r"columns not used(?: as facts but keys as notes)?: (.*)", report))
    notes = "\n".join(line for line in spec.splitlines() if "notes:" in line)
    for number, place in file.places.items():
        before = rows[place]
        after = by_line.get(number)
        if file.is_own:
            after = places.get((before["space"], before["address"], before["name"]))
        if after is None:
            (outcome.noted if number in refused else outcome.silent).append(f"row {number} is missing")
            continue
        cells = file.cells[number]
        if not file.is_own and after["count"] is None and counts[number] != (before["count"] or 1):
            outcome.silent.append(f"row {number} count: {before['count']} became {counts[number]}")
        for fact in before if file.is_own else (*FACTS, *TEXTS, "name"):
            if _same(fact, before, after, cells):
                outcome.right += 1
                continue
            columns = [key for key in CELLS.get(fact, (fact,)) if key in cells]
            mark = rf"\bname: {before['name']}\b" if file.is_own else rf"\bL{number}\b"
            own = [line for line in notes.splitlines() if re.search(mark, line)]
            has_message = (
                number in refused
                or (fact == "bits" and not refused.isdisjoint(file.bits.get(number, ())))
                or any(cells[key] in line or json.dumps(cells[key])[1:-1] in line for key in columns for line in own)
                or any(file.headings[key] in unused for key in columns)
                or (fact in ASSUMED and re.search(f"assumed: .*{ASSUMED[fact]}", report) is not None)
            )
            text = f"row {number} {fact}: {before.get(fact)} became {after.get(fact)}; cells {cells}"
            (outcome.noted if has_message else outcome.silent).append(text)
    return outcome


def _same(fact: str, before: Mapping[str, Any], after: Mapping[str, Any], cells: Mapping[str, str]) -> bool:
    ours, theirs = before.get(fact), after.get(fact)
    if fact == "name" and ours != theirs:
        number = f"_{before['first'] or 0}" if before["count"] else ""
        is_named = after["name"] == before["name"].replace(".", "_") + number
        return is_named or cells["name"] in (after["printed_name"], after["label"])
    if fact in TEXTS:
        return sorted((ours or "").split("; ")) == sorted((theirs or "").split("; "))
    if fact in ("scale", "offset"):
        ours, theirs = ours or int(fact == "scale"), theirs or int(fact == "scale")
        return Fraction(str(ours)) == Fraction(str(theirs)) if isinstance(theirs, int | float) else False
    return bool(ours == theirs)


def exported(text: str) -> Any:
    """The export of the newest version of a device, by the text of its spec."""
    project = pipeline.load(spec_files.with_protocols({"chance/device.yaml": text.encode()}))
    assert not has_errors(project.findings), project.findings
    return json.loads(as_json(items(pipeline.layouts(project.devices["chance"])[-1])))


def imported(content: bytes, folder: Path) -> tuple[int, str, str]:
    """The exit code of an import, the spec, and what it says."""
    (folder / "list").write_bytes(content)
    (folder / "specs").mkdir(exist_ok=True)
    spec, report = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(spec), contextlib.redirect_stderr(report):
        code = main(["import", str(folder / "list"), "--to", "-", "--specs", str(folder / "specs")])
    return code, spec.getvalue().replace("  id: device", "  id: chance", 1), report.getvalue()


def came_back(first: int, seconds: float, most: int) -> Outcome:
    """What comes back of so many random lists, or of those that take so many seconds of a processor, by seeds."""
    total = Outcome()
    end = time.process_time() + seconds
    number = first
    while time.process_time() < end and total.lists < most:
        _draw(number, total)
        number += 1
    return total


def _draw(number: int, total: Outcome) -> None:
    @steady(BATCH, Phase.generate)
    @seed(number)
    @given(st.data())
    def each(data: st.DataObject) -> None:
        rows = exported(data.draw(list_devices()))
        file = data.draw(rewritten(rows))
        with tempfile.TemporaryDirectory() as folder:
            code, spec, report = imported(file.content, Path(folder))
        total.lists += 1
        if code:
            (total.noted if "leaves open" in report or "two readings" in report else total.silent).append(report)
            return
        outcome = judged(rows, exported(spec), file, report, spec)
        total.right += outcome.right
        total.noted += outcome.noted
        total.silent += outcome.silent

    each()


if __name__ == "__main__":
    total = came_back(int(sys.argv[2]), float(sys.argv[1]), 1 << 20)
    print("\n".join(dict.fromkeys(total.silent)))
    print(f"{total.lists} lists: {total.right} facts are right, {len(total.noted)} noted, {len(total.silent)} silent")
