"""Dialects of Structured Text as the text that compilers of IEC 61131-3 take, and that text as our own parser does."""

from __future__ import annotations

import re
from collections.abc import Iterable

ARRAY = re.compile(r"ARRAY\s*\[\s*(-?\d+)\s*\.\.\s*(-?\d+)\s*\]\s*OF\s+(?!ARRAY\b)(\w+)", re.IGNORECASE)
DECLARED = re.compile(r"\nTYPE\s+(\w+) : (ARRAY ?\[[^;:]+?)(?: := [^;]+)?;\s+END_TYPE\n")
OBJECT = re.compile(r"^(?=TYPE\b|FUNCTION\b|FUNCTION_BLOCK\b|PROGRAM\b)", re.MULTILINE)


def without_comments(text: str) -> str:
    """A text without its comments and pragmas."""
    text = re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL)
    return re.sub(r"^\s*\{.*?\}", "", re.sub(r"//[^\n]*", "", text), flags=re.MULTILINE)


def anonymous(text: str) -> str:
    """A text whose arrays have types with names, with the types in the places of the names."""
    kinds = dict(DECLARED.findall(text))
    text = DECLARED.sub("\n", text)

    def placed(match: re.Match[str]) -> str:
        return re.sub(r"\bT_\w+", placed, kinds[match.group()])

    return re.sub(r"\bT_\w+", placed, text)


def named(text: str) -> str:
    """A text without comments whose arrays all have types by names, each before its first use."""
    text = anonymous(text)
    result: dict[str, str] = {}
    out: list[str] = []
    for value in OBJECT.split(text):
        fresh: list[str] = []

        def called(match: re.Match[str]) -> str:
            low, high, of = match.groups()
            name = f"T_{of}_{low.replace('-', 'M')}_{high}"
            if name not in result:
                result[name] = f"TYPE {name} : ARRAY [{low}..{high}] OF {of}; END_TYPE\n"
                fresh.append(result[name])  # noqa: B023
            return name

        before = ""
        while before != value:
            before, value = value, ARRAY.sub(called, value)
        out += [*fresh, value]
    return "".join(out)


def needed(content: str, names: Iterable[str]) -> str:
    """The types of a text, and of its functions and blocks those with some names and what they call."""
    objects = OBJECT.split(content)
    by_name = {}
    for item in objects:
        match = re.match(r"(?:FUNCTION|FUNCTION_BLOCK)\s+(\w+)", item)
        if match:
            by_name[match.group(1).upper()] = item
    wanted: set[str] = set()
    left = [name.upper() for name in names]
    while left:
        name = left.pop()
        if name not in wanted and name in by_name:
            wanted.add(name)
            left += [word.upper() for word in re.findall(r"\b[A-Za-z]\w+", by_name[name])]
    return "".join(
        item
        for item in objects
        if not (match := re.match(r"(?:FUNCTION|FUNCTION_BLOCK)\s+(\w+)", item)) or match.group(1).upper() in wanted
    )
