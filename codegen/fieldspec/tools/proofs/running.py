"""Runs checks and proofs on a device, and judges the accepted changes."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from fieldspec.codec.explain.examples import explained_anew
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.layout.package_codecs import coded_facts
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.behaviour.findings import findings as behaviour_findings
from fieldspec.language.checks.finding import allowances, enumeration
from fieldspec.language.checks.layout_conditions import LAYOUT_CONDITIONS
from fieldspec.language.diagnostics import Diagnostic, has_errors
from fieldspec.language.model.codecs import are_loaded, uses
from fieldspec.language.model.device import Device
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.proofs.detections_alike import detections_alike
from fieldspec.tools.proofs.equal_lines import equal_versions, lines_alike
from fieldspec.tools.proofs.errata import Findings, Proof, errata_by_version, proofs
from fieldspec.tools.proofs.examples import FindingsCache

if TYPE_CHECKING:
    from fieldspec.language.changes.acceptances import ComparedVersions


def previous(spec: DeviceSpec, version: str) -> str | None:
    """The version that another one is based on, or that comes before it on its line; None for the first one."""
    if version in spec.bases:
        return spec.bases[version]
    place = spec.lines.place.get(version)
    before = [other for other, (line, order) in spec.lines.place.items() if place and (line, order + 1) == place]
    return before[0] if before else None


def accepted(spec: DeviceSpec) -> list[Diagnostic]:
    """The findings of the acceptances of versions; the acceptances of the spec are judged by a comparison with it."""
    if not any("accepts" in tree.values for tree in (spec.tree, *spec.trees.values())):
        return []
    from fieldspec.language.changes.acceptances import accepts_used, rules_known
    from fieldspec.language.changes.table import RULES

    devices = {version: spec.at(version)[0] for version in spec.versions()}
    rules = {name for name, _, _ in RULES}
    acceptances = (acceptance for device in devices.values() for acceptance in device.accepts)
    return [*rules_known(acceptances, rules), *accepts_used([*_steps(spec, devices)])]


def _steps(spec: DeviceSpec, devices: Mapping[str, Device]) -> Iterator[ComparedVersions]:
    from fieldspec.language.changes.acceptances import ComparedVersions
    from fieldspec.language.changes.table import changes

    for version, new in devices.items():
        before = previous(spec, version)
        if before is not None and any(version in acceptance.since for acceptance in new.accepts):
            old = devices[before] if before in devices else spec.at(before)[0]
            yield ComparedVersions(old, new, changes(old, new), step=True)


EXAMPLE_PROOFS = (
    "checksum_correct",
    "length_byte_correct",
    "meaning_matches_bytes",
    "characters_match_bytes",
)
READING_PROOFS = (
    "duplicate_name",
    "missing_key",
    "type_present",
    "unknown_word",
    "wrong_form",
    "wrong_value",
)


def findings(device: Device, name: str, remembered: FindingsCache) -> list[Diagnostic]:
    """The findings of one check or proof of examples; reading has reported its own before."""
    if name in READING_PROOFS:
        return []
    if name not in EXAMPLE_PROOFS:
        from fieldspec.language.checks.table import run_named

        return run_named(device, name)
    return [finding for finding in remembered.findings(device) if finding.code == name]


def everything(
    device: Device,
    broken: Sequence[Diagnostic],
    examples: bool = True,
    remembered: FindingsCache | None = None,
    without: Container[str] = (),
) -> list[Diagnostic]:
    """The findings of all checks, and of the proofs of examples where the device can be laid out.

    `broken` are the findings of reading, which come first. Without `examples`, examples are not proven.
    `remembered` caches the findings of examples. `without` names the checks to leave out.
    """
    from fieldspec.language.checks.table import run  # with all checks, which other users of this module do not need

    findings = [*broken, *run(device, without)]
    if not examples or has_errors(broken) or any(finding.code in LAYOUT_CONDITIONS for finding in findings):
        return findings
    return [*findings, *(remembered or FindingsCache()).findings(device, sound=True), *codec_exemplified(device)]


def known() -> frozenset[str]:
    """The names of all checks that an erratum may name as its proof."""
    from fieldspec.language.checks.table import CHECKS, INSTALLED

    return frozenset([*(name for name, _ in CHECKS), *INSTALLED, *EXAMPLE_PROOFS, *READING_PROOFS])


def errata_proofs(spec: DeviceSpec) -> list[Proof]:
    """The proof of every erratum of a device, each at the newest version that has it, in the order of the spec."""
    finding = _finding(FindingsCache())
    proofs_of_errata = [
        proof
        for version, device, errata in errata_by_version(spec)
        for proof in proofs(spec, version, device, errata, finding, known())
    ]
    return _in_order(proofs_of_errata)


def _finding(remembered: FindingsCache) -> Findings:
    return lambda device, name: findings(device, name, remembered)


def _in_order(proofs_of_errata: Sequence[Proof]) -> list[Proof]:
    return sorted(proofs_of_errata, key=lambda proof: proof.erratum.place.whole.order())


@dataclass(frozen=True, slots=True)
class Outcome:
    """The result of all checks and proofs of a device.

    `findings` has all findings, `proofs` one proof for each erratum in the order of the spec, and `by_version` the
    findings of each version by itself, without the findings of errata. `remembered` caches the findings of examples.

    `layouts` has the versions that have a layout; where all have one, `shared` is the result of `equal_versions`.
    """

    findings: list[Diagnostic]
    proofs: list[Proof]
    by_version: Mapping[str, Sequence[Diagnostic]]
    remembered: FindingsCache
    layouts: Mapping[str, DeviceLayout]
    shared: Mapping[str, str]


def proven(spec: DeviceSpec) -> list[Diagnostic]:
    """All findings of a device at all its versions."""
    return outcome(spec).findings


def outcome(spec: DeviceSpec) -> Outcome:
    """Runs everything on a device at all its versions. Errata are proven where all else is right."""
    proofs_of_errata: list[Proof] = []
    by_version: dict[str, Sequence[Diagnostic]] = {}
    devices: dict[str, Device] = {}
    settled: set[str] = set()
    layouts: dict[str, DeviceLayout] = {}
    shared: dict[str, str] = {}
    remembered = FindingsCache()
    for version in reversed(spec.versions()):
        devices[version], broken = spec.at(version)
        by_version[version] = [
            *everything(devices[version], broken, remembered=remembered),
            *behaviour_findings(devices[version], spec.tree_at(version)),
        ]
    remaining = without_needed(devices, by_version)
    findings = [*of_versions(remaining, spec.versions())]
    for version, device in devices.items():
        if has_errors(remaining[version]):
            continue
        layouts[version] = device_layout(device)
        errata = [erratum for erratum in device.errata if erratum.id not in settled]
        settled |= {erratum.id for erratum in errata}
        of_version = [*proofs(spec, version, device, errata, _finding(remembered), known())]
        findings += (fault for proof in of_version for fault in proof.faults)
        proofs_of_errata += of_version
    if len(layouts) == len(spec.versions()):
        shared = equal_versions(spec, {version: layout.identity for version, layout in layouts.items()})
        findings += lines_alike(spec, shared)
        findings += detections_alike({version: layouts[version] for version in spec.versions()})
    return Outcome([*findings, *accepted(spec)], _in_order(proofs_of_errata), by_version, remembered, layouts, shared)


FEWEST = 3


def codec_exemplified(device: Device) -> Iterator[Diagnostic]:
    """A finding of each codec of a sound device that fewer printed frames use."""
    if not are_loaded():
        return
    layout = device_layout(device)
    facts = list(coded_facts(layout))
    counts = {name: 0 for _, _, name in facts}
    for example in layout.device.examples.values() if counts else ():
        if example.origin == "computed" or example.refused:
            continue
        with uses() as names:
            explained_anew(layout, example)
        for name in names:
            counts[name] += 1
    for fact, key, name in facts:
        count = counts.pop(name, FEWEST)
        if count < FEWEST:
            text = f"{count or 'no'} example{'s use' if count != 1 else ' uses'} the codec {name}"
            help = f"add printed frames until {FEWEST} have it, each with its values"
            yield Diagnostic("codec_exemplified", text, fact.place[key], help=help)


_Key = tuple[str, str, str, int]


def without_needed(
    devices: Mapping[str, Device], by_version: Mapping[str, Sequence[Diagnostic]]
) -> dict[str, list[Diagnostic]]:
    """The findings by version, without findings of allowances that another version needs.

    A fact that one version has may leave a hole in the others, and a spec has only one place to allow it.
    """
    of_allowances = {
        version: {_key(finding) for finding in findings if finding.code == "allowances_used"}
        for version, findings in by_version.items()
    }
    if not any(of_allowances.values()):
        return {version: [*findings] for version, findings in by_version.items()}
    needed_keys: set[_Key] = set()
    for version, keys in of_allowances.items():
        stated = {
            (allowance.fact.place["allow"].file.path, allowance.fact.place["allow"].start)
            for allowance in allowances(devices[version])
        }
        other_keys = set().union(*of_allowances.values()) - keys
        needed_keys |= {key for key in other_keys if key[2:] in stated}
    return {
        version: [finding for finding in findings if _key(finding) not in needed_keys]
        for version, findings in by_version.items()
    }


def of_versions(by_version: Mapping[str, Sequence[Diagnostic]], versions: Sequence[str]) -> Iterator[Diagnostic]:
    """The findings of some versions, each once. The text of one that not all versions have names those that do."""
    versions_by_key: dict[_Key, list[str]] = {}
    findings_by_key: dict[_Key, Diagnostic] = {}
    for findings in by_version.values():
        for finding in findings:
            findings_by_key.setdefault(_key(finding), finding)
    for version in versions:
        for key in {_key(finding): None for finding in by_version[version]}:
            versions_by_key.setdefault(key, []).append(version)
    for key, finding in findings_by_key.items():
        holders = versions_by_key[key]
        if len(holders) == len(versions):
            yield finding
        else:
            yield replace(finding, message=f"{finding.message} (in {enumeration(holders)})")


def _key(finding: Diagnostic) -> _Key:
    return finding.code, finding.message, finding.span.file.path, finding.span.start
