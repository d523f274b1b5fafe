"""Names of C. All but the members of structs begin with the device, so none meets a word of C or a macro."""

from __future__ import annotations

from fieldspec.names import Name
from fieldspec.reserved import C

_OWN = {"in", "out", "code", "length", "capacity", "body_length", "status", "total", "at", "byte", "value"}
_FRAME = {"code", "error", "body", "body_length"}


class Naming:
    """The names of one device's header."""

    def __init__(self, device: str) -> None:
        self.device = Name.of(device)

    def type(self, *parts: str) -> str:
        """`gadget_point`"""
        return self._name(parts).snake()

    function = type

    def macro(self, *parts: str) -> str:
        """`GADGET_POINTS_BASE`"""
        return self._name(parts).upper()

    def _name(self, parts: tuple[str, ...]) -> Name:
        name = self.device
        for part in parts:
            name += Name.of(part)
        return name


def member(name: str) -> str:
    """A member of a struct; a word of C gets an underscore behind it."""
    return f"{name}_" if name in C else name


def argument(name: str) -> str:
    """A parameter of a function; a word of C, or a name that the function itself uses, gets an underscore behind it."""
    return f"{name}_" if name in C | _OWN else name


def frame_member(name: str) -> str:
    """A member of an opened frame that a part of the frame gives."""
    return f"{name}_" if name in C | _FRAME else name


def stem(device: str, version: str) -> str:
    """The name of a version's files: `gadget_v2_0`, `gadget_before_1_17`."""
    words = Name.of(version).snake()
    return f"{device}_v{words}" if words[:1].isdigit() else f"{device}_{words}"
