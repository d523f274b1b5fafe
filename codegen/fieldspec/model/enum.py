"""Values by name, and tables of codes."""

from __future__ import annotations

from dataclasses import dataclass

from fieldspec.model.fact import Citation, Fact


@dataclass(frozen=True, slots=True)
class Cause:
    """A possible cause of a code, and what to do about it."""

    cause: str
    remedies: tuple[str, ...]
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Member(Fact):
    """One value, or one code."""

    value: int
    unavailable: bool
    problem: str
    causes: tuple[Cause, ...]
    remedies: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Enum(Fact):
    """Values by name. An open enum passes on values that it does not list; a closed one refuses them."""

    kind: str
    title: str
    open: bool
    gaps: str
    members: tuple[Member, ...]

    def member(self, value: int) -> Member | None:
        """The member with a value."""
        return next((member for member in self.members if member.value == value), None)

    def named(self, name: str) -> Member | None:
        """The member with a name."""
        return next((member for member in self.members if member.name == name), None)
