"""Comments, what stands outside of functions, and functions: frozen trees, which `printer.py` writes."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.line_text import wrapped
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.c.expressions import Expression, Local, Type
from fieldspec.targets.c.statements import Body, Variable


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment for documentation tools; `comment` makes its lines safe. Without lines it is not printed."""

    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Blank:
    """An empty line."""


@dataclass(frozen=True, slots=True)
class Directive:
    """`#ifndef condition`, or `#endif` without one, on a line of its own."""

    keyword: str
    condition: str = ""


@dataclass(frozen=True, slots=True)
class Define:
    """`#define name value /**< remark */`"""

    name: str
    value: Expression
    remark: str = ""


@dataclass(frozen=True, slots=True)
class Typedef:
    """`typedef type name;`"""

    type: Type
    name: str


@dataclass(frozen=True, slots=True)
class Union:
    """`union { ... } name;`: a member of a struct."""

    members: tuple[Comment | Variable, ...]
    name: str


@dataclass(frozen=True, slots=True)
class Struct:
    """`typedef struct name { ... } name;`"""

    name: str
    members: tuple[Comment | Variable | Union, ...]


@dataclass(frozen=True, slots=True)
class Enumerator:
    """`name = value /**< remark */`"""

    name: str
    value: Expression
    remark: str = ""


@dataclass(frozen=True, slots=True)
class Enumeration:
    """`typedef enum name { ... } attribute name;`"""

    name: str
    enumerators: tuple[Enumerator, ...]
    attribute: str = ""


@dataclass(frozen=True, slots=True)
class Function:
    """`static inline result name(parameters) { ... }`

    Of `locals` those are declared, in this order, that the body uses.
    """

    result: Type
    name: str
    parameters: tuple[Variable, ...]
    body: Body
    locals: tuple[Local, ...] = ()
    storage: str = "static inline"


@dataclass(frozen=True, slots=True)
class Source:
    """C that is copied from a file of `runtime/`."""

    text: str


Declaration: TypeAlias = Comment | Blank | Directive | Define | Typedef | Struct | Enumeration | Function | Source

BLANK = Blank()


_SEPARATORS = {Comment, Blank}
_CONSTANTS = {Define, Enumeration, Typedef}


def parted(block: Sequence[Declaration]) -> tuple[list[Declaration], list[Declaration]]:
    """The constants of a block with their comments, and the rest of it.

    Between directives, constants stay where they are.
    """
    constants: list[Declaration] = []
    rest: list[Declaration] = []
    waiting: list[Declaration] = []
    is_whole = Directive in map(type, block)
    for declaration in block:
        kind = type(declaration)
        if kind in _SEPARATORS:
            waiting.append(declaration)
            continue
        part = constants if kind in _CONSTANTS and not is_whole else rest
        if kind is Function and part and not waiting:
            waiting.append(BLANK)
        part += waiting if part or not waiting or waiting[0] != BLANK else waiting[1:]
        part.append(declaration)
        waiting.clear()
    return constants, rest + waiting


_WIDTH = 108
_CACHE_SIZE = 1 << 14
"""How many texts are remembered: versions have most of theirs in common."""

_MARKS = re.compile(r"[*/?<\\@]")
_TAG = re.compile(r"<(?=[A-Za-z/!])")


def escape_comment(text: str) -> str:
    """A text that ends no comment and starts none, on one line, without trigraphs, joined lines or marks of HTML."""
    if not text.isprintable():
        text = "".join(char if char.isprintable() else " " for char in text)
    if _MARKS.search(text):
        text = text.replace("*/", "* /").replace("/*", "/ *").replace("//", "/ /").replace("??", "? ?")
        text = _TAG.sub("< ", text).replace("\\", "\\ ").replace("@", "(at)")
    return " ".join(text.split())


@lru_cache(maxsize=_CACHE_SIZE)
def wrap_comment(text: str) -> tuple[str, ...]:
    """A text as lines of a comment."""
    return tuple(wrapped(escape_comment(text), _WIDTH))


def comment(*paragraphs: str) -> Comment:
    """A comment of some paragraphs; empty ones are left out."""
    return Comment(tuple([line for text in paragraphs if text for line in wrap_comment(text)]))


def describe_fact(fact: Fact, *paragraphs: str) -> Comment:
    """The comment of a fact: its documentation, the text that the manual prints for it, notes, and its sources."""
    printed = " ".join(text for text in (fact.printed_name, fact.label) if text)
    sources = "; ".join([citation.text() for citation in fact.sources])
    return comment(
        fact.doc,
        f"Printed as {printed}." if printed else "",
        *paragraphs,
        *[f"Note: {note}" for note in fact.notes],
        f"Source: {sources}" if sources else "",
    )


def describe_value(value: Value | None) -> str:
    """The meaning of a count of a value, the permitted counts, and the special values."""
    if value is None:
        return ""
    facts = []
    if value.digits:
        facts.append(f"Sent as {digits_text(value)}.")
    if value.packed_bits:
        facts.append(f"{value.packed_text.capitalize()}.")
    if value.scaled or value.unit:
        scale = value.scale_text or str(value.scale)
        offset = f", plus {value.offset}" if value.offset else ""
        facts.append(f"One count is {scale} {value.unit}".rstrip() + f"{offset}.")
    if value.ranges is not None:
        facts.append(f"Range: {value.ranges.text()}.")
    if value.write_ranges is not None:
        facts.append(f"Writable: {value.write_ranges.text()}.")
    facts += [f"The {value.write_order_text}."] if value.write_word_order else []
    if value.enum or value.flags:
        facts.append(f"See {value.enum or value.flags}.")
    facts += [f"{sentinel.text} means {sentinel.name}." for sentinel in value.sentinels]
    return " ".join(facts)
