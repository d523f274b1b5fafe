"""What a user must know and that belongs to no single fact."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Note:
    """A caveat, and the paths of the facts that it is about."""

    name: str
    place: Place
    title: str
    text: str
    about: tuple[str, ...]
    sources: tuple[Citation, ...]
