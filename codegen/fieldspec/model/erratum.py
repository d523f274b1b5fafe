"""Where the spec departs from the print."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation
from fieldspec.model.place import Place

JUDGEMENT = "judgement"
"""What `proof` says where no check can decide."""


@dataclass(frozen=True, slots=True)
class Erratum:
    """What is printed at a fact, and what is made of it. `proof` names a check, or is `judgement`.

    `illegible` is `empty` or `garbled` where nothing can be read there, else it is empty.
    """

    id: str
    place: Place
    fact: str
    printed: Mapping[str, object]
    literal: str
    illegible: str
    reason: str
    confidence: str
    effect: str
    proof: str
    sources: tuple[Citation, ...]

    @property
    def verdict(self) -> str:
        """`proven` by a check, a `judgement` of a person, or `open`: the manual does not decide it, and nobody has.

        A build has run the proof of every erratum that names one, and is refused where one fails to prove.
        """
        if self.proof != JUDGEMENT:
            return "proven"
        return "open" if self.confidence == "open" else "judgement"
