"""Data of Python as tables of Lua, and texts of specs as literals."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TypeAlias

Data: TypeAlias = "bool | int | str | bytes | Sequence[Data] | Mapping[str, Data] | Mapping[int, Data] | None"

WIDTH = 118
_KEYWORDS = """
and break do else elseif end false for function goto if in local nil not or repeat return then true until while
"""
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def line_text(text: str) -> str:
    """A text of a spec on one line, without characters that are invisible or change the direction of a line."""
    line = " ".join(text.split())
    return "".join(char if char.isprintable() else f"<U+{ord(char):04X}>" for char in line)


def literal(text: str | bytes) -> str:
    """A text or bytes in double quotes. All but printable ASCII are escapes of their bytes in UTF-8."""
    data = text.encode("utf-8", "replace") if isinstance(text, str) else text
    chars = []
    for byte in data:
        if byte in b'"\\' or not 0x20 <= byte < 0x7F:
            chars.append(f"\\{byte:03d}")
        else:
            chars.append(chr(byte))
    return f'"{"".join(chars)}"'


def comment(text: str) -> str:
    """A line of comment, in ASCII."""
    return f"-- {line_text(text)}".encode("ascii", "backslashreplace").decode("ascii")


def table(value: Data, indent: int = 0) -> str:
    """Data as an expression of Lua. Entries that are None or False are left out of mappings."""
    if value is None:
        return "nil"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return str(value)
    if isinstance(value, str | bytes):
        return literal(value)
    entries: list[tuple[str, Data]]
    if isinstance(value, Mapping):
        entries = [(_key(key), inner) for key, inner in value.items() if inner is not None and inner is not False]
    else:
        entries = [("", entry) for entry in value]
    if not entries:
        return "{}"
    flat = f"{{ {', '.join(key + table(inner) for key, inner in entries)} }}"
    if len(flat) + indent <= WIDTH and "\n" not in flat:
        return flat
    inside = " " * (indent + 2)
    lines = [f"{inside}{key}{table(inner, indent + 2)}," for key, inner in entries]
    return "\n".join(["{", *lines, f"{' ' * indent}}}"])


def _key(key: object) -> str:
    if isinstance(key, int):
        return f"[{key}] = "
    text = str(key)
    return f"{text} = " if _NAME.fullmatch(text) and text not in _KEYWORDS.split() else f"[{literal(text)}] = "


def joined(texts: Iterable[str]) -> str:
    """Texts that are not empty, with blanks between them."""
    return " ".join(text for text in texts if text)
