"""Values by name, and tables of codes."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation, Fact


@dataclass(frozen=True, slots=True)
class Cause:
    """A possible cause of a code, and what to do about it."""

    cause: str
    remedies: tuple[str, ...]
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Member(Fact):
    """One value, or one code. `number` is another one under which the manual knows it."""

    value: int
    number: int | None
    unavailable: bool
    problem: str
    causes: tuple[Cause, ...]
    remedies: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Enum(Fact):
    """Values by name. An open enum passes on values that it does not list; a closed one refuses them.

    `printed_as` is the form of its members' printed names, empty where they have none. `derived` names the word of
    flags, or the enum, that its members follow from; empty where they are listed.
    """

    kind: str
    title: str
    open: bool
    gaps: str
    printed_as: str
    derived: str
    members: tuple[Member, ...]

    def member(self, value: int) -> Member | None:
        """The member with a value."""
        return next((member for member in self.members if member.value == value), None)

    def named(self, name: str) -> Member | None:
        """The member with a name."""
        return next((member for member in self.members if member.name == name), None)
