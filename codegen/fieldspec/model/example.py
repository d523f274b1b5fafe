"""Frames with their meanings."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Example:
    """A frame and what it means. `values` is the meaning as the spec writes it; `refused` names why a decoder
    must refuse the frame, or is empty."""

    id: str
    place: Place
    title: str
    link: str
    direction: str
    message: str
    error: bool
    refused: str
    reply_to: str
    frame: bytes
    elided: tuple[str, ...]
    characters: str
    values: Mapping[str, object]
    origin: str
    sources: tuple[Citation, ...]
    notes: tuple[str, ...]
