"""Where the members of structs lie in memory, as a table."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.plc.structured.objects import type_name
from fieldspec.plc.structured.program import Program

HEAD = ("struct", "size", "member", "type", "at", "bytes", "on_wire", "order", "identity")


def rows(made: Program) -> Iterator[tuple[str, ...]]:
    """A row for each member: its struct and the bytes of that, its place in memory, and its place on the wire.

    The place and the order on the wire are empty where the struct is not that of one record.
    """
    for one in made.placed:
        for member in one.members:
            held = member.member
            there = "" if held.at is None else str(held.at)
            order = "" if not held.order or held.value is None or held.value.size < 2 else held.order
            words = " words swapped" if order and held.swapped else ""
            total = member.stride * (member.count - 1) + member.size
            yield (
                one.struct.name,
                str(one.size),
                held.name,
                type_name(held.type),
                str(member.at),
                str(total),
                there,
                f"{order}{words}",
                made.declared.layout.identity,
            )


def layout_table(made: Program) -> str:
    """The table as CSV. Its cells are names and numbers, so that none needs quotes."""
    return "".join(",".join(row) + "\n" for row in (HEAD, *rows(made)))
