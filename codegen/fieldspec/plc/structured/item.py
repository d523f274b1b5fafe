"""Pieces of a program: each is one object of a project."""

from __future__ import annotations

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Item:
    """An object by its name. `kind` is type, list or function; `about` is what it belongs to, in a word or two.

    `declaration` and `implementation` are its lines; a function has no line for its end, since files of projects have
    none.
    """

    name: str
    kind: str
    about: str
    declaration: tuple[str, ...]
    implementation: tuple[str, ...] = ()

    @property
    def lines(self) -> list[str]:
        """The whole object, as text that stands alone."""
        end = ["END_FUNCTION"] if self.kind == "function" else []
        return [*self.declaration, *self.implementation, *end]
