"""Every key of a fact has an effect: a constant has no default, a reserved fact has neither names nor a quantity, a
separator needs at least two fields, and on a link with `unit_addresses`, the part with the address has no `range`.

Why: a constant is its own default, and codecs do not use the names or the unit of a value that they ignore. One of the
two keys is a mistake. A second range of addresses could contradict the first one.

Example: a field with `const: 0xB4` and `default: 3`, or one with `reserved: true` and `unit: mm`.

Fix: Remove one of the two keys, or the separator. State the range of addresses in `unit_addresses`.
"""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, default_key, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field

_MEANINGS = ("enum", "flags", "unit", "scale", "offset", "sentinels")


def keys_have_effect(device: Device) -> Findings:
    for fact, value in values(device):
        # A trigger is read as something else than what is written.
        if value.const is not None and value.default is not None and not getattr(fact, "trigger", False):
            text = f"{fact.name} is always {value.const}, so that a default has no effect"
            related_label = label(fact.place, "const", "the constant")
            yield finding(fact.place, default_key(fact.place), text, "remove one of them", related_label)
        # The manual may print a unit for an address that it does not explain: such rows are documented as printed.
        if isinstance(fact, Field) or (isinstance(fact, Part) and fact.role == "plain"):
            yield from _reserved(fact, fact.reserved)
    for link in device.links.values():
        for part in (*link.request, *link.response):
            if part.role == "unit_address" and "range" in part.place and link.unit_addresses is not None:
                text = f"{link.name} states `unit_addresses`, so that `range` of {part.name} has no effect"
                related_label = label(link.place, "unit_addresses", "the addresses")
                yield finding(part.place, "range", text, "state the range only in `unit_addresses`", related_label)
    for flags in device.flags.values():
        for bit in flags.bits:
            yield from _reserved(bit, bit.reserved, (*_MEANINGS, "default", "unit_default"))


def _reserved(fact: Fact, is_reserved: bool, keys: Sequence[str] = _MEANINGS) -> Findings:
    for key in keys if is_reserved else ():
        if key in fact.place:
            text = f"{fact.name} is reserved, so that `{key}` has no effect"
            help = "remove it, or remove `reserved` if the value has this meaning"
            yield finding(fact.place, key, text, help, label(fact.place, "reserved", "it is ignored"))
