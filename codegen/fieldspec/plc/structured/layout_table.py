"""Where the members of structs lie in memory, as a table."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.plc.layout.table import type_name
from fieldspec.plc.structured.program import Program

HEAD = ("struct", "size", "member", "type", "at", "bytes", "on_wire", "order", "identity")


def rows(program: Program) -> Iterator[tuple[str, ...]]:
    """A row for each member: its struct and the bytes of that, its place in memory, and its place on the wire.

    The place and the order on the wire are empty where the struct is not that of one record.
    """
    for placed in program.placed:
        for member in placed.members:
            member_model = member.member
            wire_offset = "" if member_model.at is None else str(member_model.at)
            order = (
                ""
                if not member_model.order or member_model.value is None or member_model.value.size < 2
                else member_model.order
            )
            words = " words swapped" if order and member_model.swapped else ""
            total = member.stride * (member.count - 1) + member.size
            yield (
                placed.struct.name,
                str(placed.size),
                member_model.name,
                type_name(member_model.type),
                str(member.at),
                str(total),
                wire_offset,
                f"{order}{words}",
                program.declared.layout.identity,
            )


def layout_table(program: Program) -> str:
    """The table as CSV. Its cells are names and numbers, so that none needs quotes."""
    return "".join(",".join(row) + "\n" for row in (HEAD, *rows(program)))
