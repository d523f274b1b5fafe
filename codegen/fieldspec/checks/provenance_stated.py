"""Every fact says where it comes from, and in one way: a computed example cites no line of the manual, a standard has
its name and its clause, what is inferred has a reason, and a report says something that the fact itself does not.

Why: a line of the manual is evidence. Where a frame that we have computed cites one, or what a standard gives looks
printed, nobody can tell evidence from our own work; and what is reported must never pass for what is printed.

Example: `origin: computed` beside `source: 8.4 L1790`, or `reported: [{by: a program, how: in its code, unit: mm}]`
on a register with `unit: mm`.

Cure: Take the source, the reason or the report away, or give what is missing.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import facts
from fieldspec.checks.finding import finding
from fieldspec.checks.inferred_keys_present import has_key
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import COMPUTED, Fact

_RULE = "provenance_stated"


def provenance_stated(device: Device) -> Iterator[Diagnostic]:
    for fact in facts(device):
        if fact.inferred or fact.standard or fact.reported:
            yield from _inferred(fact)
            yield from _standard(fact)
            yield from _reported(fact)
    for line in device.lines:
        if line.like and not line.inferred.strip():
            text = f"nothing says why the line {line.name} is like {line.like}"
            help = "give the reason under `inferred` of the line"
            yield finding(_RULE, device.place, "id", text, help)
    for example in device.examples.values():
        if example.origin == COMPUTED and "source" in example.place:
            text = f"{example.id} is computed and cites the manual, which does not print it"
            yield finding(
                _RULE, example.place, "source", text, "take the source away; say under `notes` how it is made"
            )


def _inferred(fact: Fact) -> Iterator[Diagnostic]:
    for key, reason in fact.inferred.items():
        if not reason.strip():
            text = f"nothing says why `{key}` of {fact.name} is inferred"
            yield finding(_RULE, fact.place, "inferred", text, "give the reason")


def _standard(fact: Fact) -> Iterator[Diagnostic]:
    for key, standard in fact.standard.items():
        for what, text in (("name", standard.name), ("clause", standard.clause)):
            if not text.strip():
                text = f"the standard for `{key}` of {fact.name} has no {what}"
                yield finding(_RULE, fact.place, "standard", text, f"give its {what}")
        if not has_key(fact, key):
            text = f"{fact.name} has no `{key}` that a standard could give"
            yield finding(_RULE, fact.place, "standard", text, "give it, or take the standard out")
        if key in fact.inferred:
            text = f"`{key}` of {fact.name} is inferred and given by a standard"
            yield finding(_RULE, fact.place, "standard", text, "say one of the two")


def _reported(fact: Fact) -> Iterator[Diagnostic]:
    for report in fact.reported:
        if not report.values:
            text = f"nothing says what is reported of {fact.name}"
            yield finding(_RULE, report.place, "by", text, "give the unit, the scale, or what else is reported")
        for what, text in (("by", report.by), ("how", report.how)):
            if not text.strip():
                text = f"nothing says {'who reports it' if what == 'by' else 'how they know it'} of {fact.name}"
                yield finding(_RULE, report.place, what, text, "name the program or the person, and where it shows")
        for key in report.values:
            if key != "doc" and key in fact.place:
                text = f"`{key}` of {fact.name} is reported, and the fact has it too"
                yield finding(
                    _RULE, report.place, key, text, "a reported value is no value of the fact: keep one of them"
                )
