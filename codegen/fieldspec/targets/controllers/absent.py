"""Sentinels that are not a number, which functions for programmable controllers cannot tell from a disturbance."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.routines.world import every_record


def absent_reals(layout: DeviceLayout, dialect: Dialect) -> list[Refusal]:
    """A refusal of each value of which a NaN is a sentinel."""
    refusals = []
    refused_facts: set[int] = set()
    for fact, value in stated_values(layout):
        sentinel = next((sentinel for sentinel in value.sentinels if sentinel.is_nan), None)
        if sentinel is not None and id(fact) not in refused_facts:
            refused_facts.add(id(fact))
            text = f"the sentinel {sentinel.name} of {fact.name} is a NaN, which {dialect.title} refuses as no number"
            finding = Diagnostic("plc_reals_present", text, fact.place["sentinels"], help=LEAVE_OUT)
            refusals.append(Refusal(fact, finding))
    return refusals


def stated_values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value]]:
    """Every fact with a value that functions convert."""
    for register in layout.registers:
        yield register.register, register.register.value
    for record in every_record(layout):
        for field in record.fields:
            if field.value is not None:
                yield field.field, field.value
            yield from ((case.case, case.value) for case in field.cases)
    for parameter_set in layout.device.parameters.values():
        for parameter in parameter_set.parameters:
            yield parameter, parameter.value
            yield from ((inner, inner.value) for inner in parameter.subindices)
