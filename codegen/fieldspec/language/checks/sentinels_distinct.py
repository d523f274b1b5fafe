"""The sentinels of a value have different names and values, and no sentinel is a member of the value's enum with a
different name.

Why: a value with two names is ambiguous when it is read; two values with one name are ambiguous when it is written. A
constant has no other states. The name `out_of_range` is reserved for numbers outside of the `range`, which are still
quantities.

Example: `sentinels: [{value: 0xFFFF, name: not_measured}, {value: 0xFFFF, name: overflow}]`.

Fix: Correct or rename one of them, and write an erratum if the manual prints it that way; or remove the sentinel, and
describe the member of the enum.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.value import OUT_OF_RANGE, Sentinel, Value

_HELP = "correct one of them, or remove the sentinel"


def sentinels_distinct(device: Device) -> Findings:
    for fact, value in values(device):
        names: dict[str, str] = {}
        texts: dict[str, str] = {}
        enum = device.enums.get(value.enum)
        for sentinel in value.sentinels:
            text = ""
            members = enum.members if enum is not None and not sentinel.is_nan else ()
            low, high = sentinel.interval
            covered = (member for member in members if low <= member.value <= high)
            member = next(
                (other for other in covered if other.name != sentinel.name or sentinel.last is not None), None
            )
            if sentinel.name == OUT_OF_RANGE:
                text = (
                    f"{sentinel.text} of {fact.name} is {OUT_OF_RANGE}, the state of every number outside of its range"
                )
            elif sentinel.text in names:
                text = f"{sentinel.text} of {fact.name} has two names, `{names[sentinel.text]}` and `{sentinel.name}`"
            elif sentinel.name in texts:
                text = f"{sentinel.name} of {fact.name} names both {texts[sentinel.name]} and {sentinel.text}"
            elif (other := _shared(value, sentinel)) is not None:
                text = f"{sentinel.text} of {fact.name} is `{sentinel.name}`, and {other.text} is `{other.name}`"
            elif member is not None and enum is not None:
                text = f"{sentinel.text} of {fact.name} is `{sentinel.name}`, but `{member.name}` in {enum.name}"
            elif value.const is not None:
                text = f"{fact.name} is always {value.const}, and has the sentinel {sentinel.name}"
            if text:
                help = "give it another name" if sentinel.name == OUT_OF_RANGE else _HELP
                yield finding(fact.place, "sentinels", text, help)
            names.setdefault(sentinel.text, sentinel.name)
            texts.setdefault(sentinel.name, sentinel.text)


def _shared(value: Value, sentinel: Sentinel) -> Sentinel | None:
    """A sentinel before another one that has some of its counts, of which one is an interval."""
    low, high = sentinel.interval
    for other in value.sentinels[: value.sentinels.index(sentinel)]:
        first, last = other.interval
        is_interval = sentinel.last is not None or other.last is not None
        if is_interval and first <= high and low <= last and not (sentinel.is_nan or other.is_nan):
            return other
    return None
