"""Blind detection: what the checks find in a spec as the manual prints it, without any erratum."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic, in_order
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Erratum
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping
from fieldspec.tools.audit.ledger import EFFECTS, by_effect
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.tools.proofs.errata import Proof, finding_key, printed_tree, put_back
from fieldspec.tools.proofs.examples import FindingsCache
from fieldspec.tools.proofs.running import Outcome, everything

WIRE = ("bytes", "range")
"""The effects that reach the wire: by these errata the power of the checks is measured."""

CLASSES = {
    "frame": ("frame", "values", "characters"),
    "address or number": ("at", "base", "decimal", "number", "wire_number", "code", "refusal_code", "index", "stride"),
    "size": ("words", "size", "length", "hex_digits", "request", "response", "repeat", "count", "elements"),
    "position": ("span", "word_span"),
    "bits": ("bit", "bits"),
    "framing": ("byte_order", "word_order", "initial", "greatest_sum"),
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
    "statement": ("says", "allow"),
    "name": ("name", "printed_name", "label"),
    "description": ("doc", "title", "one", "zero", "problem", "cause", "remedy"),
}
"""The classes of misprints, by the first key that is misprinted."""

TEXTS = frozenset(("printed_name", "label", *CLASSES["description"]))
"""The keys that only people read."""

OTHER, WORDING = "other", "wording"
"""The classes of a misprint in any other key, and of one that no key has: a wrong or missing sentence."""

OF_WRITING = (
    "allowances_used",
    "facts_verified",
    "illegible_inferred",
    "inferred_keys_present",
    "provenance_stated",
    "roles_unique",
    "sources_present",
    "steps_possible",
    "tasks_complete",
)
"""Checks of how a spec is written. They do not count: an author without the erratum would have written it otherwise."""


@dataclass(frozen=True, slots=True)
class Detection:
    """The findings with the printed value of one erratum put back `alone`, and whether it shows `together` with all
    others.
    """

    erratum: Erratum
    alone: tuple[Diagnostic, ...]
    together: bool

    @property
    def kind(self) -> str:
        """The class of the misprint."""
        return misprint(self.erratum)

    @property
    def checks(self) -> tuple[str, ...]:
        """The names of the checks that find the misprint."""
        return tuple(sorted({finding.code for finding in self.alone}))


@dataclass(frozen=True, slots=True)
class PrintedDevice:
    """A device as the manual prints it: the detection of each erratum, and the findings with all prints at once."""

    detections: tuple[Detection, ...]
    findings: tuple[Diagnostic, ...]


def misprint(erratum: Erratum) -> str:
    """The class of an erratum's misprint."""
    kinds = (kind for key in erratum.printed for kind, keys in CLASSES.items() if key in keys)
    return next(kinds, OTHER if erratum.printed else WORDING)


