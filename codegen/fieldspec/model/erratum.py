"""Where the spec departs from the print."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from fieldspec.model.fact import Citation
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Erratum:
    """What is printed at a fact, and what is made of it. `proof` names a check, or is `judgement`."""

    id: str
    place: Place
    fact: str
    printed: Mapping[str, object]
    literal: str
    reason: str
    confidence: str
    effect: str
    proof: str
    sources: tuple[Citation, ...]
