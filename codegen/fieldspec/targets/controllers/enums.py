"""Enums, and texts of codes."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Member
from fieldspec.targets.controllers.statements.expressions import Elementary


@dataclass(frozen=True, slots=True)
class EnumMember:
    """A member of a declared enum, with its name in the dialect."""

    name: str
    value: int
    remark: str
    member: Member | None = None


@dataclass(frozen=True, slots=True)
class EnumDeclaration:
    """A declared enum over whole numbers of a type. `enum` is None for the status of the routines."""

    name: str
    base: Elementary
    title: str
    members: tuple[EnumMember, ...]
    enum: Enum | None = None


def available(enum: Enum) -> list[Member]:
    """The members that the device has, one for each number."""
    members: dict[int, Member] = {}
    for member in enum.members:
        if not member.unavailable:
            members.setdefault(member.value, member)
    return list(members.values())


KINDS = ("alarm", "fault", "warning", "error", "exception")
"""The enums that are codes of something that happens, as opposed to values that are set."""


@dataclass(frozen=True, slots=True)
class Text:
    """The meaning of a code, in one line for an operator."""

    code: int
    text: str
    member: Member


@dataclass(frozen=True, slots=True)
class TextTable:
    """The codes of an enum with their texts, by number. `name` is that of the constant."""

    name: str
    title: str
    enum: Enum
    texts: tuple[Text, ...]

    @property
    def longest(self) -> int:
        """The number of characters in the longest text."""
        return max(len(text.text) for text in self.texts)


def coded(device: Device) -> Iterator[tuple[Enum, tuple[Text, ...]]]:
    """The enums of codes that have members, with the texts of these, the least number first."""
    for enum in device.enums.values():
        members = sorted(available(enum), key=lambda member: member.value)
        if enum.kind in KINDS and members:
            yield enum, tuple(Text(member.value, meaning(enum, member), member) for member in members)


def meaning(enum: Enum, member: Member) -> str:
    """The text of a code: what the panel of the device shows, if that is a form of it, its name, and its problem."""
    panel_text = f"{member.printed_name} " if enum.printed_as and member.printed_name else ""
    title = panel_text + Name.of(member.name).title()
    return f"{title}: {member.problem}" if member.problem else title
