"""A fact that an output cannot express, and its finding."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import Fact


@dataclass(frozen=True, slots=True)
class Refusal:
    """A fact that an output cannot express.

    The finding is an error, whose help is LEAVE_OUT. It becomes a warning where the output leaves the fact out.
    """

    fact: Fact
    finding: Diagnostic

    @property
    def path(self) -> str:
        """The path of the fact."""
        return self.fact.place.path
