"""XML as a tree of elements, written with a blank a level. Text of a spec gets into it through this module only."""

from __future__ import annotations

from html import escape

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
    lines = ['<?xml version="1.0" encoding="utf-8"?>']
    _write(root, "", lines)
    return "\n".join(lines) + "\n"


def _write(one: Element, indent: str, lines: list[str]) -> None:
    given = "".join([f" {name}={_quoted(value)}" for name, value in one.attributes])
    if one.text:
        lines.append(f"{indent}<{one.name}{given}>{escape(_legal(one.text), quote=False)}</{one.name}>")
    elif one.children:
        lines.append(f"{indent}<{one.name}{given}>")
        inner = indent + " "
        for child in one.children:
            _write(child, inner, lines)
        lines.append(f"{indent}</{one.name}>")
    else:
        lines.append(f"{indent}<{one.name}{given}/>")


def _quoted(value: str) -> str:
    """The value of an attribute, with marks around it that are not in it, if there are such."""
    text = escape(_legal(value), quote=False).replace("\n", "&#10;").replace("\t", "&#9;")
    if '"' not in text:
        return f'"{text}"'
    return "'" + text + "'" if "'" not in text else '"' + text.replace('"', "&quot;") + '"'


def _legal(text: str) -> str:
    """A text without the characters that XML does not have."""
    if text.replace("\n", "").isprintable():
        return text
    return "".join(char for char in text if char in "\t\n\u00a0" or char.isprintable())
