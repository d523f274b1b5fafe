"""A row of the table of facts, and the rows of a fact of any kind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal
from typing import TypeAlias

from fieldspec.foundation.caches import ByIdentity
from fieldspec.language.model.fact import PRINTED, REPORTED, STANDARD, Citation, Claim, Fact, Report
from fieldspec.language.model.ranges import Ranges, intervals
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.value import Value, exact_scale

COLUMNS = (
    "kind",
    "path",
    "code",
    "address",
    "words",
    "bytes",
    "bit",
    "name",
    "printed_name",
    "label",
    "type",
    "access",
    "unit",
    "scale",
    "min",
    "max",
    "ranges",
    "default",
    "const",
    "section",
    "line",
    "printed",
    "errata",
    "number",
    "count",
    "position",
    "direction",
    "restart",
    "unverified",
    "sources",
    "write_ranges",
    "provenance",
    "inferred",
    "standard",
    "evidence",
    "roles",
)

Cell: TypeAlias = int | Decimal | str | list[str] | dict[str, object] | None
FactRow: TypeAlias = dict[str, Cell]

_BLANK: FactRow = dict.fromkeys(COLUMNS)

# Keys of claims, with the columns of what they state.
_CLAIMED = {
    "at": "address",
    "words": "words",
    "length": "bytes",
    "bit": "bit",
    "code": "code",
    "refusal_code": "code",
    "printed_name": "printed_name",
    "label": "label",
    "type": "type",
    "access": "access",
    "unit": "unit",
    "scale": "scale",
    "default": "default",
    "range": "ranges",
    "repeat": "ranges",
    "enum_values": "ranges",
    "count": "ranges",
    "decimal": "address",
    "wire_number": "number",
    "span": "position",
    "word_span": "position",
}


class SharedRows:
    """The rows of objects of the model. Versions that share an object share its rows."""

    def __init__(self) -> None:
        self._rows: ByIdentity[object, dict[int, list[FactRow]]] = ByIdentity()

    def rows(self, item: object, compute: Callable[[], Iterable[FactRow]], base: int = 0) -> list[FactRow]:
        """The rows of an object. `base` is a number that they depend on as well."""
        by_base = self._rows.get_or_compute(item, lambda _: {})
        if base not in by_base:
            by_base[base] = list(compute())
        return by_base[base]


def row(kind: str, path: str, sources: Iterable[Citation], **cells: Cell) -> FactRow:
    """A row with the first of its sources. Cells of empty text stay empty."""
    result_row = _BLANK.copy()
    result_row["kind"], result_row["path"], result_row["errata"] = kind, path, []
    cited = tuple(sources)
    if cited:
        text = "; ".join(citation.text() for citation in cited)
        result_row.update(section=cited[0].section or None, line=cited[0].line(), sources=text, provenance=PRINTED)
    for key, cell in cells.items():
        if cell is not None and cell != "":
            result_row[key] = cell
    return result_row


def of_fact(kind: str, fact: Fact, value: Value | None = None, **cells: Cell) -> Iterator[FactRow]:
    """The row of a fact, one for each place of the manual that restates it, and for its special values."""
    known: FactRow = {key: cells[key] for key in ("code", "bit", "direction") if key in cells}
    known |= {"unverified": of_flag(fact.unverified or None)}
    known |= {"name": fact.name, "printed_name": fact.printed_name, "label": fact.label}
    yield row(kind, fact.place.path, fact.sources, **{**known, **of_value(value), **_implied(fact), **cells})
    for claim in fact.restated:
        yield _restated(kind, value, claim, known, "code" if isinstance(fact, Message | Parameter) else "number")
    for report in fact.reported:
        yield _reported(kind, value, report, known)
    for number, sentinel in enumerate(value.sentinels if value else ()):
        path = f"{fact.place.path}/sentinels/{number}"
        code: Cell = sentinel.text if sentinel.is_nan or sentinel.last is not None else sentinel.value
        yield row("sentinel", path, sentinel.sources or fact.sources, code=code, name=sentinel.name)


def _implied(fact: Fact) -> FactRow:
    """The keys of a fact that the manual does not print, with the reasons, and with the standards that give them."""
    cells: FactRow = {"roles": ", ".join(fact.roles)}
    if fact.inferred:
        cells["inferred"] = dict(fact.inferred)
    if fact.standard:
        cells["standard"] = {key: standard.text() for key, standard in fact.standard.items()}
        if not fact.sources:
            cells["provenance"] = STANDARD
    return cells


def _reported(kind: str, value: Value | None, report: Report, known: FactRow) -> FactRow:
    """The row of a report: what makes the fact known, what others say of it, and who. It has no place in the manual."""
    cells = _restated(kind, value, Claim(report.place, (), report.values), known, "number")
    return {**cells, "provenance": REPORTED, "evidence": f"{report.by}: {report.how}"}


def of_value(value: Value | None) -> FactRow:
    """The cells of a value. Bounds, defaults and constants are raw values."""
    if value is None:
        return {}
    return {
        "type": value.type.name,
        "bytes": value.size,
        "unit": value.quantity_unit,
        "scale": f"10^{value.scale_by}" if value.scale_by else value.scale_number if value.scaled else None,
        "default": value.default,
        "const": value.const,
        **of_ranges(value.ranges),
        "write_ranges": value.write_ranges.text() if value.write_ranges is not None else None,
    }


def of_flag(flag: bool | None) -> str:
    """A truth value as a cell: `yes`, `no`, or empty for None."""
    return "" if flag is None else "yes" if flag else "no"


def of_ranges(ranges: Ranges | None) -> FactRow:
    """The cells of the least value, the greatest, and all intervals."""
    return {} if ranges is None else {"min": ranges.low, "max": ranges.high, "ranges": ranges.text()}


def _restated(kind: str, value: Value | None, claim: Claim, known: FactRow, number: str) -> FactRow:
    """The row of a claim: the cells that identify the fact, and what the claim states.

    `number` is the column of the claim's `number`.
    """
    cells = dict(known)
    for key, stated in claim.values.items():
        if key == "scale" and isinstance(stated, str):
            scale = exact_scale(stated)
            cells["scale"] = scale if isinstance(scale, Decimal) else stated
        elif key in _CLAIMED and stated is not None and not isinstance(stated, bool):
            cells[_CLAIMED[key]] = str(stated) if _CLAIMED[key] == "ranges" else stated
            if key == "range":
                cells.update(_bounds(str(stated), None))
            if key == "count":
                cells["count"] = stated
        elif key == "value" and isinstance(stated, int | Decimal):
            cells.update(
                {"code": stated} if isinstance(stated, int) and "code" in known else {"min": stated, "max": stated}
            )
        elif key == "number" and isinstance(stated, int):
            cells[number] = stated
        elif key == "restart" and isinstance(stated, bool):
            cells["restart"] = of_flag(stated)
        elif key == "unit_range" and value is not None:
            cells.update(_bounds(str(stated), value))
        elif key == "unit_default" and value is not None and isinstance(stated, int | Decimal):
            cells["default"] = value.from_unit(Decimal(stated))
    return row(kind, claim.place.path, claim.sources, **cells)


def _bounds(text: str, value: Value | None) -> FactRow:
    """The cells of intervals; with a `value`, of intervals of quantities, as raw values."""
    pairs = intervals(text)
    if value is not None:
        counts = [(value.from_unit(low), value.from_unit(high)) for low, high in pairs]
    else:
        counts = [(_whole(low), _whole(high)) for low, high in pairs]
    whole = tuple((low, high) for low, high in counts if low is not None and high is not None)
    return of_ranges(Ranges(whole)) if len(whole) == len(counts) else {"ranges": text}


def _whole(number: Decimal) -> int | None:
    """A whole number as an int; None for others."""
    return int(number) if number == int(number) else None
