"""The ledger of errata in the documentation: grouped by effect, with the verdict that the audit gives."""

from __future__ import annotations

from collections import Counter

import pytest

from docs_output.documented import documentation
from fieldspec.command.sources import specs
from fieldspec.targets.docs.changes import page_name
from fieldspec.targets.docs.errata import EFFECTS, VERDICTS
from fieldspec.tools.audit.ledger import verdict
from fieldspec.tools.proofs.running import errata_proofs
from layouts import SPECS

DEVICES = specs.project(str(SPECS)).devices


def page(device: str) -> str:
    return documentation()[f"{device}/{page_name(DEVICES[device].versions()[-1])}.md"]


@pytest.mark.parametrize("device", DEVICES)
def test_the_numbers_are_those_of_the_audit(device: str) -> None:
    newest = DEVICES[device].versions()[-1]
    proofs = [proof for proof in errata_proofs(DEVICES[device]) if proof.version == newest]
    counts = Counter((proof.erratum.effect, verdict(proof)) for proof in proofs)
    for effect, (title, _) in EFFECTS.items():
        numbers = [counts[effect, kind] for kind in VERDICTS]
        cells = " | ".join(str(number) for number in (sum(numbers), *numbers))
        assert f"| [{title}](#errata-{effect}) | {cells} |" in page(device)


@pytest.mark.parametrize("device", DEVICES)
def test_every_erratum_stands_under_its_effect(device: str) -> None:
    text = page(device)
    model, _ = DEVICES[device].at(DEVICES[device].versions()[-1])
    order = [effect for effect in EFFECTS if f'<a id="errata-{effect}"></a>' in text]
    starts = [text.index(f'<a id="errata-{effect}"></a>') for effect in order]
    ends = [*starts[1:], len(text)]
    parts = {effect: text[start:end] for effect, start, end in zip(order, starts, ends, strict=True)}
    for erratum in model.errata:
        holding = [effect for effect, part in parts.items() if f"| `{erratum.id}`<br>" in part]
        assert holding == [erratum.effect], erratum.id
