"""A source of Structured Text with slots as a tree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass, field


@dataclass(frozen=True, slots=True)
class File:
    """A source: its name and its lines."""

    name: str
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Token:
    """A word of a source, and its place."""

    kind: str
    text: str
    line: int
    column: int
    file: File


class SourceError(Exception):
    """A fault of a source, with the line that has it and a mark below it."""


def wrong(token: Token, text: str, trace: Sequence[str] = ()) -> SourceError:
    """The error for a fault. It has one argument, so that it passes from one process to another."""
    lines = token.file.lines
    line = lines[token.line - 1] if token.line <= len(lines) else ""
    mark = " " * (token.column - 1) + "^" * max(len(token.text), 1)
    origins = "".join(f"\n  in {entry}" for entry in trace)
    return SourceError(f"{token.file.name}:{token.line}:{token.column}: {text}\n  {line}\n  {mark}{origins}")


@dataclass(frozen=True, slots=True)
class Named:
    """A variable, a constant, a property or a slot; after a dot, a member of its `structure`."""

    token: Token
    structure: Term | None = None


@dataclass(frozen=True, slots=True)
class Indexed:
    """An element of an array."""

    token: Token
    array: Term
    index: Term


@dataclass(frozen=True, slots=True)
class Literal:
    """A number or a time."""

    token: Token


@dataclass(frozen=True, slots=True)
class Inverted:
    """NOT of a truth."""

    token: Token
    operand: Term


@dataclass(frozen=True, slots=True)
class Joined:
    """Terms with an operator between."""

    token: Token
    parts: tuple[Term, ...]


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a call, by `:=` or `=>`; without a `direction` it is a slot of several, or what is converted."""

    token: Token
    direction: str
    value: Term


@dataclass(frozen=True, slots=True)
class Applied:
    """A call of a function, or of a timer."""

    token: Token
    routine: Term
    arguments: tuple[Argument, ...]


Term: TypeAlias = Named | Indexed | Literal | Inverted | Joined | Applied


@dataclass(frozen=True, slots=True)
class Assigned:
    """`target := value;`"""

    token: Token
    target: Term
    value: Term


@dataclass(frozen=True, slots=True)
class Timed:
    """A call of a timer."""

    token: Token
    call: Applied


@dataclass(frozen=True, slots=True)
class Insertion:
    """An action, or statements of the generator, in braces."""

    token: Token
    name: Named | Indexed
    argument: Term | None


@dataclass(frozen=True, slots=True)
class Chosen:
    """IF with its branches. ELSE has no test; an insertion in the place of a test brings the branches of its own IF."""

    token: Token
    branches: tuple[tuple[Term | Insertion | None, Block], ...]


@dataclass(frozen=True, slots=True)
class Selected:
    """CASE, whose branches are a slot."""

    token: Token
    selector: Term
    branches: Term


@dataclass(frozen=True, slots=True)
class Iteration:
    """FOR from a number to another one."""

    token: Token
    index: Term
    first: Term
    last: Term
    body: Block


@dataclass(frozen=True, slots=True)
class Commented:
    """A statement with the comment in front of it."""

    token: Token
    comment: str
    step: Step


@dataclass(frozen=True, slots=True)
class Headed:
    """REGION: statements with a heading."""

    token: Token
    heading: str
    body: Block


Step: TypeAlias = Assigned | Timed | Insertion | Chosen | Selected | Iteration | Commented | Headed
Block: TypeAlias = tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class Entry:
    """A variable with its type, or, without one, a slot of declarations."""

    token: Token
    name: Term
    kind: Term | None = None
    initial: Token | None = None
    remark: str = ""


@dataclass(frozen=True, slots=True)
class Section:
    """Variables of a role, declared where the condition holds."""

    role: str
    condition: Term | None
    entries: tuple[Entry, ...]


@dataclass(frozen=True, slots=True)
class Action:
    """Statements with a name, perhaps a parameter, and perhaps a comment."""

    parameter: str
    body: Block
    comment: str = ""


@dataclass(slots=True)
class Source:
    """A parsed file: what it extends, its comment, its variables, actions, properties and statements.

    `late` are the variables that stand between the actions and the statements.
    """

    extends: str = ""
    remarks: tuple[str, ...] = ()
    sections: list[Section] = field(default_factory=list)
    late: list[Section] = field(default_factory=list)
    actions: dict[str, Action] = field(default_factory=dict)
    properties: dict[str, Term] = field(default_factory=dict)
    body: Block = ()
    names: set[str] = field(default_factory=set)
