"""The data of opened facts: code to copy, the bytes of values on the wire, and quantities with their raw values."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence

from fieldspec.codec.explain.values import in_unit
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, Orders, RecordLayout
from fieldspec.language.model.encoding import is_array, is_count, is_real
from fieldspec.language.model.value import Value
from fieldspec.targets import OUTPUTS
from fieldspec.targets.docs.changes import Step, page_name

NAME = "fact-index.js"
"""The file of a device."""

_CALL = "fieldspecFacts.add("
_END = ");\n"

Row = list[object]


def fact_file(layouts: Sequence[DeviceLayout], steps: Sequence[Step] = ()) -> str:
    """The file of a device: a call with one object, in JSON.

    `pages` has the file and the name of each version, the newest first; bits of masks stand for them. `variables` has
    the texts of `@name@` in templates for each language and version. `templates` are pairs of a language and a text.
    `code` has for each fact rows of a mask, a template and its arguments; `values` has rows of a mask, the bytes of the
    value on the wire, as the significance of each byte, and pairs of a raw value and a quantity. A mask of 0 is all.
    `steps` has for each step between versions their numbers, and rows of a path, an effect and a message.
    """
    newest_first = list(reversed(layouts))
    all_versions = (1 << len(layouts)) - 1
    masks: dict[tuple[str, int, tuple[str, ...]], int] = {}
    templates: dict[tuple[str, str], int] = {}
    variables: dict[str, list[dict[str, str]]] = {}
    for output in OUTPUTS.values():
        usages = output.usages(layouts)
        for number, layout in enumerate(newest_first):
            version = usages.get(layout.device.version)
            if version is None:
                continue
            variables.setdefault(version.language, [{} for _ in layouts])[number] = version.variables
            for usage in version.rows:
                template = templates.setdefault((version.language, usage.template), len(templates))
                key = usage.fact, template, usage.arguments
                masks[key] = masks.get(key, 0) | 1 << number
    code: dict[str, list[Row]] = {}
    for (fact, template, arguments), mask in masks.items():
        code.setdefault(fact, []).append([mask if mask != all_versions else 0, template, *arguments])
    data = {
        "pages": [[page_name(layout.device.version), layout.device.version] for layout in newest_first],
        "variables": variables,
        "templates": list(templates),
        "code": code,
        "values": _values(newest_first, all_versions),
        "steps": [_step(step, [layout.device.version for layout in newest_first]) for step in steps],
    }
    return f"{_CALL}{json.dumps(data, ensure_ascii=False, separators=(',', ':'))}{_END}"


def _step(step: Step, versions: Sequence[str]) -> list[object]:
    rows = [[judged.change.path, judged.change.effect.value, judged.change.message] for judged in step.changes]
    return [versions.index(step.old.device.version), versions.index(step.new.device.version), rows]


def parsed(text: str) -> dict[str, object]:
    """The object in the text of an index file."""
    data: dict[str, object] = json.loads(text.removeprefix(_CALL).removesuffix(_END))
    return data


def _values(newest_first: Sequence[DeviceLayout], all_versions: int) -> dict[str, list[Row]]:
    masks: dict[tuple[str, str, tuple[tuple[int, str], ...]], int] = {}
    for number, layout in enumerate(newest_first):
        for path, wire, quantities in _version_values(layout):
            if wire or quantities:
                key = path, wire, quantities
                masks[key] = masks.get(key, 0) | 1 << number
    rows: dict[str, list[Row]] = {}
    for (path, wire, quantities), mask in masks.items():
        rows.setdefault(path, []).append([mask if mask != all_versions else 0, wire, *quantities])
    return rows


def _version_values(layout: DeviceLayout) -> Iterator[tuple[str, str, tuple[tuple[int, str], ...]]]:
    """The path, the bytes on the wire and the quantities of each value."""
    for register in layout.registers:
        value = register.register.value
        yield register.register.place.path, _wire(value, register.order, register.swapped), _quantities(value)
    records = [*layout.records.values(), *(body for message in layout.messages.values() for body in message.bodies)]
    for record in records:
        for field in _fields(record):
            if field.value is not None:
                wire = _wire(field.value, field.order, field.swapped)
                yield field.field.place.path, wire, _quantities(field.value)
    orders = Orders(layout.device.byte_order, layout.device.word_order)
    for parameter_set in layout.device.parameters.values():
        for row in parameter_set.parameters:
            yield row.place.path, _wire(row.value, *orders.of(row.value)), _quantities(row.value)
    for signal in layout.device.signals.values():
        yield signal.place.path, _wire(signal.value, *orders.of(signal.value)), _quantities(signal.value)


def _fields(record: RecordLayout) -> Iterator[FieldLayout]:
    for field in record.fields:
        yield field
        if field.record is not None:
            yield from _fields(field.record)


def _wire(value: Value, order: str, swapped: bool) -> str:
    """The significance of the bytes in the order in which they are sent: `3210`, or `1032` with the low word first."""
    if is_array(value.encoding) or not 1 < value.size <= 8:
        return ""
    numbers = list(range(value.size))
    if order == "big":
        numbers.reverse()
    if swapped:
        words = [numbers[index : index + 2] for index in range(0, value.size, 2)]
        numbers = [number for word in reversed(words) for number in word]
    return "".join(map(str, numbers))


def _quantities(value: Value) -> tuple[tuple[int, str], ...]:
    """The raw values of round quantities: 1 or 100 of the unit, and the ends of the range."""
    if not value.scaled or not (is_count(value.encoding) or is_real(value.encoding)):
        return ()
    ends = [] if value.ranges is None else [value.ranges.low, value.ranges.high]
    raws = [0, *_round(value), *ends]
    texts = {raw: in_unit(value, raw) for raw in sorted(raws) if value.sentinel(raw) is None}
    return tuple((raw, text) for raw, text in texts.items() if text)


def _round(value: Value) -> Iterator[int]:
    """The raw value of 100 percent, or of 1 and 10 of another unit, where it is a whole number."""
    from fractions import Fraction

    for quantity in (100,) if value.unit == "%" else (1, 10):
        raw = (quantity - Fraction(value.offset)) / Fraction(value.scale)
        if raw.denominator == 1 and (value.ranges is None or int(raw) in value.ranges):
            yield int(raw)
