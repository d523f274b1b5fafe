"""Checks that judge one value or one word of bits at a time. Those in which no check has found anything are settled.

The next version of a device, the device with a misprint, and the device after a save mostly have the same objects. A
settled object is not judged again as long as it, and the enums and words that it names, are the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from operator import is_

from fieldspec.foundation.caches import ByIdentity, ObjectsKey
from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_Relatives = tuple[object, ...]

_SETTLED: ByIdentity[Fact, _Relatives] = ByIdentity(limit=20_000)
"""The settled facts, with the enums and words that they name."""


class OpenFacts:
    """The facts of a device that are not settled, with what they name, and those in which a check finds something."""

    verdicts_of_wrong = 0
    """How often a check of single facts has found something."""

    def __init__(self, device: Device) -> None:
        enums = {name: tuple(device.enums.get(bit.enum) for bit in word.bits) for name, word in device.flags.items()}
        self.words = [(word, enums[name]) for name, word in device.flags.items() if _is_open(word, enums[name])]
        self.values = [
            (fact, value, relatives)
            for fact, value in values(device)
            if _is_open(
                fact,
                relatives := (
                    device.enums.get(value.enum),
                    device.flags.get(value.flags),
                    *enums.get(value.flags, ()),
                ),
            )
        ]
        self.wrong: set[int] = set()
        self.unfinished = 0

    def judged(self, fact: Fact, findings: Iterable[Diagnostic]) -> list[Diagnostic]:
        """The findings of a check in a fact."""
        result = [*findings]
        if result:
            self.wrong.add(id(fact))
            OpenFacts.verdicts_of_wrong += 1
        return result


_OPEN: dict[ObjectsKey, OpenFacts] = {}
"""Those of the last device: many checks in a row ask for them."""


def _open_facts(device: Device) -> OpenFacts:
    key = ObjectsKey((device.enums, device.flags, values(device)))
    if key not in _OPEN:
        _OPEN.clear()
        _OPEN[key] = OpenFacts(device)
    return _OPEN[key]


def _is_open(fact: Fact, relatives: _Relatives) -> bool:
    if fact not in _SETTLED:
        return True
    settled = _SETTLED[fact]
    return len(settled) != len(relatives) or not all(map(is_, settled, relatives))


def of_values(device: Device, judge: Callable[[Fact, Value], Iterable[Diagnostic]]) -> Findings:
    """The findings of a check in values, each of which it judges by the value, its enum, and its word of bits."""
    open_facts = _open_facts(device)
    open_facts.unfinished += 1
    for fact, value, _ in open_facts.values:
        yield from open_facts.judged(fact, judge(fact, value))
    open_facts.unfinished -= 1


def of_words(device: Device, judge: Callable[[Flags], Iterable[Diagnostic]]) -> Findings:
    """The findings of a check in words of bits, each of which it judges by the word and the enums of its bits."""
    open_facts = _open_facts(device)
    open_facts.unfinished += 1
    for word, _ in open_facts.words:
        yield from open_facts.judged(word, judge(word))
    open_facts.unfinished -= 1


def settle(device: Device) -> None:
    """Settles what all checks have judged in a device, unless one has ended early."""
    open_facts = _open_facts(device)
    if open_facts.unfinished:
        return
    judged_facts: list[tuple[Fact, _Relatives]] = [*open_facts.words]
    judged_facts += ((fact, relatives) for fact, _, relatives in open_facts.values)
    for fact, relatives in judged_facts:
        if id(fact) not in open_facts.wrong:
            _SETTLED[fact] = relatives
