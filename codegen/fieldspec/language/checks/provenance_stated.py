"""Every fact states exactly one origin: a computed example cites no line of the manual, a standard has a name
and a clause, an inferred value has a reason, and a report states only what the fact does not state.

Why: a line of the manual is evidence. If a computed frame cites a line, or a value from a standard looks printed,
evidence cannot be distinguished from our own work. A reported value must never look printed.

Example: `origin: computed` with `source: 8.4 L1790`, or `reported: [{by: a program, how: in its code, unit: mm}]` on a
register with `unit: mm`.

Fix: Remove the source, the reason or the report, or add what is missing.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.checks.inferred_keys_present import has_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import COMPUTED, Fact


def provenance_stated(device: Device) -> Findings:
    for fact in facts(device):
        if fact.inferred or fact.standard or fact.reported:
            yield from _inferred(fact)
            yield from _standard(fact)
            yield from _reported(fact)
    for line in device.lines:
        if line.like and not line.inferred.strip():
            text = f"there is no reason why the line {line.name} is like {line.like}"
            help = "add the reason under `inferred` of the line"
            yield finding(device.place, "id", text, help)
    for example in device.examples.values():
        if example.origin == COMPUTED and "source" in example.place:
            text = f"{example.id} is computed, but cites the manual"
            yield finding(
                example.place, "source", text, "remove the source, and state under `notes` how the example is computed"
            )


def _inferred(fact: Fact) -> Findings:
    for key, reason in fact.inferred.items():
        if not reason.strip():
            text = f"there is no reason why `{key}` of {fact.name} is inferred"
            yield finding(fact.place, "inferred", text, "add the reason")


def _standard(fact: Fact) -> Findings:
    for key, standard in fact.standard.items():
        for key_name, text in (("name", standard.name), ("clause", standard.clause)):
            if not text.strip():
                text = f"the standard for `{key}` of {fact.name} has no {key_name}"
                yield finding(fact.place, "standard", text, f"add its {key_name}")
        if not has_key(fact, key):
            text = f"{fact.name} has no `{key}` for the standard to define"
            yield finding(fact.place, "standard", text, "add it, or remove the standard")
        if key in fact.inferred:
            text = f"`{key}` of {fact.name} is both inferred and defined by a standard"
            yield finding(fact.place, "standard", text, "state only one of the two")


def _reported(fact: Fact) -> Findings:
    for report in fact.reported:
        if not report.values:
            text = f"the report about {fact.name} states no value"
            yield finding(report.place, "by", text, "add the unit, the scale, or another reported value")
        for key_name, text in (("by", report.by), ("how", report.how)):
            if not text.strip():
                text = f"the report about {fact.name} has no `{key_name}`"
                yield finding(report.place, key_name, text, "name the program or the person, and where it shows")
        for key in report.values:
            if key != "doc" and key in fact.place:
                text = f"`{key}` of {fact.name} is reported, but the fact has it too"
                yield finding(
                    report.place, key, text, "a reported value is not a value of the fact: remove one of them"
                )
