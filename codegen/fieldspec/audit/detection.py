"""Blind detection: what the checks find in the spec as the manual prints it, with no erratum written."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence

from fieldspec.audit.ledger import EFFECTS, by_effect
from fieldspec.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic, in_order
from fieldspec.model.device import Device
from fieldspec.model.texts import Erratum
from fieldspec.proofs.errata import Proof, finding_key, printed_tree, put_back
from fieldspec.proofs.examples import FindingsCache
from fieldspec.proofs.running import Outcome, everything
from fieldspec.reading.building.device import built
from fieldspec.reading.nodes import Mapping
from fieldspec.reading.project import DeviceSpec

WIRE = ("bytes", "range")
"""The effects by which the tool's power is measured: those that reach the wire."""

CLASSES = {
    "frame": ("frame", "values", "characters"),
    "address or number": ("at", "base", "decimal", "number", "wire_number", "code", "refusal_code", "index", "stride"),
    "size": ("words", "size", "length", "request", "response", "repeat", "count", "elements"),
    "position": ("span", "word_span"),
    "bits": ("bit", "bits"),
    "framing": ("byte_order", "word_order", "initial"),
    "type": ("type",),
    "range or default": ("range", "unit_range", "default", "unit_default", "min", "max", "numbers", "gaps", "within"),
    "unit or scale": ("unit", "scale", "offset"),
    "code or cell": ("value", "enum", "flags", "cells", "members", "enum_values"),
    "condition": (
        "since",
        "until",
        "only",
        "applies_to",
        "messages",
        "supplements",
        "access",
        "restart",
        "reserved",
        "available_since",
    ),
    "left out": ("present",),
    "statement": ("says",),
    "name": ("name", "printed_name", "label"),
    "description": ("doc", "title", "one", "zero", "problem", "cause", "remedy"),
}
"""The classes of misprints, by the first key that is misprinted."""

TEXTS = frozenset(("printed_name", "label", *CLASSES["description"]))
"""The keys that people read, and that no frame depends on."""

OTHER, WORDING = "other", "wording"
"""The classes of what is misprinted in another key, and of what no key holds: a sentence that is wrong or missing."""

OF_WRITING = (
    "allowances_used",
    "facts_verified",
    "illegible_inferred",
    "inferred_keys_given",
    "provenance_stated",
    "roles_unique",
    "sources_present",
    "steps_possible",
    "tasks_complete",
)
"""What finds slips of who writes the spec. Who does not know of an erratum would have written it otherwise."""


@dataclass(frozen=True, slots=True)
class Detection:
    """What is found with one erratum's print put back `alone`, and whether that shows `together` with the others."""

    erratum: Erratum
    alone: tuple[Diagnostic, ...]
    together: bool

    @property
    def kind(self) -> str:
        """The class of the misprint."""
        return misprint(self.erratum)

    @property
    def checks(self) -> tuple[str, ...]:
        """The names of the checks that find it."""
        return tuple(sorted({found.code for found in self.alone}))


@dataclass(frozen=True, slots=True)
class Printed:
    """A device as the manual prints it: what each erratum's print shows, and what all of them show at once."""

    detections: tuple[Detection, ...]
    findings: tuple[Diagnostic, ...]


def misprint(erratum: Erratum) -> str:
    """The class of an erratum's misprint."""
    kinds = (kind for key in erratum.printed for kind, keys in CLASSES.items() if key in keys)
    return next(kinds, OTHER if erratum.printed else WORDING)


def as_printed(spec: DeviceSpec, proofs: Sequence[Proof], thorough: bool, known: Outcome | None = None) -> Printed:
    """The findings in the print of a device that the right spec does not have.

    Where an erratum is proven, its proof has run one check on its print already; `thorough` runs all the others too.
    `known` is what running everything on the right spec has given.
    """
    of_version: dict[str, list[Proof]] = {}
    for proof in proofs:
        of_version.setdefault(proof.version, []).append(proof)
    remembered = known.remembered if known is not None else FindingsCache()
    right = known.by_version if known is not None else {}
    detections: list[Detection] = []
    findings: list[Diagnostic] = []
    for version, proven in of_version.items():
        device, _ = spec.at(version)
        tree = spec.tree_at(version)
        found = right[version] if version in right else everything(device, (), remembered=remembered)
        clean = {finding_key(one) for one in found}
        whole = _new(_whole(spec, tree, version, device, remembered), clean)
        findings += whole
        for proof in proven:
            erratum = proof.erratum
            alone = proof.evidence
            if thorough or not alone:
                alone = tuple(in_order(_new(_alone(spec, tree, version, device, erratum, remembered), clean)))
            detections.append(Detection(erratum, alone, _shows(erratum, alone, whole)))
    order = [proof.erratum.id for proof in by_effect(proofs)]
    detections.sort(key=lambda one: order.index(one.erratum.id))
    return Printed(tuple(detections), tuple(in_order(findings)))


