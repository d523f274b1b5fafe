"""Statements for the elements of a field, once or in a loop, and what several kinds of functions say alike."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from fieldspec.backends.c.fields import count_member, members
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.text import indented
from fieldspec.layout.record import FieldLayout, RecordLayout

# The statements for one element, from its offset in the bytes and its member of the struct.
One = Callable[[str, str], list[str]]


def each(record: RecordLayout, field: FieldLayout, one: One, holder: str) -> list[str]:
    """The statements for a field: once, or in a loop."""
    return looped(record, field, field.size, one, holder, member(field.name))


def looped(record: RecordLayout, field: FieldLayout, size: int, one: One, holder: str, name: str) -> list[str]:
    """The statements for a field whose elements have some size, and lie in some member."""
    if not field.is_list:
        return one(f"{field.offset}", f"{holder}{name}")
    repeated = field.field.repeat is not None
    count = f"{holder}{count_member(record, field)}" if repeated else f"{field.count}u"
    lines = one(f"{field.offset}u + at * {size}u", f"{holder}{name}[at]")
    return [f"for (at = 0; at < {count}; at++) {{", *indented(lines), "}"] if lines else []


def returning(naming: Naming, call: str) -> list[str]:
    """Statements that call a function, and return what it says if that is an error."""
    return [f"status = {call};", f"if (status != {naming.own_macro('ok')}) {{", "    return status;", "}"]


def member_argument(record: RecordLayout, name: str) -> str:
    """The argument that gives a function the struct of a record; a record without members has none."""
    return f"&{name}, " if members(record) else ""


def element(record: RecordLayout, field: FieldLayout) -> str:
    """The size of one element; where it differs from case to case, the variable that holds it."""
    return "element" if field.cases and record.size is None else f"{field.size}u"


def measure(record: RecordLayout, field: FieldLayout, holder: str) -> str:
    """An expression for the size, or the number of elements, of the field that another one measures."""
    held = field.field.measures
    assert held is not None
    other = record.named(held.field)
    assert other is not None
    repeated = other.field.repeat is not None
    count = f"{holder}{count_member(record, other)}" if repeated else f"{other.count or 1}u"
    size = element(record, other) if held.of == "bytes" else "1u"
    return count if size == "1u" else f"{count} * {size}"


def variables(naming: Naming, body: Iterable[str]) -> list[str]:
    """The declarations of the variables that statements use."""
    text = "\n".join(body)
    known = (
        (r"^\s*element = ", "size_t element;"),
        (r"\(at = 0;", "size_t at;"),
        (r"&inner_length\b", "size_t inner_length;"),
        (r"^\s*status = ", f"{naming.own('codec_status')} status;"),
    )
    return [declared for use, declared in known if re.search(use, text, re.MULTILINE)]
