"""Signals, where they lie, and how shares of a reference become quantities."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, cited, names, sources
from fieldspec.backends.docs.document import Cell, Column, Facts, Line, Row, Section, cell, code, joined, plain, table
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.backends.docs.value_cells import VALUE_COLUMNS, meaning_cell, value_cells
from fieldspec.model.signal import Conversion, Signal

COLUMNS = (
    Column("Name", kept=True),
    Column("Direction", "short"),
    *VALUE_COLUMNS,
    Column("Lies in"),
    Column("Meaning", "wide"),
    Column("Source", "source"),
)
DIRECTIONS = {"request": "to the device", "response": "from the device", "": ""}


def signals(context: Context) -> Section:
    """All signals in a table."""
    device = context.device
    marks = Inferences("signals")
    rows = [_signal(context, signal, marks) for signal in device.signals.values()]
    blocks = (table("Signals", COLUMNS, rows, marks.footnotes()),) if rows else ()
    return Section("signals", (plain("Signals"),), blocks)


def _signal(context: Context, signal: Signal, marks: Inferences) -> Row:
    kind, unit, bounds = value_cells(signal.value, signal.inferred, marks)
    return Row(
        (
            names(signal, signal.name, mark=marks.marks(signal.inferred)),
            cell(DIRECTIONS[signal.direction]),
            kind,
            unit,
            bounds,
            _lies_in(context, signal),
            meaning_cell(context, signal, signal.value, *_converted(context, signal)),
            sources(signal),
        ),
        signal.place.path,
    )


def _lies_in(context: Context, signal: Signal) -> Cell:
    """The messages that have a signal."""
    found = [
        message
        for message in context.device.messages.values()
        if any(field.signal == signal.name for field in (*message.request.fields, *message.response.fields))
    ]
    return cell(joined((code(message.name, f"#messages/{message.name}"),) for message in found))


def _converted(context: Context, signal: Signal) -> Iterator[Line]:
    for conversion in context.device.conversions.values():
        if signal.name in conversion.signals:
            yield (plain("Converted by "), code(conversion.name, f"#conversions/{conversion.name}"))


def conversions(context: Context) -> Section:
    """All conversions, one after the other."""
    inner = tuple(_conversion(context, conversion) for conversion in context.device.conversions.values())
    return Section("conversions", (plain("Conversions"),), (), inner)


def _conversion(context: Context, conversion: Conversion) -> Section:
    share = f"count / {conversion.full_scale}"
    formula = f"reference * (1 - {share})" if conversion.complement else f"reference * {share}"
    rows: list[tuple[str, tuple[Line, ...]]] = [("Formula", ((code(f"{conversion.name} = {formula}"),),))]
    rows.append(("Whole reference", ((code(f"0x{conversion.full_scale:X}"), plain(f" ({conversion.full_scale})")),)))
    rows.append(("Type of the count", ((code(conversion.type.name),),)))
    if conversion.signals:
        links = joined((code(name, f"#signals/{name}"),) for name in conversion.signals)
        rows.append(("Count", (links,)))
    if conversion.references:
        rows.append(("Reference", (joined((context.link_to(path),) for path in conversion.references),)))
    if conversion.printed:
        rows.append(("As printed", ((code(conversion.printed),),)))
    if conversion.sources:
        rows.append(("Source", (cited(conversion.sources),)))
    title = context.section_title(conversion.title or conversion.name, conversion)
    return Section(conversion.place.path, title, (*context.opening(conversion), Facts(tuple(rows))))
