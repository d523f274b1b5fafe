"""Data of Python as tables of Lua, and texts of specs as literals."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from fieldspec.targets.pieces import content_piece

Data: TypeAlias = "bool | int | str | bytes | Sequence[Data] | Mapping[str, Data] | Mapping[int, Data] | None"

WIDTH = 118
_SECTION = 4
"""The indentation of the entries of a section."""
_KEYWORDS = frozenset(
    """
    and break do else elseif end false for function goto if in local nil not or repeat return then true until while
    """.split()  # noqa: SIM905
)
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_ESCAPES = {byte: f"\\{byte:03d}" for byte in range(256) if byte in b'"\\' or not 0x20 <= byte < 0x7F}


def line_text(text: str) -> str:
    """A text of a spec on one line, without characters that are invisible or change the direction of a line."""
    line = " ".join(text.split())
    if line.isprintable():
        return line
    return "".join(char if char.isprintable() else f"<U+{ord(char):04X}>" for char in line)


def literal(text: str | bytes) -> str:
    """A text or bytes in double quotes. All but printable ASCII are escapes of their bytes in UTF-8."""
    data = text.encode("utf-8", "replace") if isinstance(text, str) else text
    return f'"{data.decode("latin-1").translate(_ESCAPES)}"'


def comment(text: str) -> str:
    """A line of comment, in ASCII."""
    return f"-- {line_text(text)}".encode("ascii", "backslashreplace").decode("ascii")


def table(value: Data, indent: int = 0) -> str:
    """Data as an expression of Lua. Entries that are None or False are left out of mappings."""
    if not _is_composed(value):
        return _scalar(value)
    flat = _flat(value, WIDTH - indent)
    if flat is not None:
        return flat
    inner_indent = " " * (indent + 2)
    lines = [f"{inner_indent}{key}{_item(inner, indent + 2)}," for key, inner in _entries(value)]
    return "\n".join(["{", *lines, f"{' ' * indent}}}"]) if lines else "{}"


def _item(value: Data, indent: int) -> str:
    """An entry of a table. Those of sections, such as a record or an enum, are what versions and saves share."""
    if indent != _SECTION:
        return table(value, indent)
    return content_piece("table of Lua", value, (), lambda: table(value, indent))


def _is_composed(value: Data) -> bool:
    return not (value is None or isinstance(value, bool | int | float | str | bytes))


def _scalar(value: Data) -> str:
    if value is None:
        return "nil"
    if isinstance(value, bool):
        return "true" if value else "false"
    return literal(value) if isinstance(value, str | bytes) else str(value)


def _entries(value: Data) -> Iterator[tuple[str, Data]]:
    """What stands in a table: the beginning of each entry, with its key, and its value."""
    if isinstance(value, Mapping):
        yield from ((_key(key), inner) for key, inner in value.items() if inner is not None and inner is not False)
    elif isinstance(value, Sequence):
        yield from (("", entry) for entry in value)


def _flat(value: Data, room: int) -> str | None:
    """Data in one line of at most `room` characters; None where the line would be longer."""
    if not _is_composed(value):
        text = _scalar(value)
        return text if len(text) <= room else None
    parts: list[str] = []
    left = room - len("{}")
    for key, inner in _entries(value):
        left -= len(key) + len("  ")  # a comma and a blank follow the previous entry, and blanks are inside the braces
        inner_text = _flat(inner, left)
        if inner_text is None:
            return None
        left -= len(inner_text)
        parts.append(key + inner_text)
    if left < 0:
        return None
    return f"{{ {', '.join(parts)} }}" if parts else "{}"


def _key(key: object) -> str:
    if isinstance(key, int):
        return f"[{key}] = "
    text = str(key)
    return f"{text} = " if _NAME.fullmatch(text) and text not in _KEYWORDS else f"[{literal(text)}] = "


def joined(texts: Iterable[str]) -> str:
    """Texts that are not empty, with blanks between them."""
    return " ".join(text for text in texts if text)
