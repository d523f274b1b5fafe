"""The range of a field that carries the size of another field is from the least to the greatest size of that field. The
field is an unsigned whole number, restricted only by its range, without a scale or names.

Why: the number of bytes or elements follows from the permitted repetitions, and encoders compute it. The manual prints
both limits, so a misprint in one of them shows. A number of bytes or elements is never negative.

Example: `values` has 1 to 60 words, and the byte count has the range `2..127`, but the maximum is 120 bytes.

Fix: Correct the range or the repetitions, and write an erratum for the misprint.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, interval, label, range_key
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.value import Value

_KEYS = ("const", "default", "unit_default", "scale", "offset", "enum", "flags", "sentinels", "parameter")


def measures_match_repeats(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for layer in layers(device):
        for field in layer.fields:
            yield from _compare_sizes(layer, field, sizes)
            if field.measures is not None and field.value is not None:
                yield from _of_number(field, field.value)
            if field.measures is not None and field.value is not None and field.value.type.name[0] == "i":
                text = f"{field.name} counts {field.measures.of} of {field.measures.field}, and {field.value.type.name}"
                help = "use a type without a sign, or allow it with a reason"
                severity = Severity.WARNING
                yield finding(field.place, "type", f"{text} has a sign", help, severity=severity)


def _of_number(field: Field, value: Value) -> Findings:
    """The findings of a field that measures another one and is not a number that encoders compute."""
    assert field.measures is not None
    statement = f"{field.name} counts {field.measures.of} of {field.measures.field}"
    if field.measures.field == field.name:
        yield finding(field.place, "measures", f"{field.name} measures itself", "name another field")
    if not is_count(value.encoding):
        yield finding(field.place, "type", f"{statement}, and is {value.type.name}", "use a whole number")
    for key in _KEYS:
        if key in field.place:
            text = f"{statement}, which encoders compute, so that `{key}` does not apply"
            yield finding(field.place, key, text, "remove it, or remove `measures`")


def _compare_sizes(layer: Record, field: Field, sizes: RecordSizes) -> Findings:
    ranges = field.value.ranges if field.value is not None else None
    measured = layer.named(field.measures.field) if field.measures is not None else None
    if ranges is None or measured is None or measured.repeat is None or field.measures is None:
        return
    size = sizes.element(measured) if field.measures.of == "bytes" else 1
    if size is None:
        return
    plus = field.measures.plus
    low, high = measured.repeat.low * size + plus, measured.repeat.high * size + plus
    if (ranges.low, ranges.high) != (low, high):
        yield finding(
            field.place,
            range_key(field.place),
            f"{field.name} has the range {ranges.text()}, but {measured.name}"
            f" has {interval(low, high)} {field.measures.of}{f' with the {plus} of `plus`' if plus else ''}",
            "correct the range or the repetitions",
            label(measured.place, "repeat", f"{measured.name} is repeated"),
        )