def _new(found: Iterable[Diagnostic], clean: Container[tuple[str, str, int]]) -> list[Diagnostic]:
    """What is found in the print, and neither in the right spec nor in how the spec is written."""
    return [one for one in found if finding_key(one) not in clean and one.code not in OF_WRITING]


def _alone(
    spec: DeviceSpec, tree: Mapping, version: str, device: Device, erratum: Erratum, remembered: FindingsCache
) -> list[Diagnostic]:
    if not erratum.printed:
        return []
    wrong, broken = put_back(spec, tree, version, device, erratum)
    if wrong is device:
        return broken
    return everything(wrong, broken, not TEXTS.issuperset(erratum.printed), remembered, OF_WRITING)


def _whole(
    spec: DeviceSpec, tree: Mapping, version: str, device: Device, remembered: FindingsCache
) -> list[Diagnostic]:
    """What is found with all prints at once. What cannot stand in the language is found by reading, and left out."""
    refused: list[Diagnostic] = []
    for erratum in device.errata:
        tree, broken = printed_tree(tree, erratum)
        refused += broken
    wrong, found = built(tree, version, spec.reused)
    return [*refused, *everything(wrong, found, remembered=remembered, without=OF_WRITING)]


def _shows(erratum: Erratum, alone: Sequence[Diagnostic], whole: Iterable[Diagnostic]) -> bool:
    """Whether a finding of all prints together points to the print of an erratum, or is one that it has alone."""
    known = {finding_key(found) for found in alone}
    printed = erratum.place.spans.get("printed")
    for found in whole:
        if finding_key(found) in known:
            return True
        spans = (found.span, *(label.span for label in found.labels))
        if printed and any(
            span.file is printed.file and printed.start <= span.start and span.end <= printed.end for span in spans
        ):
            return True
    return False


def detection(subject: Subject) -> Section:
    """The section of the report: how many errata a check finds by itself, by class, and which ones none does."""
    return section(as_printed(subject.spec, subject.proofs, thorough=False, known=subject.known))


def section(made: Printed) -> Section:
    """How much of a device's errata is found blindly, as a part of the report."""
    every = made.detections
    wire = [one for one in every if one.erratum.effect in WIRE]
    return Section(
        "detection",
        "Blind detection",
        (
            "Every print is put back, as if no erratum had been written, and all checks run: each print by itself, and "
            "all of them together.",
        ),
        (
            _figure("errata with an effect on the wire or on ranges are found with no erratum written", wire, True),
            _figure("errata of any effect are found with no erratum written", every, None),
            Figure(
                "errata with an effect on the wire or on ranges are found with all prints together",
                sum(one.together for one in wire),
                len(wire),
            ),
        ),
        (_classes(every), _missed(every), _details(every)),
    )


def _figure(what: str, of: Sequence[Detection], judged: bool | None) -> Figure:
    found = sum(bool(one.alone) for one in of)
    return Figure(what, found, len(of), 2 * found > len(of) or not of if judged else None)


def _classes(every: Sequence[Detection]) -> SectionTable:
    rows = []
    for kind in (*CLASSES, OTHER, WORDING):
        own = [one for one in every if one.kind == kind]
        wire = [one for one in own if one.erratum.effect in WIRE]
        if own:
            found, blind = (sum(bool(one.alone) for one in part) for part in (own, wire))
            checks = sorted({check for one in own for check in one.checks})
            rows.append((kind, len(own), found, len(wire), blind, ", ".join(checks) or None))
    columns = ("misprint", "errata", "found", "on_the_wire", "found_on_the_wire", "checks")
    return SectionTable("detection_by_class", "By class of misprint", columns, tuple(rows))


def _missed(every: Sequence[Detection]) -> SectionTable:
    rows = [
        (EFFECTS[one.erratum.effect], one.erratum.id, one.erratum.fact, one.erratum.confidence, _why(one.erratum))
        for one in every
        if not one.alone and one.erratum.effect in WIRE
    ]
    columns = ("effect", "erratum", "fact", "confidence", "why")
    return SectionTable("missed", "Not found, though the wire or a range is concerned", columns, tuple(rows))


def _why(erratum: Erratum) -> str:
    if not erratum.printed:
        return "no key holds the slip"
    return "the print contradicts nothing else that is printed"


def _details(every: Sequence[Detection]) -> SectionTable:
    rows = tuple(_row(one) for one in every)
    columns = ("effect", "erratum", "misprint", "fact", "found_by", "finding", "together")
    kinds = tuple("good" if one.alone else "" for one in every)
    return SectionTable("detections", "Every erratum and what finds it", columns, rows, kinds, detail=True)


def _row(one: Detection) -> tuple[Cell, ...]:
    erratum = one.erratum
    message = next(_first(one), None)
    found_by = ", ".join(one.checks) or None
    together = "yes" if one.together else "no"
    return EFFECTS[erratum.effect], erratum.id, one.kind, erratum.fact, found_by, message, together


def _first(one: Detection) -> Iterator[str]:
    """The messages of the findings, that of the check that the erratum names first."""
    for found in sorted(one.alone, key=lambda found: found.code != one.erratum.proof):
        yield found.message
