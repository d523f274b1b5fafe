"""Enums, and code tables with causes and remedies."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.language.model.enums import Cause, Enum, Member
from fieldspec.targets.docs.context import Context, cited, fact_row, names
from fieldspec.targets.docs.document import (
    Facts,
    Item,
    Line,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import Inferences

VALUES = (
    TableColumn("Value", "number", unbroken=True, search="key"),
    TableColumn("Name", unbroken=True),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
CODES = (
    TableColumn("Code", "number", unbroken=True, search="key"),
    TableColumn("Name", unbroken=True),
    TableColumn("Number", "number", search="key"),
    TableColumn("Problem", "wide"),
    TableColumn("Causes and remedies", "wide"),
    TableColumn("Source", "source"),
)


def codes(context: Context) -> Section:
    """The tables of codes: alarms, faults, exceptions and their like."""
    inner = tuple(_enum(context, enum, CODES, _code) for enum in context.device.enums.values() if enum.kind != "enum")
    return Section("codes", (text_piece("Alarms and other codes"),), (), inner)


def enums(context: Context) -> Section:
    """The section of all enums: their members with numbers, names and meanings."""
    inner = tuple(_enum(context, enum, VALUES, _value) for enum in context.device.enums.values() if enum.kind == "enum")
    return Section("enums", (text_piece("Enums"),), (), inner)


def _enum(
    context: Context,
    enum: Enum,
    columns: tuple[TableColumn, ...],
    row: Callable[[Context, Member, Inferences], TableRow],
) -> Section:
    path = enum.place.path
    blocks = context.opening(enum)
    blocks.append(Facts(tuple(_facts(context, enum))))
    marks = Inferences(path)
    rows = [row(context, member, marks) for member in enum.members]
    title = enum.title or enum.name
    blocks.append(table(title, columns, rows, marks.footnotes(), heading=1))
    heading: Line = (text_piece(enum.title),) if enum.title else (code(enum.name),)
    return Section(path, (*heading, *context.section_title("", enum)[1:]), tuple(blocks))


def _facts(context: Context, enum: Enum) -> list[tuple[str, tuple[Line, ...]]]:
    other = "other values may occur" if enum.open else "no other value is accepted"
    facts: list[tuple[str, tuple[Line, ...]]] = [("Name", ((code(enum.name),),)), ("Others", ((text_piece(other),),))]
    if enum.gaps:
        facts.append(("Left out", ((text_piece(enum.gaps),),)))
    if enum.sparse:
        facts.append(("Left out", ((text_piece("all values that are not listed"),),)))
    if users := context.users(enum.place.path):
        facts.append(("Used by", (users,)))
    if enum.sources:
        facts.append(("Source", (cited(enum.sources),)))
    return facts


def _member_number(member: Member) -> tuple[Line, ...]:
    """The number, in hexadecimal too where that reads otherwise."""
    if member.value <= 9:
        return ((code(str(member.value)),),)
    return (code(str(member.value)),), (styled(f"0x{member.value:02X}", "quiet"),)


def _remarks(member: Member) -> list[Line]:
    """Whether the device has it, and its other names."""
    lines: list[Line] = [(styled("not available", "badge"),)] if member.unavailable else []
    if member.aliases:
        lines.append((text_piece("Also "), *joined((code(alias),) for alias in member.aliases)))
    return lines


def _value(context: Context, member: Member, marks: Inferences) -> TableRow:
    return fact_row(
        member,
        cell(*_member_number(member)),
        names(member, member.name, mark=marks.all_marks(member.inferred)),
        cell(*_remarks(member), *context.about(member)),
    )


def _code(context: Context, member: Member, marks: Inferences) -> TableRow:
    problem: list[Line] = [(text_piece(member.problem),)] if member.problem else []
    causes = [_cause(cause, member) for cause in member.causes]
    causes += [Item((text_piece(remedy),)) for remedy in member.remedies]
    return fact_row(
        member,
        cell(*_member_number(member)),
        names(member, member.name, mark=marks.all_marks(member.inferred)),
        cell("" if member.number is None else str(member.number)),
        cell(*problem, *_remarks(member), *context.about(member)),
        cell(items=causes),
    )


def _cause(cause: Cause, member: Member) -> Item:
    """A cause of a code with its remedies below it, and with its source where that is not the source of the code."""
    elsewhere = cause.sources and cause.sources != member.sources
    place: Line = (styled(" (", "quiet"), *cited(cause.sources), styled(")", "quiet")) if elsewhere else ()
    return Item((styled(cause.cause, "strong"), *place), tuple((text_piece(remedy),) for remedy in cause.remedies))
