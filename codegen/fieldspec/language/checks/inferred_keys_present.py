"""Every key under `inferred` is a key of the fact.

Why: `inferred` states that the manual implies a value but does not print it. A reason for a missing value is
a mistake: the key is misspelt, or the value was removed.

Example: `inferred: {acces: ...}` on a register with `access: rw`.

Fix: Correct the key, add the value, or remove the reason.
"""

from __future__ import annotations

from fieldspec.foundation.classes import attributes
from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import UNSPECIFIED, Handling, Value


def inferred_keys_present(device: Device) -> Findings:
    for fact in facts(device):
        for key in fact.inferred:
            if not has_key(fact, key):
                text = f"{fact.name} has no `{key}` to infer"
                yield finding(fact.place, "inferred", text, "add it, or remove the reason")


def has_key(fact: Fact, key: str) -> bool:
    """Whether a fact has a key, of its own or from its group's defaults."""
    return key in fact.place or key in _from_defaults(fact)


def _from_defaults(fact: Fact) -> frozenset[str]:
    """The keys that a row may have from its group's defaults."""
    value = getattr(fact, "value", None)
    if not isinstance(value, Value):
        return frozenset()
    handling = getattr(fact, "handling", UNSPECIFIED)
    values: dict[str, object] = {
        "type": True,
        "length": True,
        "characters": value.characters is not None,
        "byte_order": bool(value.byte_order),
        "word_order": bool(value.word_order),
        "write_word_order": bool(value.write_word_order),
        "scale": value.scaled,
        "offset": bool(value.offset),
        "unit": bool(value.quantity_unit),
        "scale_by": bool(value.scale_by),
        "range": value.ranges is not None,
        "write_range": value.write_ranges is not None,
        "unit_range": value.ranges is not None,
        "default": value.default is not None,
        "unit_default": value.default is not None,
        "const": value.const is not None,
        "enum": bool(value.enum),
        "flags": bool(value.flags),
        "parameter": value.parameter is not None,
        "sentinels": bool(value.sentinels),
        "access": bool(getattr(fact, "access", "")),
        "restart": getattr(fact, "restart", None) is not None,
        "words": getattr(fact, "words", None) is not None,
        "atomic": getattr(fact, "atomic", False),
        "trigger": getattr(fact, "trigger", False),
        **{name: getattr(handling, name) for name in attributes(Handling)},
        "since": bool(fact.since),
        "until": bool(fact.until),
    }
    return frozenset(key for key, value in values.items() if value)
