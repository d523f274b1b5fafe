"""The form of codes of the Unified Code for Units of Measure; which symbols there are is not looked up."""

from __future__ import annotations

import re

_BRACKETED = r"\[[!-Z\\^-~]+\]"
_SYMBOL = rf"(?:10[*^]|(?:[^\s\0\"()+\-./=\[\]{{}}0-9]|{_BRACKETED})+)"
_NOTE = r"\{[!-z|~]*\}"
_INNER = "\0"
"""What stands for a term in parentheses that has been read."""
_COMPONENT = re.compile(rf"(?:{_SYMBOL}(?:[+-]?[0-9]+)?|[0-9]+)(?:{_NOTE})?|{_NOTE}|{_INNER}", re.ASCII)
_GROUP = re.compile(r"\((?P<term>[^()]*)\)")
_PRINTABLE = re.compile(r"[!-~]+")


def is_code(text: str) -> bool:
    """Whether a text has the form of a code: `mm/{rev}`, `kg.m2`, `m[H2O]`, `(8.h)/d`, `10*3/uL`."""
    if not _PRINTABLE.fullmatch(text):
        return False
    notes = re.sub(_NOTE, lambda note: "{" + "_" * (len(note[0]) - 2) + "}", text)  # no operator in words counts
    while (group := _GROUP.search(notes)) is not None:
        if not _is_term(group["term"]):
            return False
        notes = f"{notes[: group.start()]}{_INNER}{notes[group.end() :]}"
    return _is_term(notes)


def _is_term(text: str) -> bool:
    components = re.split(r"[./](?![^\[]*\])", text.removeprefix("/"))
    return all(_COMPONENT.fullmatch(component) for component in components)
