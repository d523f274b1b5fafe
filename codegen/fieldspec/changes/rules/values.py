"""Rules about how a value is encoded and scaled."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.attributes import ALL, PYTHON
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair, Values
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.device import Device
from fieldspec.model.enums import Flags
from fieldspec.model.link import Link, Part
from fieldspec.model.record import Field
from fieldspec.model.registers import Table
from fieldspec.model.value import Conversion, Value


def type_changed(both: Comparison) -> Iterator[Change]:
    """A value has another type or another size, or a record lies where another one, or a value, lay.

    Why: the bytes are read as another number, and what follows them in a frame moves.

    Example: `type: i16` that becomes `type: i32`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for values in both.all_values:
        if values.old.size != values.new.size or (values.old.type != values.new.type and not values.reserved):
            yield _change(values, "type", _of(values.old), _of(values.new), named(values.of.new))
    for word in both.of(Flags):
        if word.old.type != word.new.type:
            yield _change(word, "type", word.old.type.name, word.new.type.name, named(word.new))
    for table in both.of(Table):
        record = both.renamed_to("records", table.old.record)
        if record != table.new.record:
            yield _change(table, "record", record, table.new.record, named(table.new))
    for field in both.of(Field):
        record = both.renamed_to("records", field.old.record)
        old, new = _content(field.old, record), _content(field.new, field.new.record)
        if record != field.new.record or old[0] != new[0]:
            yield _change(field, new[0], old[1], new[1], named(field.new))
    for part in both.of(Part):
        if (part.old.value is None) != (part.new.value is None):
            yield _change(part, "type", _of(part.old.value), _of(part.new.value), named(part.new))


def _of(value: Value | None) -> str:
    if value is None:
        return ""
    return value.type.name if value.type.size else f"{value.type.name} of {value.size} bytes"


def _content(field: Field, record: str) -> tuple[str, str]:
    """The key that says what lies in a field, and what that is."""
    if field.choice is not None:
        return "choice", f"a choice by {field.choice.by}"
    return ("record", record) if record else ("type", _of(field.value))


def _change(
    pair: Values | Pair[Flags] | Pair[Table] | Pair[Field] | Pair[Part], key: str, old: str, new: str, name: str
) -> Change:
    return change("type_changed", Effect.WIRE, pair, key, f"{name}: {turned('the type', old, new)}", old, new, ALL)


def scale_changed(both: Comparison) -> Iterator[Change]:
    """One count is worth something else.

    Why: the same number on the wire is ten times the distance, or a tenth of it.

    Example: `scale: 0.01` that becomes `scale: 0.001`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for values in both.values:
        for key, old, new in (
            ("scale", values.old.scale, values.new.scale),
            ("offset", values.old.offset, values.new.offset),
        ):
            if old != new:
                text = f"{named(values.of.new)}: {turned('the ' + key, old, new)}"
                yield change("scale_changed", Effect.WIRE, values, key, text, old, new)


def unit_changed(both: Comparison) -> Iterator[Change]:
    """A quantity is in another unit.

    Why: the same number is millimetres where it was pulses.

    Example: `unit: pulse` that becomes `unit: mm`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for values in both.values:
        old, new = values.old.unit, values.new.unit
        if old != new:
            text = f"{named(values.of.new)}: {turned('the unit', old, new)}"
            yield change("unit_changed", Effect.WIRE, values, "unit", text, old, new, (PYTHON,))


