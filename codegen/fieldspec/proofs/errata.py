"""Every erratum's print is put back into the spec, and the check that it names must then fail."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.device import Device
from fieldspec.model.erratum import Erratum
from fieldspec.reading.building.device import built
from fieldspec.reading.nodes import Mapping, Node, Scalar, exact
from fieldspec.reading.paths import changed, find
from fieldspec.reading.project import DeviceSpec
from fieldspec.reading.scalars import violations

JUDGEMENT = "judgement"

Findings = Callable[[Device, str], list[Diagnostic]]


def errata_proven(
    spec: DeviceSpec,
    version: str,
    device: Device,
    errata: Iterable[Erratum],
    findings: Findings,
    known: frozenset[str],
) -> Iterator[Diagnostic]:
    """Findings of some errata of a device at one version.

    `findings(device, check)` runs one check; `known` holds the names of all checks.
    """
    tree = spec.tree_at(version)
    clean: dict[str, set[tuple[str, int]]] = {}
    for erratum in errata:
        yield from _proven(tree, version, device, erratum, findings, known, clean)


def _proven(
    tree: Mapping,
    version: str,
    device: Device,
    erratum: Erratum,
    findings: Findings,
    known: frozenset[str],
    clean: dict[str, set[tuple[str, int]]],
) -> Iterator[Diagnostic]:
    node = find(tree, erratum.fact)
    place = erratum.place
    if not isinstance(node, Mapping):
        text = f"there is no fact `{erratum.fact}`"
        yield Diagnostic("errata_paths_resolve", text, place["fact"], help="see `fieldspec facts` for the paths")
        return
    for key, printed in erratum.printed.items():
        held = node.values.get(key)
        if _same(exact(held) if held is not None else None, printed, key):
            span = held.span if held is not None else node.span
            text = f"the spec has the printed value of `{key}`"
            label = Label(span, "the value that is used")
            yield Diagnostic("errata_differ", text, place["printed"], (label,), "use the right value in the spec")
            return
    if erratum.proof == JUDGEMENT:
        return
    if erratum.proof not in known:
        text = f"there is no check `{erratum.proof}`"
        yield Diagnostic("errata_proven", text, place["proof"], help="`fieldspec rule` lists the checks")
        return
    if not erratum.printed:
        text = "a proof needs the printed value to put back"
        yield Diagnostic("errata_proven", text, place["proof"], help="give `printed`, or say `judgement`")
        return
    wrong, broken = put_back(tree, version, device, erratum)
    if erratum.proof not in clean:
        clean[erratum.proof] = {_key(found) for found in findings(device, erratum.proof)}
    if broken and erratum.proof not in {found.code for found in broken}:
        text = f"the printed value cannot stand in the spec: {broken[0].message}"
        help = f"{broken[0].help}; what cannot be written in the language belongs into `literal`"
        yield Diagnostic("errata_proven", text, place["printed"], help=help)
        return
    shown = [f for f in (*broken, *findings(wrong, erratum.proof)) if f.code == erratum.proof]
    if not [found for found in shown if _key(found) not in clean[erratum.proof]]:
        text = f"with the print put back, `{erratum.proof}` still passes"
        help = "name the check that fails, or say `judgement`"
        yield Diagnostic("errata_proven", text, place["proof"], help=help)


def put_back(tree: Mapping, version: str, device: Device, erratum: Erratum) -> tuple[Device, list[Diagnostic]]:
    """The device as the manual prints it at one place, and what reading it finds.

    Where the print does not fit the schema, the device is the right one.
    """
    whole = find(tree, f"errata/{erratum.id}/printed")
    printed = whole.values if isinstance(whole, Mapping) else {}

    def change(node: Node) -> Node:
        assert isinstance(node, Mapping)
        for key, value in printed.items():
            gone = isinstance(value, Scalar) and value.value is None
            node = node.without(key) if gone else node.with_value(key, value)
        return node

    wrong = changed(tree, erratum.fact, change)
    assert isinstance(wrong, Mapping)
    broken = violations(wrong)
    if broken:
        return device, broken
    return built(wrong, version)


def _key(found: Diagnostic) -> tuple[str, int]:
    return found.message, found.span.start


def _same(used: object, printed: object, key: str) -> bool:
    if key == "frame":
        return str(used).replace(" ", "").upper() == str(printed).replace(" ", "").upper()
    return used == printed
