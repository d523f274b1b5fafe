"""A struct in memory as a table, and as a drawing of its bytes."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.command.rendering.blocks import Block, Line, Table, narrowed
from fieldspec.targets.controllers.layout.memory import Placed
from fieldspec.targets.controllers.layout.table import member_rows

_A_ROW = 4
_BYTE = 16
_NOTHING = "..."
_HEADINGS = ("member", "type", "byte", "bit", "size", "elements", "stride", "on the wire", "read")


def blocks(placed: Placed, title: str) -> Iterator[Block]:
    """The size of a struct, its members as a table, and its bytes as boxes."""
    yield Line(title, "bold")
    size = "with the greatest number of elements" if placed.struct.size is None else f"on the wire {placed.struct.size}"
    yield Line(f"{placed.memory.title}: {placed.size} bytes, {size}")
    rows = [tuple("" if cell is None else str(cell) for cell in row) for row in member_rows(placed)]
    yield narrowed(Table(_HEADINGS, tuple(rows)))
    yield Line("")
    yield from (Line(line, drawn=True) for line in drawn(placed))


def drawn(placed: Placed) -> Iterator[str]:
    """A drawing with four bytes in a row and a box for each value.

    There is no wall where a value continues in the next row. `...` are bytes without a value, and `:` replaces rows
    that are equal to the one before.
    """
    names = _names(placed)
    yield " " * 6 + "".join(f"{number:<{_BYTE}}" for number in range(_A_ROW)).rstrip()
    before: list[str] = []
    mark = ""
    for offset in range(0, placed.size, _A_ROW):
        row = names[offset : offset + _A_ROW]
        yield from _wall(before, row)
        if row == before and len(set(row)) == 1:
            if mark != ":":
                yield f"{'':5}:"
            mark = ":"
        else:
            yield f"{offset:>4} {_boxes(row, before)}"
            mark = ""
        before = row
    yield from _wall([], before)


def _wall(above: list[str], below: list[str]) -> Iterator[str]:
    if above and above == below and len(set(above)) == 1:
        return
    count = max(len(above), len(below))
    yield " " * 5 + "+" + "".join("-" * (_BYTE - 1) + "+" for _ in range(count))


def _boxes(row: list[str], before: list[str]) -> str:
    """The boxes of a row; bytes of one value share a box."""
    text, index = "|", 0
    while index < len(row):
        count = next((n for n, name in enumerate(row[index:]) if name != row[index]), len(row) - index)
        room = count * _BYTE - 1
        goes_on = index == 0 and before[-1:] == row[:1] and row[0] != _NOTHING
        name = f"({row[index]})" if goes_on else row[index]
        text += f" {_cut(name, room - 2):<{room - 2}} |"
        index += count
    return text


def _cut(name: str, room: int) -> str:
    return name if len(name) <= room else f"{name[: room - 2]}.."


def _names(placed: Placed) -> list[str]:
    """The name of the value in each byte."""
    names = [_NOTHING] * placed.size
    _fill(names, placed, "", 0)
    return names


def _fill(names: list[str], placed: Placed, before: str, start: int) -> None:
    for placed_member in placed.members:
        path, offset = f"{before}{placed_member.member.name}", start + placed_member.at
        if placed_member.bit is not None:
            name = names[offset]
            names[offset] = path if name == _NOTHING else f"{name.partition(' ..')[0]} .. {placed_member.member.name}"
        elif placed_member.inner is not None and placed_member.inner.struct.kind != "bits":
            _fill(names, placed_member.inner, f"{path}[0]." if placed_member.is_array else f"{path}.", offset)
            _name(
                names,
                f"{path}[1..{placed_member.count - 1}]",
                offset + placed_member.stride,
                placed_member.stride * (placed_member.count - 1),
            )
        elif placed_member.is_array and placed_member.size * placed_member.count <= _A_ROW:
            for number in range(placed_member.count):
                _name(names, f"{path}[{number}]", offset + number * placed_member.stride, placed_member.size)
        else:
            _name(
                names,
                f"{path}[0..{placed_member.count - 1}]" if placed_member.is_array else path,
                offset,
                placed_member.end - placed_member.at,
            )


def _name(names: list[str], name: str, first: int, count: int) -> None:
    names[first : first + count] = [name] * count
