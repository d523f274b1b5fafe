"""Fields with the same name and type have the same range, scale and unit. The rule measures_match_repeats covers fields
that carry the size of another field, because their range follows from what they measure. The number of registers or
bits that a message `accesses` is not compared either: it follows from the longest frame.

Why: a manual describes the same quantity in many places. If one place differs from all others, it is usually
misprinted, and a reader of only that place cannot see it.

Example: six commands with a force of 0..100, and a seventh with 1..100.

Fix: Compare the field with the manual, correct it and write an erratum. If it really differs, set `allow:
{siblings_agree: <reason>}`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable

from fieldspec.language.checks.facts import fields
from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field
from fieldspec.language.model.value import Value

_FEWEST = 3
_SMALL = 4


def siblings_agree(device: Device) -> Findings:
    families: dict[tuple[str, str], list[tuple[Field, Value]]] = {}
    counts = {
        id(message.request.named(access.count)) for message in device.messages.values() for access in message.accesses
    }
    for field in fields(device):
        is_comparable = not field.reserved and field.measures is None and id(field) not in counts
        if field.value is not None and is_comparable and field.value.parameter is None:
            families.setdefault((field.name, field.value.type.name), []).append((field, field.value))
    for family in families.values():
        yield from _odd(family, "range", lambda value: value.ranges.intervals if value.ranges else None)
        yield from _odd(
            family, "scale or unit", lambda value: (value.scale, value.offset, value.unit) if value.unit else None
        )


def _odd(family: list[tuple[Field, Value]], subject: str, quality: Callable[[Value], Hashable | None]) -> Findings:
    """Findings where all but one, or all but a small part, of those that say something say the same."""
    saying = [(field, statement) for field, value in family if (statement := quality(value)) is not None]
    if len(saying) < _FEWEST:
        return
    usual, times = Counter(statement for _, statement in saying).most_common(1)[0]
    odd = len(saying) - times
    if odd == 0 or (odd > 1 and odd * _SMALL >= len(saying)):
        return
    example = next(field for field, statement in saying if statement == usual)
    for field, statement in saying:
        if statement != usual:
            yield finding(
                field.place,
                _key(field, subject),
                f"{field.name} has a different {subject} in {times} other places",
                "compare it with the manual, or allow it with a reason",
                label(example.place, _key(example, subject), "one of the others"),
            )


def _key(field: Field, subject: str) -> str:
    return range_key(field.place) if subject == "range" else "scale" if "scale" in field.place else "unit"
