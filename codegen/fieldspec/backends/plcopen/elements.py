"""XML as a tree of elements, written with a blank a level. Text of a spec gets into it through this module only."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Element:
    """An element: its name, its attributes, and either elements or text in it."""

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    children: tuple[Element, ...] = ()
    text: str = ""


def element(tag: str, /, *children: Element, text: str = "", **attributes: str) -> Element:
    """An element."""
    return Element(tag, tuple(attributes.items()), children, text)


def written(root: Element) -> str:
    """A whole document."""
    return '<?xml version="1.0" encoding="utf-8"?>\n' + "\n".join(_lines(root, "")) + "\n"


def _lines(one: Element, indent: str) -> Iterator[str]:
    given = "".join(f" {name}={quoteattr(_legal(value))}" for name, value in one.attributes)
    if one.text:
        yield f"{indent}<{one.name}{given}>{escape(_legal(one.text))}</{one.name}>"
    elif one.children:
        yield f"{indent}<{one.name}{given}>"
        for child in one.children:
            yield from _lines(child, indent + " ")
        yield f"{indent}</{one.name}>"
    else:
        yield f"{indent}<{one.name}{given}/>"


def _legal(text: str) -> str:
    """A text without the characters that XML does not have."""
    return "".join(char for char in text if char in "\t\n" or (char >= " " and char.isprintable()) or char == "\u00a0")
