"""Rules about how a value is encoded and scaled."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.changes.attributes import ALL, PYTHON
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, ValuePair
from fieldspec.language.changes.descriptions import change, changed, difference, difference_text, named
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Table
from fieldspec.language.model.text_form import TextForm, text_form_title
from fieldspec.language.model.units import DeclaredUnit
from fieldspec.language.model.value import Conversion, Value


def type_changed(comparison: Comparison) -> Iterator[Change]:
    """The type, the digits or the size of a value, or the record of a field or table, has changed.

    Why: the bytes are read as a different number, and the following data of a frame moves.

    Example: `type: i16` that becomes `type: i32`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in comparison.all_values:
        moves_others = value_pair.old.size != value_pair.new.size and isinstance(value_pair.of.new, Field | Part)
        if (moves_others and value_pair.reserved) or (
            (value_pair.old.size, _encoding(value_pair.old)) != (value_pair.new.size, _encoding(value_pair.new))
            and not value_pair.reserved
        ):
            yield difference(Effect.WIRE, value_pair, "type", "the type", _of(value_pair.old), _of(value_pair.new), ALL)
    for word in comparison.of(Flags):
        if word.old.type != word.new.type:
            yield difference(Effect.WIRE, word, "type", "the type", word.old.type.name, word.new.type.name, ALL)
    for bit in comparison.of(Bit):
        if bit.old.signed != bit.new.signed:
            kinds = {True: "signed", False: "unsigned"}
            yield difference(Effect.WIRE, bit, "signed", "the type", kinds[bit.old.signed], kinds[bit.new.signed], ALL)
    for table in comparison.of(Table):
        record = comparison.renamed_to("records", table.old.record)
        yield from changed(Effect.WIRE, table, "record", "the type", record, table.new.record, ALL)
    for field in comparison.of(Field):
        record = comparison.renamed_to("records", field.old.record)
        old, new = _content(field.old, record), _content(field.new, field.new.record)
        if record != field.new.record or old[0] != new[0]:
            yield difference(Effect.WIRE, field, new[0], "the type", old[1], new[1], ALL)
    for part in comparison.of(Part):
        if (part.old.value is None) != (part.new.value is None):
            yield difference(Effect.WIRE, part, "type", "the type", _of(part.old.value), _of(part.new.value), ALL)


def _of(value: Value | None) -> str:
    if value is None:
        return ""
    digits = f" by the codec {value.codec}" if value.codec else f" as {value.digits} digits" if value.digits else ""
    places = f" with {value.places} places" if value.places else ""
    blanks = " with blanks before them" if value.has_blanks else ""
    size = "" if value.type.size and not digits else f" of {value.size} bytes"
    size = f" of at most {value.width} bytes" if value.width else size
    form = f" in {text_form_title(value)}" if value.text_form is not None else ""
    packed = f" in {value.packed_bits} bits" if value.packed_bits else ""
    return f"{value.type.name}{digits}{places}{size}{form}{blanks}{packed}"


def _encoding(value: Value) -> tuple[Primitive, str, str, int, bool, TextForm | None, int, int]:
    """The type in which the bytes of a value are read."""
    form = value.has_blanks, value.text_form, value.width, value.packed_bits
    return value.type, value.digits, value.codec, value.places, *form


def _content(field: Field, record: str) -> tuple[str, str]:
    """The key that gives the type of a field, and the type as text."""
    if field.choice is not None:
        return "choice", f"a choice by {field.choice.by}"
    return ("record", record) if record else ("type", _of(field.value))


def _of_bits(comparison: Comparison) -> Iterator[ValuePair]:
    """The numbers in fields of bits."""
    for pair in comparison.of(Bit):
        yield ValuePair(pair, pair.old.as_value, pair.new.as_value)


def scale_changed(comparison: Comparison) -> Iterator[Change]:
    """The scale, the offset, or the register or field with the exponent of a value has changed.

    Why: the same number on the wire is a different quantity, such as ten times the distance.

    Example: `scale: 0.01` that becomes `scale: 0.001`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in (*comparison.values, *_of_bits(comparison)):
        for key, old, new in (
            ("scale", value_pair.old.scale_number, value_pair.new.scale_number),
            ("offset", value_pair.old.offset, value_pair.new.offset),
        ):
            if key == "offset" or value_pair.old.scale != value_pair.new.scale:
                yield from changed(Effect.WIRE, value_pair, key, "the " + key, old, new)
        exponent = _exponent(comparison, value_pair)
        subject = "the exponent" if isinstance(value_pair.of.new, Field) else "the register of the exponent"
        yield from changed(Effect.WIRE, value_pair, "scale_by", subject, exponent, value_pair.new.scale_by)


def _exponent(comparison: Comparison, pair: ValuePair) -> str:
    """The new name of what has the exponent of an old value: a field beside it, or a register."""
    name = pair.old.scale_by
    if not name:
        return ""
    field_name = comparison.renamed_to(pair.of.old.place.path.rpartition("/")[0], name)
    return field_name if field_name != name else comparison.renamed_to("registers", name)


def unit_changed(comparison: Comparison) -> Iterator[Change]:
    """The unit of a quantity, or the factor of a unit that the spec declares, has changed.

    Why: the same number is in millimetres now, and was in pulses.

    Example: `unit: pulse` that becomes `unit: mm`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in (*comparison.values, *_of_bits(comparison)):
        old, new = value_pair.old.quantity_unit, value_pair.new.quantity_unit
        yield from changed(Effect.WIRE, value_pair, "unit", "the unit", old, new, (PYTHON,))
    for unit in comparison.of(DeclaredUnit):
        for key, subject in (("symbol", "the symbol"), ("quantity", "what it measures"), ("factor", "the factor")):
            before, after = getattr(unit.old, key) or None, getattr(unit.new, key) or None
            if before != after:
                text = f"the unit {named(unit.new)}: {difference_text(subject, before, after)}"
                yield change(Effect.WIRE, unit, key, text, before, after)


