"""Findings of all versions of a device together: what one version needs is none in another, and nothing is lost."""

from __future__ import annotations

import pytest

from fieldspec.language.reading.project import read
from fieldspec.tools.proofs.running import proven

SPEC = """
device: {id: gadget, name: Gadget, vendor: Maker, manual: {title: Manual, file: gadget.txt, sha256: "HASH", lines: 9}}
versions:
  - {line: firmware, builds: true, members: [{id: "1.0", source: 1 L1}, {id: "1.1", source: 1 L2}]}
ACCEPTS
registers:
  - group: motion
    section: "1"
    rows:
      - {at: 20, name: voltage, type: u16, source: L3}
      - {at: 21, name: frequency, type: u16, since: "1.1", source: L4}
      - {at: 22, name: current, type: u16, ALLOWED, source: L5}
      - {at: POWER, name: power, type: u16, source: L6}
""".replace("HASH", "0" * 64)

NEEDED_BY_A_VERSION = "allow: {gaps_declared: The frequency is there since 1.1.}"
"""What leads to `current` is a hole in version 1.0 alone, so that version 1.1 does not use the allowance."""
NEEDED_IN_NONE = "allow: {gaps_declared: A., bits_unique: B.}"
ACCEPTS = 'accepts: [{rule: RULE, path: registers/frequency, reason: R, date: 2026-05-01, since: "1.1"}]'


def findings(power: int = 23, allowed: str = NEEDED_BY_A_VERSION, accepts: str = "") -> list[str]:
    """The codes of the findings of a device at both versions."""
    text = SPEC.replace("POWER", str(power)).replace("ALLOWED", allowed).replace("ACCEPTS", accepts)
    return [finding.code for finding in proven(read({"gadget/device.yaml": text.encode()}).devices["gadget"])]


@pytest.mark.parametrize(
    ("power", "allowed", "expected"),
    [
        (23, NEEDED_BY_A_VERSION, []),
        (22, NEEDED_BY_A_VERSION, ["addresses_disjoint"]),
        (22, NEEDED_IN_NONE, ["addresses_disjoint", "allowances_used"]),
    ],
    ids=["needed by one version", "beside another finding", "needed by no version"],
)
def test_an_allowance_that_one_version_needs_is_no_finding_in_the_others(
    power: int, allowed: str, expected: list[str]
) -> None:
    assert sorted(findings(power, allowed)) == expected


@pytest.mark.parametrize(("rule", "expected"), [("fact_added", []), ("register_moved", ["accepts_used"])])
def test_a_version_accepts_what_has_changed_since_the_one_before(rule: str, expected: list[str]) -> None:
    assert findings(accepts=ACCEPTS.replace("RULE", rule)) == expected
