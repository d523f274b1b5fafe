"""What stands outside of functions in C, and functions themselves: frozen trees, which `printer.py` writes."""

from __future__ import annotations

from typing import TypeAlias

from fieldspec.backends.c.expressions import Expression, Local, Type
from fieldspec.backends.c.statements import Body, Variable
from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment for documentation tools; `comments.py` makes its lines safe. Without lines it is not printed."""

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
    """`typedef enum name { ... } name;`"""

    name: str
    enumerators: tuple[Enumerator, ...]


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
EMPTY_COMMENT = Comment(())
