"""What holds in a good spec. One file a check, named by what holds when it passes.

A check yields findings and knows nothing of allowances: they are applied here, once for all checks.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.addresses_ascending import addresses_ascending
from fieldspec.checks.addresses_disjoint import addresses_disjoint
from fieldspec.checks.addresses_within_space import addresses_within_space
from fieldspec.checks.allowances import Allowance, allowances
from fieldspec.checks.allowances_used import allowances_used
from fieldspec.checks.decimal_equals_hex import decimal_equals_hex
from fieldspec.checks.default_within_range import default_within_range
from fieldspec.checks.enum_names_unique import enum_names_unique
from fieldspec.checks.enum_values_unique import enum_values_unique
from fieldspec.checks.enum_within_range import enum_within_range
from fieldspec.checks.finding import Check
from fieldspec.checks.gaps_declared import gaps_declared
from fieldspec.checks.range_within_enum import range_within_enum
from fieldspec.checks.range_within_type import range_within_type
from fieldspec.checks.value_within_range import value_within_range
from fieldspec.diagnostics import Diagnostic, in_order
from fieldspec.model.device import Device

CHECKS: tuple[tuple[str, Check], ...] = (
    ("addresses_ascending", addresses_ascending),
    ("addresses_disjoint", addresses_disjoint),
    ("addresses_within_space", addresses_within_space),
    ("decimal_equals_hex", decimal_equals_hex),
    ("default_within_range", default_within_range),
    ("enum_names_unique", enum_names_unique),
    ("enum_values_unique", enum_values_unique),
    ("enum_within_range", enum_within_range),
    ("gaps_declared", gaps_declared),
    ("range_within_enum", range_within_enum),
    ("range_within_type", range_within_type),
    ("value_within_range", value_within_range),
)

MOST_FINDINGS = 200
"""How many findings one check may have; more of them help nobody."""

_BY_NAME = dict(CHECKS)


def run(device: Device) -> list[Diagnostic]:
    """The findings of all checks, in order."""
    given = list(allowances(device))
    used: set[Allowance] = set()
    found = [finding for name, _ in CHECKS for finding in _kept(device, name, given, used)]
    return in_order([*found, *allowances_used(given, used, _BY_NAME)])


def run_named(device: Device, name: str) -> list[Diagnostic]:
    """The findings of one check, in order."""
    if name == "allowances_used":
        return [finding for finding in run(device) if finding.code == name]
    return in_order(_kept(device, name, list(allowances(device)), set()))


def _kept(device: Device, name: str, given: list[Allowance], used: set[Allowance]) -> Iterator[Diagnostic]:
    """The findings of a check that nothing allows; allowances that are met are added to `used`."""
    own = [allowance for allowance in given if allowance.check == name]
    kept = 0
    for finding in _BY_NAME[name](device):
        covering = [allowance for allowance in own if allowance.covers(finding)]
        used.update(covering)
        if covering:
            continue
        if kept == MOST_FINDINGS:
            text = f"`{name}` has more than {MOST_FINDINGS} findings; the rest is not listed"
            yield Diagnostic("too_many_findings", text, finding.span, help="mend the first ones")
            return
        kept += 1
        yield finding
