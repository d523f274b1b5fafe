"""The ledger of errata: the differences between the spec and the manual, the worst effect first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal

from fieldspec.codec.explain.values import decimal_text, range_in_unit
from fieldspec.language.changes.evidence import value_text
from fieldspec.language.model.enums import Bit, Enum, Member
from fieldspec.language.model.fact import Claim
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.registers import PrintedElement, Register, Table
from fieldspec.language.model.texts import Erratum, Example
from fieldspec.language.model.value import Value
from fieldspec.targets.docs.context import Context, address, cited
from fieldspec.targets.docs.document import (
    Cell,
    Line,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    label,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import Holder

COLUMNS = (
    TableColumn("Erratum and fact", "path", unbroken=True),
    TableColumn("Printed", "path", unbroken=True),
    TableColumn("Used here", "path", unbroken=True),
    TableColumn("Reason", "wide", unbroken=True),
    TableColumn("Confidence and verdict", "proof", unbroken=True),
    TableColumn("Source", "source"),
)
EFFECTS = {
    "bytes": ("Wrong bytes", "A reader who trusts the manual gets wrong bytes."),
    "range": ("Wrong range", "A reader who trusts the manual gets a wrong range."),
    "name": ("Wrong name", "A reader who trusts the manual gets a wrong name."),
    "ambiguous": ("Ambiguous", "A reader who trusts the manual cannot decide."),
}
VERDICTS = ("proven", "judgement", "open")
COUNTS = (
    TableColumn("Effect", unbroken=True),
    TableColumn("Errata", unbroken=True),
    *(TableColumn(verdict.capitalize(), unbroken=True) for verdict in VERDICTS),
)
INTRODUCTION = (
    "The printed values, and the values that are used instead. Proven: the named check fails when the printed value is "
    "put back. The compiler verifies this at every build, and writes nothing if the check passes. A judgement "
    "is the decision of a person. An open question is decided neither by the manual nor by a person."
)


def errata(context: Context) -> Section:
    """The section of all errata: where the spec departs from what the manual prints."""
    device = context.device
    if not device.errata:
        return Section("errata", (text_piece("Errata"),))
    blocks = (Paragraph((text_piece(INTRODUCTION),)), table("Errata by effect", COUNTS, _counts(device.errata)))
    parts = tuple(_of_effect(context, effect) for effect in EFFECTS)
    return Section(
        "errata", (text_piece("Errata of the manual"),), blocks, tuple(part for part in parts if part.blocks)
    )


def _counts(errata_of_device: Sequence[Erratum]) -> Iterator[TableRow]:
    counts = Counter((erratum.effect, erratum.verdict) for erratum in errata_of_device)
    for effect, (title, _) in EFFECTS.items():
        numbers = [counts[effect, verdict] for verdict in VERDICTS]
        if any(numbers):
            yield TableRow(
                (
                    cell(text_piece(title, f"#errata-{effect}")),
                    *(cell(str(count)) for count in (sum(numbers), *numbers)),
                )
            )


def _of_effect(context: Context, effect: str) -> Section:
    title, meaning = EFFECTS[effect]
    rows = [_erratum_row(context, erratum) for erratum in context.device.errata if erratum.effect == effect]
    blocks = (Paragraph((text_piece(meaning),)), table(title, COLUMNS, rows)) if rows else ()
    return Section(f"errata-{effect}", (text_piece(title),), blocks)


def _erratum_row(context: Context, erratum: Erratum) -> TableRow:
    holder = context.holders.get(erratum.fact)
    keys = list(erratum.printed)
    style = "open" if erratum.confidence == "open" else ""
    return TableRow(
        (
            cell(
                (code(erratum.id),),
                (context.link_to(erratum.fact),),
                *context.holding.badges(erratum.place.path),
            ),
            _both_values([(key, _printed(key, erratum.printed[key])) for key in keys], (label(erratum.literal),)),
            _both_values([(key, _spec_value(holder, key)) for key in keys], ()),
            cell(erratum.reason),
            cell(
                styled(erratum.confidence, style),
                (styled("Proven: ", "quiet"), code(erratum.proof)) if erratum.verdict == "proven" else erratum.verdict,
            ),
            cell(cited(erratum.sources)),
        ),
        f"errata/{erratum.id}",
    )


def _both_values(pairs: list[tuple[str, str]], last: Line) -> Cell:
    lines: list[Line] = [
        (styled(f"{key}: ", "quiet"), code(text) if text else text_piece("nothing")) for key, text in pairs
    ]
    return cell(*lines, last)


def _printed(key: str, value: object) -> str:
    if key == "present":
        return "missing"
    if key in ("at", "base") and isinstance(value, int):
        return address(value)
    return _value_text(value)


def _value_text(value: object) -> str:
    """Any value of a spec as text."""
    if isinstance(value, Decimal):
        return f"{value:f}"
    if isinstance(value, Mapping):
        return ", ".join(f"{key} {_value_text(inner)}" for key, inner in value.items())
    if isinstance(value, list | tuple):
        return ", ".join(_value_text(inner) for inner in value)
    return value_text(value)


def _spec_value(holder: Holder | None, key: str) -> str:
    """The value of a key in the spec, empty without one."""
    if key == "present":
        return "belongs there"
    if isinstance(holder, Claim):
        return _printed(key, holder.values.get(key))
    for kind, getters in GETTERS:
        if isinstance(holder, kind) and key in getters:
            return _value_text(getters[key](holder))
    value = getattr(holder, "value", None)
    if isinstance(value, Value) and key in OF_VALUES:
        return _value_text(OF_VALUES[key](value))
    attribute = getattr(holder, key, None)
    return "" if callable(attribute) else _value_text(attribute)


def _span(bounds: tuple[int, int] | None) -> str:
    if bounds is None:
        return ""
    first, last = bounds
    return str(first) if first == last else f"{first}-{last}"


def _elements(element: PrintedElement) -> Iterator[str]:
    yield from (address(bound) for bound in (element.first, element.last) if bound is not None)


# How the model holds what the language calls by another name.
OF_VALUES: dict[str, Callable[[Value], object]] = {
    "type": lambda value: value.type.name,
    "length": lambda value: value.size,
    "characters": lambda value: value.characters,
    "byte_order": lambda value: value.byte_order,
    "scale": lambda value: value.scale_number,
    "offset": lambda value: value.offset,
    "unit": lambda value: value.quantity_unit,
    "range": lambda value: value.ranges,
    "unit_range": lambda value: value.ranges and range_in_unit(value, value.ranges),
    "default": lambda value: value.default,
    "unit_default": lambda value: (
        decimal_text(value.in_unit(value.default), value.scale) if isinstance(value.default, int) else value.default
    ),
    "const": lambda value: value.const,
    "enum": lambda value: value.enum,
    "flags": lambda value: value.flags,
}
GETTERS: tuple[tuple[type, dict[str, Callable[..., object]]], ...] = (
    (Register, {"at": lambda r: address(r.address), "words": lambda r: r.width, "decimal": lambda r: r.address}),
    (Table, {"base": lambda t: address(t.base), "decimal": lambda t: t.base}),
    (PrintedElement, {"at": lambda e: "..".join(_elements(e))}),
    (Field, {"at": lambda f: None if f.at is None else address(f.at), "span": lambda f: _span(f.span)}),
    (Bit, {"bit": lambda b: b.first, "bits": lambda b: b.number_text}),
    (Member, {"value": lambda m: m.value}),
    (Enum, {"gaps": lambda e: e.gaps}),
    (Message, {"code": lambda m: m.code}),
    (Example, {"frame": lambda e: e.frame, "values": lambda e: e.values}),
)
