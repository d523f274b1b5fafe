"""Texts with blocks, programs and lists of variables as the objects that they are in a project."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.structured.objects import Item

_OBJECT = re.compile(
    r"^(?:// (?P<list>\w+)\n(?P<lines>(?:\{.*\}\n)?VAR_GLOBAL\n.*?^END_VAR\n)"
    r"|(?P<word>FUNCTION_BLOCK|PROGRAM) (?P<name>\w+)\n(?P<content>.*?)^END_(?P=word)\n)",
    re.MULTILINE | re.DOTALL,
)
_VARIABLE = re.compile(r"    (\w+)(?: AT (%[IQ]\*))? : (.+?)(?: := (.+?))?;(?: // (.*))?")
_KINDS = {"FUNCTION_BLOCK": "block", "PROGRAM": "program"}


def objects(text: str, group: str) -> Iterator[Item]:
    """The objects of a text, each with the lines of its declaration and of its statements."""
    for match in _OBJECT.finditer(text):
        if match["list"]:
            yield Item(match["list"], "list", group, tuple(match["lines"].splitlines()))
            continue
        declared, _, statements = match["content"].partition("END_VAR\n\n")
        head = f"{match['word']} {match['name']}"
        declaration = (head, *declared.splitlines(), "END_VAR")
        yield Item(match["name"], _KINDS[match["word"]], group, declaration, tuple(statements.splitlines()))


@dataclass(frozen=True, slots=True)
class DeclaredText:
    """A variable as it is declared: `address` is where it lies in the process image, or empty."""

    name: str
    address: str
    kind: str
    initial: str
    remark: str


def declared(item: Item) -> dict[str, list[DeclaredText]]:
    """The variables of an object by the word of their section."""
    sections: dict[str, list[DeclaredText]] = {}
    section = ""
    for line in item.declaration:
        match = _VARIABLE.fullmatch(line)
        if match is not None:
            sections[section].append(DeclaredText(*(group or "" for group in match.groups())))
        elif line.startswith("VAR"):
            section = line
            sections[section] = []
    return sections
