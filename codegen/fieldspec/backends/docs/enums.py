"""Enums, and tables of codes with causes and remedies."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.backends.docs.context import Context, cited, names, sources
from fieldspec.backends.docs.document import (
    Column,
    Facts,
    Item,
    Line,
    Row,
    Section,
    cell,
    code,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.model.enum import Cause, Enum, Member

VALUES = (
    Column("Value", "number", kept=True),
    Column("Name", kept=True),
    Column("Meaning", "wide"),
    Column("Source", "source"),
)
CODES = (
    Column("Code", "number", kept=True),
    Column("Name", kept=True),
    Column("Number", "number"),
    Column("Problem", "wide"),
    Column("Causes and remedies", "wide"),
    Column("Source", "source"),
)


def codes(context: Context) -> Section:
    """The tables of codes: alarms, faults, exceptions and their like."""
    inner = tuple(_enum(context, enum, CODES, _code) for enum in context.device.enums.values() if enum.kind != "enum")
    return Section("codes", (plain("Alarms and other codes"),), (), inner)


def enums(context: Context) -> Section:
    """The values of fields by name."""
    inner = tuple(_enum(context, enum, VALUES, _value) for enum in context.device.enums.values() if enum.kind == "enum")
    return Section("enums", (plain("Values by name"),), (), inner)


def _enum(
    context: Context, enum: Enum, columns: tuple[Column, ...], row: Callable[[Context, Member, Inferences], Row]
) -> Section:
    path = enum.place.path
    blocks = context.opening(enum)
    blocks.append(Facts(tuple(_facts(context, enum))))
    marks = Inferences(path)
    rows = [row(context, member, marks) for member in enum.members]
    title = enum.title or enum.name
    blocks.append(table(title, columns, rows, marks.footnotes(), heading=1))
    heading: Line = (plain(enum.title),) if enum.title else (code(enum.name),)
    return Section(path, (*heading, *context.section_title("", enum)[1:]), tuple(blocks))


def _facts(context: Context, enum: Enum) -> list[tuple[str, tuple[Line, ...]]]:
    other = "other values may occur" if enum.open else "no other value is accepted"
    facts: list[tuple[str, tuple[Line, ...]]] = [("Name", ((code(enum.name),),)), ("Others", ((plain(other),),))]
    if enum.gaps:
        facts.append(("Left out", ((plain(enum.gaps),),)))
    if users := context.users(enum.place.path):
        facts.append(("Used by", (users,)))
    if enum.sources:
        facts.append(("Source", (cited(enum.sources),)))
    return facts


def _number(member: Member) -> tuple[Line, ...]:
    """The number, in hexadecimal too where that reads otherwise."""
    if member.value <= 9:
        return ((code(str(member.value)),),)
    return (code(str(member.value)),), (styled(f"0x{member.value:02X}", "quiet"),)


def _gone(member: Member) -> list[Line]:
    return [(styled("not available", "badge"),)] if member.unavailable else []


def _value(context: Context, member: Member, marks: Inferences) -> Row:
    return Row(
        (
            cell(*_number(member)),
            names(member, member.name, mark=marks.all_marks(member.inferred)),
            cell(*_gone(member), *context.about(member)),
            sources(member),
        ),
        member.place.path,
    )


def _code(context: Context, member: Member, marks: Inferences) -> Row:
    problem: list[Line] = [(plain(member.problem),)] if member.problem else []
    causes = [_cause(cause, member) for cause in member.causes]
    causes += [Item((plain(remedy),)) for remedy in member.remedies]
    return Row(
        (
            cell(*_number(member)),
            names(member, member.name, mark=marks.all_marks(member.inferred)),
            cell("" if member.number is None else str(member.number)),
            cell(*problem, *_gone(member), *context.about(member)),
            cell(items=causes),
            sources(member),
        ),
        member.place.path,
    )


def _cause(cause: Cause, member: Member) -> Item:
    """A cause, with its place where it is not that of the code, and what to do about it below it."""
    elsewhere = cause.sources and cause.sources != member.sources
    where: Line = (styled(" (", "quiet"), *cited(cause.sources), styled(")", "quiet")) if elsewhere else ()
    return Item((styled(cause.cause, "strong"), *where), tuple((plain(remedy),) for remedy in cause.remedies))
