"""The ledger of errata: the printed value, the value in use, the reason, the confidence, and the proof."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import TypeAlias

from fieldspec.language.model.texts import Erratum
from fieldspec.language.reading.nodes import Mapping, find, with_checked_keys
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.tools.proofs.errata import Proof, node_text

EFFECTS = {
    "bytes": "wrong bytes",
    "range": "wrong range",
    "name": "wrong name",
    "ambiguous": "ambiguous",
}
"""The effects on readers who trust the manual, the worst first."""

UNPROVEN = "not proven"
KINDS = {"proven": "good", "judgement": "", "open": "warning", UNPROVEN: "bad"}
"""The verdicts, with the mark of their rows: a check fails with the printed value put back, a person has judged, the
manual leaves the question open, or the check that should fail does not.
"""

_FIGURES = {
    "proven": "errata are proven by a check that fails with the printed value",
    "judgement": "errata rest on the judgement of a person",
    "open": "errata are questions that the manual leaves open",
}

COLUMNS = (
    "effect",
    "erratum",
    "fact",
    "printed",
    "literal",
    "used",
    "reason",
    "confidence",
    "verdict",
    "proof",
    "evidence",
    "versions",
    "source",
    "spec",
)

Trees: TypeAlias = dict[str, Mapping]
"""The trees of all versions of a device."""

_INTRODUCTION = (
    "Where the spec differs from the manual, or where the manual leaves a fact open. Each printed "
    "value is put back into the spec; the evidence is what the named check then finds."
)


def ledger(subject: Subject) -> Section:
    """The section about errata: their verdicts by effect, and the ledger itself."""
    proofs = by_effect(subject.proofs)
    trees = {version: subject.spec.tree_at(version) for version in subject.spec.versions()}
    verdicts = Counter(verdict(proof) for proof in proofs)
    figures = [
        Figure("errata", len(proofs)),
        *(Figure(text, verdicts[kind], len(proofs), kind == "proven" or None) for kind, text in _FIGURES.items()),
    ]
    if verdicts[UNPROVEN]:
        figures.append(Figure("errata whose proof does not fail", verdicts[UNPROVEN], len(proofs), False))
    table = SectionTable(
        "ledger",
        "Every erratum",
        COLUMNS,
        tuple(_erratum_row(trees, proof) for proof in proofs),
        tuple(KINDS[verdict(proof)] for proof in proofs),
        detail=True,
    )
    findings = tuple(fault for proof in proofs for fault in proof.faults)
    tables = (_summary(proofs), table)
    return Section("errata", "Errata", (_INTRODUCTION,), tuple(figures), tables, findings, questions=verdicts["open"])


def by_effect(proofs: Iterable[Proof]) -> list[Proof]:
    """The proofs of a device's errata, the worst effect first, else in the order of the spec."""
    order = list(EFFECTS)
    return sorted(proofs, key=lambda proof: order.index(proof.erratum.effect))


def verdict(proof: Proof) -> str:
    """The verdict of a proof, one of KINDS."""
    return UNPROVEN if proof.faults else proof.erratum.verdict


def _summary(proofs: Sequence[Proof]) -> SectionTable:
    counts = Counter((proof.erratum.effect, verdict(proof)) for proof in proofs)
    rows: list[tuple[Cell, ...]] = [
        (title, sum(counts[effect, kind] for kind in KINDS), *(counts[effect, kind] for kind in KINDS))
        for effect, title in EFFECTS.items()
    ]
    return SectionTable("errata_by_effect", "Errata by effect", ("effect", "errata", *KINDS), tuple(rows))


def _erratum_row(trees: Trees, proof: Proof) -> tuple[Cell, ...]:
    erratum = proof.erratum
    tree = trees[proof.version]
    return (
        EFFECTS[erratum.effect],
        erratum.id,
        erratum.fact,
        printed_text(tree, erratum),
        erratum.literal or None,
        used_text(tree, erratum),
        erratum.reason,
        erratum.confidence,
        verdict(proof),
        erratum.proof if erratum.verdict == "proven" else None,
        "; ".join(dict.fromkeys(finding.message for finding in proof.evidence)) or None,
        ", ".join(_versions(trees, erratum)) or None,
        "; ".join(citation.text() for citation in erratum.sources) or None,
        erratum.place.whole,
    )


def _versions(trees: Trees, erratum: Erratum) -> list[str]:
    """The versions with an erratum; none where all versions have it."""
    having = [version for version, tree in trees.items() if find(tree, f"errata/{erratum.id}") is not None]
    return having if len(having) < len(trees) else []


def printed_text(tree: Mapping, erratum: Erratum) -> str | None:
    """The print, key by key as the spec writes it; None where the misprint is in no key of the fact."""
    printed = find(tree, f"errata/{erratum.id}/printed")
    if not isinstance(printed, Mapping):
        return None
    return "; ".join(f"{key} {node_text(value) or 'missing'}" for key, value in printed.values.items())


def used_text(tree: Mapping, erratum: Erratum) -> str | None:
    """The values in use, under the same keys; None where there is no such fact or key."""
    fact = find(tree, erratum.fact)
    if not isinstance(fact, Mapping) or not erratum.printed:
        return None
    values = with_checked_keys(fact).values
    return "; ".join(f"{key} {node_text(values.get(key)) or 'none'}" for key in erratum.printed)
