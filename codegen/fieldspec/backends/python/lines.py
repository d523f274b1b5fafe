"""Long statements over several lines."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.text import WIDTH


def filled(start: str, items: Sequence[str], end: str, indent: int) -> list[str]:
    """`start`, items with commas, `end` on one line where it fits; else as many items a line as fit, each row indented.

    `indent` is how far the statement stands to the right; the lines do not have that margin.
    """
    line = f"{start}{', '.join(items)}{end}"
    if len(line) + indent <= WIDTH or not items:
        return [line]
    rows = [f"    {items[0]},"]
    for item in items[1:]:
        if len(rows[-1]) + len(item) + 2 + indent > WIDTH:
            rows.append(f"    {item},")
        else:
            rows[-1] += f" {item},"
    return [start, *rows, end]


def unpacked(names: Sequence[str], source: str, indent: int) -> list[str]:
    """The statement that unpacks a source into names; the source alone where there are none."""
    if not names:
        return [source]
    line = f"({names[0]},) = {source}" if len(names) == 1 else f"{', '.join(names)} = {source}"
    return [line] if len(line) + indent <= WIDTH else filled("(", names, f") = {source}", indent + WIDTH)


def listed(start: str, items: Sequence[str], end: str, indent: int) -> list[str]:
    """The same as `filled`, but one item a line where not all fit one."""
    line = f"{start}{', '.join(items)}{end}"
    if len(line) + indent <= WIDTH or not items:
        return [line]
    return [start, *(f"    {item}," for item in items), end]


def chained(start: str, items: Sequence[str], joint: str, empty: str, indent: int) -> list[str]:
    """Expressions joined by `and` or `or`, one a line in parentheses where they do not fit one line."""
    line = f"{start}{f' {joint} '.join(items) or empty}"
    if len(line) + indent <= WIDTH or len(items) < 2:
        return [line]
    return [f"{start}(", f"    {items[0]}", *(f"    {joint} {item}" for item in items[1:]), ")"]


def union(name: str, types: Sequence[str]) -> list[str]:
    """The statement that names a union of types."""
    return chained(f"{name}: _TypeAlias = ", types, "|", "", 0)
