"""Every erratum's print is put back into the spec, and the check that it names must then fail."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import JUDGEMENT, Erratum
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import (
    CHECKED,
    Mapping,
    Node,
    Scalar,
    exact,
    find,
    keys,
    node_at,
    put,
    schema_path,
    with_checked_keys,
)
from fieldspec.language.reading.scalars import part_at, violations_at

MISSING = "present"
"""The key under `printed` that says, as `present: false`, that the manual lacks the whole fact."""

Findings = Callable[[Device, str], list[Diagnostic]]


@dataclass(frozen=True, slots=True)
class Proof:
    """The proof of an erratum: the findings that only the printed value has (`evidence`), and the faults of the
    erratum.

    A judgement has neither. An erratum with `faults` is not proven.
    """

    erratum: Erratum
    version: str
    evidence: tuple[Diagnostic, ...] = ()
    faults: tuple[Diagnostic, ...] = ()


def errata_by_version(spec: DeviceSpec) -> Iterator[tuple[str, Device, list[Erratum]]]:
    """Every version of a device, the newest first, with the errata that no newer one has."""
    settled: set[str] = set()
    for version in reversed(spec.versions()):
        device, _ = spec.at(version)
        yield version, device, [erratum for erratum in device.errata if erratum.id not in settled]
        settled |= {erratum.id for erratum in device.errata}


def proofs(
    spec: DeviceSpec,
    version: str,
    device: Device,
    errata: Iterable[Erratum],
    findings: Findings,
    known: frozenset[str],
) -> Iterator[Proof]:
    """The proofs of some errata of a device at one version, one after the other.

    `findings(device, check)` runs one check; `known` holds the names of all checks.
    """
    tree = spec.tree_at(version)
    clean: dict[str, set[tuple[str, str, int]]] = {}
    for erratum in errata:
        fault = _unsound(tree, erratum, known)
        if fault is not None or erratum.proof == JUDGEMENT:
            yield Proof(erratum, version, (), () if fault is None else (fault,))
            continue
        if erratum.proof not in clean:
            clean[erratum.proof] = {finding_key(finding) for finding in findings(device, erratum.proof)}
        wrong, broken = put_back(spec, tree, version, device, erratum)
        if broken and erratum.proof not in {finding.code for finding in broken}:
            yield Proof(erratum, version, (), (_cannot_stand(erratum, broken[0]),))
            continue
        own_findings = [f for f in (*broken, *findings(wrong, erratum.proof)) if f.code == erratum.proof]
        evidence = tuple(finding for finding in own_findings if finding_key(finding) not in clean[erratum.proof])
        yield Proof(erratum, version, evidence, () if evidence else (_passes(erratum),))


def _unsound(tree: Mapping, erratum: Erratum, known: frozenset[str]) -> Diagnostic | None:
    """Why the printed value of an erratum cannot be put back at all, or why that would prove nothing."""
    node = find(tree, erratum.fact)
    place = erratum.place
    if not isinstance(node, Mapping):
        text = f"there is no fact `{erratum.fact}`"
        return Diagnostic("errata_paths_resolve", text, place["fact"], help="see `fieldspec facts` for the paths")
    values = with_checked_keys(node).values
    for key, printed in erratum.printed.items():
        own = values.get(key)
        if _is_same_value(exact(own) if own is not None else None, printed, key):
            span = own.span if own is not None else node.span
            text = f"the spec uses the printed value of `{key}`"
            label = Label(span, "the value in the spec")
            return Diagnostic("errata_differ", text, place["printed"], (label,), "use the right value in the spec")
    if erratum.proof == JUDGEMENT:
        return None
    if erratum.proof not in known:
        text = f"there is no rule `{erratum.proof}`"
        return Diagnostic("errata_proven", text, place["proof"], help="`fieldspec rule` lists the rules")
    if not erratum.printed:
        text = "a proof needs the printed value to put back"
        return Diagnostic("errata_proven", text, place["proof"], help="add `printed`, or use `judgement`")
    return None


def _cannot_stand(erratum: Erratum, broken: Diagnostic) -> Diagnostic:
    text = f"the printed value is not valid in the spec: {broken.message}"
    help = f"{broken.help}; use `literal` for what the language cannot express"
    return Diagnostic("errata_proven", text, erratum.place["printed"], help=help)


def _passes(erratum: Erratum) -> Diagnostic:
    text = f"with the printed value, `{erratum.proof}` still passes"
    help = "name the rule that fails, or use `judgement`"
    return Diagnostic("errata_proven", text, erratum.place["proof"], help=help)


def put_back(
    spec: DeviceSpec, tree: Mapping, version: str, device: Device, erratum: Erratum
) -> tuple[Device, list[Diagnostic]]:
    """The device as the manual prints it at one place, and what reading it finds.

    If the printed value does not fit the schema, the device is the right one. Facts that the printed value does not
    change are not built again.
    """
    wrong, broken = printed_tree(tree, erratum)
    if broken:
        return device, broken
    return built(spec.with_earlier_nodes(f"{version}/{erratum.id}", wrong), version, spec.reused)


def printed_tree(tree: Mapping, erratum: Erratum) -> tuple[Mapping, list[Diagnostic]]:
    """The tree with the printed value of an erratum, or the unchanged tree and the findings of the schema about that
    value.
    """
    whole = find(tree, f"errata/{erratum.id}/printed")
    fact_keys = keys(tree, erratum.fact)
    if not isinstance(whole, Mapping) or fact_keys is None:
        return tree, []
    fact = node_at(tree, fact_keys)
    assert isinstance(fact, Mapping)
    wrong = put(tree, fact_keys, _as_printed(fact, whole, fact_keys))
    assert isinstance(wrong, Mapping)
    item = fact_keys[:2]  # the rest of the tree is as it was
    if len(fact_keys) <= len(item) and _lacking(whole, fact_keys):
        return wrong, []
    broken = violations_at(wrong, item)
    return (tree, broken) if broken else (wrong, [])


def _as_printed(fact: Mapping, printed: Mapping, fact_keys: list[str | int]) -> Mapping | None:
    """A fact with what the manual prints of it; None if the manual lacks it."""
    if _lacking(printed, fact_keys):
        return None
    below = part_at(schema_path(fact_keys)).get("properties", {}).get(CHECKED, {}).get("properties", {})
    checked = fact.values.get(CHECKED, Mapping(printed.file, printed.start, printed.end, {}))
    assert isinstance(checked, Mapping)
    for key, value in printed.values.items():
        is_removed = isinstance(value, Scalar) and value.value is None
        if key in below:
            checked = checked.without(key) if is_removed else checked.with_value(key, value)
        else:
            fact = fact.without(key) if is_removed else fact.with_value(key, value)
    return fact.with_value(CHECKED, checked) if checked.values else fact.without(CHECKED)


def _lacking(printed: Mapping, fact_keys: list[str | int]) -> bool:
    """Whether the manual lacks the whole fact. Claims of second places have a key of that name themselves."""
    present = printed.values.get(MISSING)
    absent = isinstance(present, Scalar) and present.value is False
    return absent and MISSING not in part_at(schema_path(fact_keys)).get("properties", {})


def finding_key(finding: Diagnostic) -> tuple[str, str, int]:
    """Distinguishes a finding that only the printed value has from findings of the right spec."""
    return finding.code, finding.message, finding.span.start


def _is_same_value(used: object, printed: object, key: str) -> bool:
    if key == "frame":
        return str(used).replace(" ", "").upper() == str(printed).replace(" ", "").upper()
    return used == printed


def node_text(node: Node | None) -> str:
    """The text of a node as the spec has it; empty where there is none."""
    if node is None or (isinstance(node, Scalar) and node.value is None):
        return ""
    if isinstance(node, Scalar):
        return node.text
    if isinstance(node, Mapping):
        return ", ".join(f"{key}: {node_text(value)}" for key, value in node.values.items())
    return ", ".join(node_text(item) for item in node.items)