def sentinel_changed(comparison: Comparison) -> Iterator[Change]:
    """A sentinel was added, removed or renamed.

    Why: 0xFFFF meant `ignore` and is a distance now, or was a distance and means `ignore`.

    Example: `sentinels: [{value: 0xFFFF, name: ignored}]` that loses its only entry.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in comparison.values:
        if value_pair.old.sentinels != value_pair.new.sentinels:
            yield from _compare_sentinels(value_pair)


def _compare_sentinels(value_pair: ValuePair) -> Iterator[Change]:
    name = named(value_pair.of.new)
    old, new = (
        {(sentinel.interval, sentinel.text): sentinel.name for sentinel in value.sentinels}
        for value in (value_pair.old, value_pair.new)
    )
    for key in sorted(old.keys() | new.keys()):
        interval, value = key
        if key not in new:
            text = f"{name}: {value} no longer stands for {old[key]}"
            yield change(Effect.WIRE, value_pair, "sentinels", text, f"{value} {old[key]}", "")
        elif key not in old:
            effect = Effect.WIRE if _possible(value_pair.old, interval) else Effect.BEHAVIOUR
            text = f"{name}: {value} stands for {new[key]}"
            yield change(effect, value_pair, "sentinels", text, "", f"{value} {new[key]}")
        elif old[key] != new[key]:
            text = f"{name}: {value} is called {new[key]}, and was called {old[key]}"
            names = f"{value} {old[key]}", f"{value} {new[key]}"
            yield change(Effect.SOURCE, value_pair, "sentinels", text, *names, (PYTHON,))


def _possible(value: Value, interval: tuple[int, int]) -> bool:
    """Whether a raw value of an interval was permitted as a quantity."""
    low, high = interval
    return value.ranges is None or any(first <= high and low <= last for first, last in value.ranges.intervals)


def const_changed(comparison: Comparison) -> Iterator[Change]:
    """The constant value of a field has changed.

    Why: each side rejects frames with the other value.

    Example: `const: 0x44` that becomes `const: 0x45`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in comparison.all_values:
        old, new = value_pair.old.const, value_pair.new.const
        yield from changed(Effect.WIRE, value_pair, "const", "the constant", old, new)


def byte_order_changed(comparison: Comparison) -> Iterator[Change]:
    """The bytes of a value, or the words of a value in several registers, are in a different order.

    Why: every number of more than one byte is misread.

    Example: `byte_order: big` at a link that becomes `byte_order: little`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for link in comparison.of(Link):
        for key in ("byte_order", "word_order"):
            old, new = (_device_order(device, key) for device in (comparison.old, comparison.new))
            if old != new and getattr(link.old, key) != getattr(link.new, key):
                yield from changed(Effect.WIRE, link, key, "the " + key.replace("_", " "), old, new)
    for part in comparison.of(Part):
        if all(side.algorithm and checksum_named(side.algorithm).has_order for side in (part.old, part.new)):
            old, new = part.old.byte_order or "little", part.new.byte_order or "little"
            yield from changed(Effect.WIRE, part, "byte_order", "the byte order of the checksum", old, new)
    for value_pair in comparison.values:
        for key in ("byte_order", "word_order", "write_word_order"):
            if getattr(value_pair.old, key) == getattr(value_pair.new, key):
                continue
            if _ordered(value_pair.old, key) and _ordered(value_pair.new, key):
                old, new = _order(value_pair.old, comparison.old, key), _order(value_pair.new, comparison.new, key)
                yield from changed(Effect.WIRE, value_pair, key, "the " + key.replace("_", " "), old, new)


def _ordered(value: Value, key: str) -> bool:
    return value.has_words if key != "byte_order" else value.has_order or value.is_as_sent


def _order(value: Value, device: Device, key: str) -> str:
    """The order of a value: its own, or that of its device, whose words have the order of its bytes by default."""
    own: str = getattr(value, key)
    if value.is_as_sent:
        return own or "big"
    if key == "write_word_order":
        return own or _order(value, device, "word_order")
    if key == "word_order":
        return own or device.word_order or _order(value, device, "byte_order")
    return own or device.byte_order


def _device_order(device: Device, key: str) -> str:
    """The order of values without their own."""
    return device.byte_order if key == "byte_order" else device.word_order or device.byte_order


def conversion_changed(comparison: Comparison) -> Iterator[Change]:
    """The full scale, the complement, the signals or the references of a conversion have changed.

    Why: the same raw value is a different speed, torque or distance.

    Example: `full_scale: 0x4000` that becomes `full_scale: 0x40000000`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Conversion):
        paths = tuple(map(comparison.renamed_path, pair.old.references))
        renamed = tuple(comparison.renamed_to("signals", name) for name in pair.old.signals)
        for key, subject, old, new in (
            ("full_scale", "the full scale", pair.old.full_scale, pair.new.full_scale),
            ("complement", "subtraction from the reference", pair.old.complement, pair.new.complement),
            ("type", "the type of the count", pair.old.type.name, pair.new.type.name),
            ("signals", "what it applies to", renamed, pair.new.signals),
            ("references", "the reference", paths, pair.new.references),
        ):
            yield from changed(Effect.WIRE, pair, key, subject, old, new)