def as_printed(
    spec: DeviceSpec, proofs: Sequence[Proof], thorough: bool, known: Outcome | None = None
) -> PrintedDevice:
    """The findings of the checks in the printed values of a device that its spec does not have.

    The proof of an erratum has already run one check on its print; `thorough` runs all the others, too. `known` is the
    outcome of all checks of the spec, where they have run.
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
        right_findings = right[version] if version in right else everything(device, (), remembered=remembered)
        clean = {finding_key(finding) for finding in right_findings}
        whole = _new(_whole(spec, tree, version, device, remembered), clean)
        findings += whole
        for proof in proven:
            erratum = proof.erratum
            alone = proof.evidence
            if thorough or not alone:
                alone = tuple(in_order(_new(_alone(spec, tree, version, device, erratum, remembered), clean)))
            detections.append(Detection(erratum, alone, _shows(erratum, alone, whole)))
    order = [proof.erratum.id for proof in by_effect(proofs)]
    detections.sort(key=lambda detection: order.index(detection.erratum.id))
    return PrintedDevice(tuple(detections), tuple(in_order(findings)))


def _new(findings: Iterable[Diagnostic], clean: Container[tuple[str, str, int]]) -> list[Diagnostic]:
    """The findings that the spec itself does not have, without those about how it is written."""
    return [finding for finding in findings if finding_key(finding) not in clean and finding.code not in OF_WRITING]


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
    """The findings with all prints at once. A print that the language does not have is a finding of reading."""
    refused: list[Diagnostic] = []
    for erratum in device.errata:
        tree, broken = printed_tree(tree, erratum)
        refused += broken
    wrong, findings = built(spec.with_earlier_nodes(f"{version}/", tree), version, spec.reused)
    return [*refused, *everything(wrong, findings, remembered=remembered, without=OF_WRITING)]


def _shows(erratum: Erratum, alone: Sequence[Diagnostic], whole: Iterable[Diagnostic]) -> bool:
    """Whether a finding of all printed values together points to an erratum, or is among the findings of only that
    erratum.
    """
    known = {finding_key(finding) for finding in alone}
    printed = erratum.place.spans.get("printed")
    for finding in whole:
        if finding_key(finding) in known:
            return True
        spans = (finding.span, *(label.span for label in finding.labels))
        if printed and any(
            span.file is printed.file and printed.start <= span.start and span.end <= printed.end for span in spans
        ):
            return True
    return False


def detection(subject: Subject) -> Section:
    """The section about the misprints that checks find without their errata."""
    return section(as_printed(subject.spec, subject.proofs, thorough=False, known=subject.known))


def section(printed_device: PrintedDevice) -> Section:
    """A printed device as a section: how many errata the checks find, by class, and which ones they miss."""
    detections = printed_device.detections
    wire = [detection for detection in detections if detection.erratum.effect in WIRE]
    return Section(
        "detection",
        "Blind detection",
        (
            "Each misprint is put back as if it had no erratum, and all checks run: for each misprint alone, "
            "and for all together.",
        ),
        (
            _figure("errata that affect the wire or a range are found without the erratum", wire, True),
            _figure("errata of any effect are found without the erratum", detections, None),
            Figure(
                "errata that affect the wire or a range are found with all misprints together",
                sum(detection.together for detection in wire),
                len(wire),
            ),
        ),
        (_classes(detections), _missed(detections), _details(detections)),
    )


def _figure(text: str, detections: Sequence[Detection], judged: bool | None) -> Figure:
    count = sum(bool(detection.alone) for detection in detections)
    return Figure(text, count, len(detections), 2 * count > len(detections) or not detections if judged else None)


def _classes(detections: Sequence[Detection]) -> SectionTable:
    rows = []
    for kind in (*CLASSES, OTHER, WORDING):
        own = [detection for detection in detections if detection.kind == kind]
        wire = [detection for detection in own if detection.erratum.effect in WIRE]
        if own:
            detected, detected_on_wire = (sum(bool(detection.alone) for detection in part) for part in (own, wire))
            checks = sorted({check for detection in own for check in detection.checks})
            rows.append((kind, len(own), detected, len(wire), detected_on_wire, ", ".join(checks) or None))
    columns = ("misprint", "errata", "found", "on_the_wire", "found_on_the_wire", "checks")
    return SectionTable("detection_by_class", "By class of misprint", columns, tuple(rows))


def _missed(detections: Sequence[Detection]) -> SectionTable:
    rows = [
        (
            EFFECTS[detection.erratum.effect],
            detection.erratum.id,
            detection.erratum.fact,
            detection.erratum.confidence,
            _why(detection.erratum),
        )
        for detection in detections
        if not detection.alone and detection.erratum.effect in WIRE
    ]
    columns = ("effect", "erratum", "fact", "confidence", "why")
    return SectionTable("missed", "Not found, although the wire or a range is affected", columns, tuple(rows))


def _why(erratum: Erratum) -> str:
    if not erratum.printed:
        return "no key contains the misprint"
    return "the printed value contradicts nothing else in the manual"


def _details(detections: Sequence[Detection]) -> SectionTable:
    rows = tuple(_detection_row(detection) for detection in detections)
    columns = ("effect", "erratum", "misprint", "fact", "found_by", "finding", "together")
    kinds = tuple("good" if detection.alone else "" for detection in detections)
    return SectionTable("detections", "All errata, and what finds them", columns, rows, kinds, detail=True)


def _detection_row(detection: Detection) -> tuple[Cell, ...]:
    erratum = detection.erratum
    message = next(_first(detection), None)
    checks = ", ".join(detection.checks) or None
    is_together = "yes" if detection.together else "no"
    return EFFECTS[erratum.effect], erratum.id, detection.kind, erratum.fact, checks, message, is_together


def _first(detection: Detection) -> Iterator[str]:
    """The messages of the findings; first of the check that the erratum names."""
    for finding in sorted(detection.alone, key=lambda finding: finding.code != detection.erratum.proof):
        yield finding.message
