"""Enums: those that are types, and the numbers of all."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.enum import Enum, Member
from fieldspec.plc.routines.types import Elementary


@dataclass(frozen=True, slots=True)
class EnumMember:
    """A member that there is, by the name of the dialect."""

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
    found: dict[int, Member] = {}
    for member in enum.members:
        if not member.unavailable:
            found.setdefault(member.value, member)
    return list(found.values())