def sentinel_changed(both: Comparison) -> Iterator[Change]:
    """A value that stands for something else than a quantity has come, has gone, or is another one.

    Why: 0xFFFF that meant `ignore` is a distance now, or a distance means `ignore`.

    Example: `sentinels: [{value: 0xFFFF, name: ignored}]` that loses its only member.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for values in both.values:
        if values.old.sentinels != values.new.sentinels:
            yield from _compared(values)


def _compared(values: Values) -> Iterator[Change]:
    name = named(values.of.new)
    old, new = (
        {(sentinel.value, sentinel.text): sentinel.name for sentinel in value.sentinels}
        for value in (values.old, values.new)
    )
    for key in sorted(old.keys() | new.keys()):
        count, value = key
        if key not in new:
            text = f"{name}: {value} no longer stands for {old[key]}"
            yield _sentinel_change(values, Effect.WIRE, text, f"{value} {old[key]}", "")
        elif key not in old:
            effect = Effect.WIRE if _possible(values.old, count) else Effect.BEHAVIOUR
            yield _sentinel_change(values, effect, f"{name}: {value} stands for {new[key]}", "", f"{value} {new[key]}")
        elif old[key] != new[key]:
            text = f"{name}: {value} is called {new[key]}, and was called {old[key]}"
            yield _sentinel_change(values, Effect.SOURCE, text, f"{value} {old[key]}", f"{value} {new[key]}", (PYTHON,))


def _possible(value: Value, count: int) -> bool:
    """Whether a count was a quantity."""
    return value.ranges is None or count in value.ranges


def _sentinel_change(
    values: Values, effect: Effect, text: str, old: str, new: str, outputs: tuple[str, ...] = ()
) -> Change:
    return change("sentinel_changed", effect, values, "sentinels", text, old, new, outputs)


def const_changed(both: Comparison) -> Iterator[Change]:
    """The one value that a field may have is another one.

    Why: frames with the old value are refused, and so are those of the old side.

    Example: `const: 0x44` that becomes `const: 0x45`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for values in both.all_values:
        old, new = values.old.const, values.new.const
        if old != new:
            text = f"{named(values.of.new)}: {turned('the constant', old, new)}"
            yield change("const_changed", Effect.WIRE, values, "const", text, old, new)


def byte_order_changed(both: Comparison) -> Iterator[Change]:
    """The bytes of a value, or the words of values of several registers, follow each other in another order.

    Why: every number of more than one byte is read as another one.

    Example: `byte_order: big` at a link that becomes `byte_order: little`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for link in both.of(Link):
        for key in ("byte_order", "word_order"):
            old, new = getattr(link.old, key) or "big", getattr(link.new, key) or "big"
            if old != new:
                text = f"{named(link.new)}: {turned('the ' + key.replace('_', ' '), old, new)}"
                yield change("byte_order_changed", Effect.WIRE, link, key, text, old, new)
    for part in both.of(Part):
        if part.old.algorithm and part.new.algorithm:
            old, new = part.old.byte_order or "little", part.new.byte_order or "little"
            if old != new:
                text = f"{named(part.new)}: {turned('the byte order of the check', old, new)}"
                yield change("byte_order_changed", Effect.WIRE, part, "byte_order", text, old, new)
    for values in both.values:
        if values.old.byte_order != values.new.byte_order and _ordered(values.old) and _ordered(values.new):
            old, new = _order(values.old, both.old), _order(values.new, both.new)
            if old != new:
                text = f"{named(values.of.new)}: {turned('the byte order', old, new)}"
                yield change("byte_order_changed", Effect.WIRE, values, "byte_order", text, old, new)


def _ordered(value: Value) -> bool:
    return value.type.size > 1


def _order(value: Value, device: Device) -> str:
    return value.byte_order or device.byte_order


def conversion_changed(both: Comparison) -> Iterator[Change]:
    """A count stands for another share of its reference.

    Why: the same count is another speed, torque or distance.

    Example: `full_scale: 0x4000` that becomes `full_scale: 0x40000000`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in both.of(Conversion):
        paths = tuple(map(both.renamed_path, pair.old.references))
        renamed = tuple(both.renamed_to("signals", name) for name in pair.old.signals)
        for key, what, old, new in (
            ("full_scale", "the full scale", pair.old.full_scale, pair.new.full_scale),
            ("complement", "taking away from the reference", pair.old.complement, pair.new.complement),
            ("type", "the type of the count", pair.old.type.name, pair.new.type.name),
            ("signals", "what it holds for", renamed, pair.new.signals),
            ("references", "what holds the reference", paths, pair.new.references),
        ):
            if old != new:
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("conversion_changed", Effect.WIRE, pair, key, text, old, new)
