"""A fact may allow a rule to be broken there, with a reason."""

from __future__ import annotations

from fieldspec.language.checks import table as checks
from fieldspec.language.reading.project import read

SPEC = """
device: {id: gadget, name: Gadget, vendor: Maker, manual: {title: Manual, file: gadget.txt, sha256: "HASH", lines: 9}}
registers:
  - group: motion
    section: "1"
    GROUP
    rows:
      - {at: 0x2000, name: distance, type: i32, source: L1 FIRST}
      - {at: 0x2001, name: low_word, type: u16, source: L2 SECOND}
      - {at: 0x2003, name: speed, type: u16, source: L3}
""".replace("HASH", "0" * 64)

OVERLAP = "allow: {addresses_disjoint: It is listed twice.}"
HOLE = "allow: {gaps_declared: Nobody knows.}"


def codes(group: str = "", first: str = "", second: str = "") -> list[str]:
    """The codes of the findings when a group and its rows have these additional keys."""
    text = SPEC.replace("GROUP", group).replace("FIRST", f", {first}" if first else "")
    text = text.replace("SECOND", f", {second}" if second else "")
    device, findings = read({"gadget/device.yaml": text.encode()}).devices["gadget"].at("1")
    assert findings == []
    return [finding.code for finding in checks.run(device)]


def test_without_an_allowance_both_are_found() -> None:
    assert codes() == ["addresses_disjoint", "gaps_declared"]


def test_allowance_holds_where_the_finding_is() -> None:
    assert codes(second=OVERLAP) == ["gaps_declared"]


def test_allowance_holds_where_the_finding_has_a_label() -> None:
    assert codes(first=OVERLAP) == ["gaps_declared"]


def test_allowance_of_a_group_holds_for_its_rows() -> None:
    assert codes(group=HOLE) == ["addresses_disjoint"]


def test_allowance_of_one_check_does_not_hold_for_another() -> None:
    assert codes(second=HOLE) == ["addresses_disjoint", "allowances_used", "gaps_declared"]


def test_a_single_check_respects_allowances_too() -> None:
    text = SPEC.replace("GROUP", "").replace("FIRST", "").replace("SECOND", f", {OVERLAP}")
    device, _ = read({"gadget/device.yaml": text.encode()}).devices["gadget"].at("1")
    assert checks.run_named(device, "addresses_disjoint") == []
    assert [finding.code for finding in checks.run_named(device, "gaps_declared")] == ["gaps_declared"]
    assert checks.run_named(device, "allowances_used") == []
