"""What a user must know and that belongs to no single fact."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Statement:
    """What one place of the manual states of a subject: that it is so `always`, `sometimes` or `never`."""

    place: Place
    subject: str
    says: str
    text: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True)
class Note:
    """A caveat, the paths of the facts that it is about, and what places of the manual state of its subjects."""

    name: str
    place: Place
    title: str
    text: str
    about: tuple[str, ...]
    statements: tuple[Statement, ...]
    sources: tuple[Citation, ...]
