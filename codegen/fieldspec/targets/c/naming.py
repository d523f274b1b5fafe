"""Names of C. All but the members of structs begin with the device, so none meets a word of C or a macro."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Literal, TypeAlias

from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.names import Name
from fieldspec.foundation.reserved import C
from fieldspec.targets.c.expressions import Identifier, Local, Type
from fieldspec.targets.pieces import RequestedNames

Noun: TypeAlias = Literal[
    "own",
    "enum",
    "word",
    "bit",
    "state",
    "record",
    "message",
    "signal",
    "conversion",
    "register",
    "table",
    "parameter",
    "link",
]

_PREFIXES: dict[Noun, str] = {"signal": "signal", "register": "reg", "table": "table", "parameter": "par"}

# What the headers that are included define, as far as it has several words, and the local names of functions.
_TAKEN = (
    *("size_t", "ptrdiff_t", "wchar_t", "max_align_t", "size_max", "ptrdiff_max", "inner_length", "body_length"),
    *(f"{sign}int{kind}{bits}_t" for sign in ("", "u") for kind in ("", "_fast", "_least") for bits in (8, 16, 32, 64)),
    *(f"{sign}int{bits}_{end}" for sign in ("", "u") for bits in (8, 16, 32, 64, "ptr") for end in ("t", "max", "min")),
)
_TAKEN_WORDS = frozenset(word for name in _TAKEN for word in (name, name.upper()))

_OWN = {
    *("unit_address", "code", "in", "out", "length", "capacity", "body_length"),
    *("status", "total", "at", "byte", "value"),
}
_FRAME = {"unit_address", "code", "subcode", "error", "body", "body_length"}
_ARGUMENTS = C | _OWN
_MEMBERS = C | _FRAME


_NUMBERED: set[str] = set()
"""The names that have ever had a number after them, so that their words alone do not say whether they are free."""


class Naming:
    """The names in the header of one device: each fact has one name, and no two names are equal.

    A thing is known by what it is and by the names of what it belongs to. If two facts have the same joined words, the
    first request gets them, and the second gets a number after them.
    """

    def __init__(self, device: str) -> None:
        self._device = Name.of(device).snake()
        self._taken = {*_TAKEN_WORDS}
        self._given: dict[str, str] = {}
        self._stems: dict[tuple[Noun, tuple[str, ...]], str] = {}
        self._statuses: dict[str, Identifier] = {}
        self._status_variable: Local | None = None
        self._noted: RequestedNames | None = None
        self.key = device

    @contextmanager
    def noting(self) -> Iterator[RequestedNames]:
        """Records the requests and the names of a piece. A piece within it records its own, which count for both."""
        outer, self._noted = self._noted, ({}, {})
        requested_names = self._noted
        try:
            yield requested_names
        finally:
            self._noted = outer
        self._note(requested_names)

    def _note(self, requested_names: RequestedNames) -> None:
        if self._noted is not None:
            earlier, new = self._noted
            earlier.update(item for item in requested_names[0].items() if item[0] not in new)
            new.update(requested_names[1])

    def gives(self, requested_names: RequestedNames) -> bool:
        """Gives the same names again, all or none."""
        earlier, new = requested_names
        if not (earlier.items() <= self._given.items() and _NUMBERED.isdisjoint(new.values())):
            return False
        count = len(self._taken)
        self._taken.update(new.values())
        if len(self._taken) != count + len(new):  # one of them has been taken before
            self._taken = {*_TAKEN_WORDS, *self._given.values()}
            return False
        self._given.update(new)
        self._note(requested_names)
        return True

    def type(self, noun: Noun, *parts: str) -> str:
        """`gadget_point`"""
        return self._name(False, noun, parts)

    function = type

    def macro(self, noun: Noun, *parts: str) -> str:
        """`GADGET_POINTS_BASE`"""
        return self._name(True, noun, parts)

    def own(self, *parts: str) -> str:
        """A type or a function that every header has, or that no other noun has: `gadget_codec_status`"""
        return self._name(False, "own", parts)

    def own_macro(self, *parts: str) -> str:
        """`GADGET_OK`"""
        return self._name(True, "own", parts)

    def status(self, name: str) -> Identifier:
        """A constant of the status that functions return: `GADGET_ERR_OUT_OF_RANGE`"""
        text = self.own_macro(name)
        constant = self._statuses.get(name)
        if constant is None:
            constant = self._statuses[name] = Identifier(text)
        return constant

    def status_variable(self) -> Local:
        """The variable for the status of a call; its type is what functions return."""
        name = self.own("codec_status")
        if self._status_variable is None:
            self._status_variable = Local("status", Type(name))
        return self._status_variable

    def _name(self, upper: bool, noun: Noun, parts: tuple[str, ...]) -> str:
        key = "\0".join(("macro" if upper else "", noun, *parts))
        name = self._given.get(key)
        is_new = name is None
        if name is None:
            name = self._given[key] = self._free(self._words(noun, parts), upper)
        if self._noted is not None and key not in self._noted[1]:
            self._noted[is_new][key] = name
        return name

    def _words(self, noun: Noun, parts: tuple[str, ...]) -> str:
        """A name in lower case. That of a holder that has many names is looked up, not joined again."""
        if not parts:
            return _joined(self._device, _PREFIXES.get(noun, ""))
        key = noun, parts[:-1]
        stem = self._stems.get(key)
        if stem is None:
            stem = self._stems[key] = self._words(*key)
        return _joined(stem, parts[-1])

    def _free(self, words: str, upper: bool) -> str:
        words = words.upper() if upper else words
        number, text = 1, words
        while text in self._taken:
            number += 1
            text = f"{words}_{number}"
        if number > 1:
            _NUMBERED.add(text)
        self._taken.add(text)
        return text


def _joined(stem: str, part: str) -> str:
    words = Name.of(part).snake()
    return f"{stem}_{words}" if words else stem


def member(name: str) -> str:
    """A member of a struct; a word of C gets an underscore after it."""
    return f"{name}_" if name in C else name


def argument(part: PartLayout) -> str:
    """The parameter for a part of a frame, `unit_address` for the unit address.

    A word of C, or a name that the function itself uses, gets an underscore after it.
    """
    if part.role == "unit_address":
        return part.role
    return f"{part.name}_" if part.name in _ARGUMENTS else part.name


def frame_member(part: PartLayout) -> str:
    """The member of an opened frame for a part of the frame, `unit_address` for the unit address."""
    if part.role == "unit_address":
        return part.role
    return f"{part.name}_" if part.name in _MEMBERS else part.name
