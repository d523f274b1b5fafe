"""Names as a dialect takes them, and what is found where two of them are the same."""

from __future__ import annotations

import re

from fieldspec.classes import dataclass, field
from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.fact import Fact
from fieldspec.plc.dialects import Dialect

_IDENTIFIER = re.compile("[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")


@dataclass(slots=True)
class Scope:
    """Names that must differ, whatever the case of their letters. `what` says what they are names of.

    Names are taken in the order of the spec, so that a new fact behind the others changes none of theirs.
    """

    dialect: Dialect
    what: str
    found: list[Diagnostic]
    _taken: dict[str, tuple[str, Fact | None]] = field(default_factory=dict)

    def take(self, text: str, fact: Fact | None) -> str:
        """The name of a fact as it is spelled; a name that another fact has, or that is too long, is a finding."""
        spelled = self.dialect.spelled(text)
        most = self.dialect.name_length
        bare = spelled.strip('"')
        before = self._taken.setdefault(bare.lower(), (text, fact))
        if fact is not None:
            if before[1] is not fact:
                self.found.append(_same(self, text, fact, *before))
            if len(bare) > most or not _IDENTIFIER.fullmatch(bare):
                self.found.append(_long(self, text, fact, most))
        return spelled

    def free(self, text: str) -> str:
        """A name that no fact has chosen: where it is taken, a number stands behind it."""
        number, tried = 1, text
        while self.dialect.spelled(tried).strip('"').lower() in self._taken:
            number += 1
            tried = f"{text}{number}"
        return self.take(tried, None)


def _same(scope: Scope, text: str, fact: Fact, other: str, first: Fact | None) -> Diagnostic:
    beside = f"{fact.name} and {first.name} are" if first is not None else f"{fact.name} and a name of our own are"
    labels = (Label(first.place["name"], f"this one is {other}"),) if first is not None else ()
    return Diagnostic(
        "plc_names_distinct",
        f"{beside} the same {scope.what} in {scope.dialect.title}: {text}",
        fact.place["name"],
        labels,
        help="give one of them another name; capital letters and underscores make no difference there",
    )


def _long(scope: Scope, text: str, fact: Fact, most: int) -> Diagnostic:
    return Diagnostic(
        "plc_names_fit",
        f"{text} is no {scope.what} in {scope.dialect.title}: {most} letters, digits and single underscores",
        fact.place["name"],
        help="give it a shorter name",
    )
