"""Structs and arrays as types by name."""

from __future__ import annotations

from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.printer import array_name, comment, comment_text, type_text
from fieldspec.targets.controllers.statements.expressions import ArrayType, Type
from fieldspec.targets.controllers.structs import Struct


def struct_lines(struct: Struct, spelling: Spelling) -> list[str]:
    """The declaration of a STRUCT of values in Structured Text."""
    lines = [*comment(struct.title, form=spelling.comment), "TYPE", f"    {struct.name} : STRUCT"]
    for member in struct.members:
        remark = f" {spelling.comment.format(comment_text(member.remark))}" if comment_text(member.remark) else ""
        lines.append(f"        {member.name} : {type_text(member.type, spelling)};{remark}")
    if not struct.members:
        lines.append(f"        byNothing : BYTE; {spelling.comment.format('a struct must have a member')}")
    return [*lines, "    END_STRUCT;", "END_TYPE"]


def type_lines(kind: ArrayType, spelling: Spelling) -> list[str]:
    """The name of an array type, and after it the lines that declare it.

    An array of arrays states its initial value, because matiec has none for it and writes wrong C.
    """
    name = array_name(kind, spelling)
    bounds = f"ARRAY [{kind.low}..{kind.high}] OF {type_text(kind.of, spelling)}"
    initial = f" := {_zeros(kind)}" if isinstance(kind.of, ArrayType) else ""
    return [name, "TYPE", f"    {name} : {bounds}{initial};", "END_TYPE"]


def _zeros(kind: Type) -> str:
    """The value that the elements of an array have anyway: texts and bytes are the arrays that arrays are made of."""
    return f"[{kind.high - kind.low + 1}({_zeros(kind.of)})]" if isinstance(kind, ArrayType) else "0"
