"""Units as names, scaled properties, and conversions between counts and quantities."""

from __future__ import annotations

from fieldspec.codec.layout.exponents import exponent_of
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_real
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import OUT_OF_RANGE, Conversion, Value
from fieldspec.targets.fact_texts import described, sentence, unit_word
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.registers import absent_states, stated_arguments, value_expression
from fieldspec.targets.python.scaling import in_unit, ratio
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import docstring, literal
from fieldspec.targets.python.writing import interval_text, pairs, tuple_of, within


@dataclass(frozen=True, slots=True)
class ScaledView:
    """A property in the unit: the expressions that read and set it, and its docstring.

    `type` is the type when it is read, `accepted` the type that it can be set to. `takes_none`:
    None is a value of its own.
    """

    name: str
    type: str
    accepted: str
    read: str
    write: str
    field: str
    doc: list[str]
    takes_none: bool = False


@dataclass(frozen=True, slots=True)
class StateView:
    """A property with the name of the state that a field stands for."""

    name: str
    type: str
    read: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class ConstantView:
    """An attribute of a class that is the same for all its objects, with its docstring."""

    name: str
    value: str
    doc: list[str]


def sentinel_views(stored: list[Slots], scope: Scope) -> list[ConstantView]:
    """The views of the sentinels of all fields; for a field with cases, of each case."""
    return [
        ConstantView(
            scope.take((Name.of(name) + Name.of(sentinel.name)).upper()),
            'float("nan")' if sentinel.is_nan else interval_text(sentinel.interval),
            docstring([sentence(f"`{field.title}`: {sentinel.doc or Name.of(sentinel.name).title()}")], 4),
        )
        for field in stored
        for name, value in _values(field)
        for sentinel in value.sentinels
    ]


def _values(field: Slots) -> list[tuple[str, Value]]:
    """The value of a field, or those that it may have, by names that differ."""
    if field.field.value is not None:
        return [(field.title, field.value)]
    return [(f"{field.title}_{case.name}", case.value) for case in field.field.cases]


def _of_float(field: Slots, scope: Scope) -> ScaledView:
    """The property of a floating-point number, which is in its unit already, but may stand for an absent value."""
    name = scope.take(f"{field.title}_{unit_word(field.value.unit) if field.value.unit else 'value'}")
    raw = "item" if field.is_list else f"self.{field.name}"
    tests = [f"{raw} == {number}" for number, _ in field.sentinels] + [f"{raw} != {raw}"] * field.value.absent_nan
    read = f"None if {' or '.join(tests)} else {raw}"
    unit = f" in {field.value.unit}" if field.value.unit else ""
    item, ranges = "item" if field.is_list else "value", pairs(field.ranges) or "()"
    write = f'_real_or_absent("{field.title}", {item}, {field.value.size}, {ranges}, {absent_states(field.value)})'
    text = f"`{field.name}`{unit}. It is None where the number stands for an absent value. {_of_none(field)}"
    return ScaledView(
        name,
        "list[float | None]" if field.is_list else "float | None",
        "_Sequence[_Quantity | None]" if field.is_list else "_Quantity | None",
        f"[{read} for item in self.{field.name}]" if field.is_list else read,
        f"[{write} for item in value]" if field.is_list else write,
        field.name,
        docstring([f"{text} Raises CodecError out of range."], 8),
        not field.is_list,
    )


def _state_arguments(field: Slots, value: Value) -> list[str]:
    """What `state_of` takes of a value: its sentinels, its intervals, the fields of its bits; none where none is."""
    stated = stated_arguments(field.words, value)
    return [absent_states(value), *stated] if value.sentinels or stated else []


def _decided_states(field: Slots, selector: Slots | None) -> str:
    """The arguments of `state_of` for a field whose type another one decides."""
    assert selector is not None
    if not selector.stored:  # a constant
        chosen = next((case.value for case in field.field.cases if selector.constant in case.numbers), None)
        return ", ".join(_state_arguments(field, chosen)) if chosen is not None else ""
    rows = [
        f"{number}: {tuple_of(arguments)}"
        for case in field.field.cases
        if (arguments := _state_arguments(field, case.value))
        for number in sorted(case.numbers)
    ]
    bits = field.field.deciding_bits
    number = f"self.{selector.name}" if bits is None else f"self.{selector.name}.raw & {bits}"
    return f"*{{{', '.join(rows)}}}.get({number}, ())"


def _of_none(field: Slots) -> str:
    """The sentence on setting a quantity to None."""
    names = [sentinel.name for sentinel in field.value.sentinels]
    if len(names) == 1:
        return f"None sets {names[0]}."
    return f"None is refused: set `{field.name}` to that of {' or '.join(names)}."


def state_views(stored: list[Slots], scope: Scope, shaped: RecordShape) -> list[StateView]:
    """The properties with the names of states, of all fields with sentinels, and of those that may be out of range."""
    views = []
    for field in stored:
        arguments = [own for _, value in _values(field) if (own := _state_arguments(field, value))]
        if not arguments:
            continue
        has_value = field.field.value is not None
        states = ", ".join(arguments[0]) if has_value else _decided_states(field, shaped.selector_of(field))
        read = (
            f"_state_of({', '.join(['item' if field.is_list else f'self.{field.name}', *([states] * bool(states))])})"
        )
        views.append(
            StateView(
                scope.take(f"{field.title}_state"),
                "list[str | None]" if field.is_list else "str | None",
                f"[{read} for item in self.{field.name}]" if field.is_list else read,
                docstring([f"The state of `{field.name}`: {_state_names(field)}; None for any other value."], 8),
            )
        )
    return views


def _state_names(field: Slots) -> str:
    """The names that a state may have: `not_measured`, `out_of_range`"""
    values = [value for _, value in _values(field)]
    names = [sentinel.name for value in values for sentinel in value.sentinels]
    names += [OUT_OF_RANGE] * any(stated_arguments(field.words, value) for value in values)
    return ", ".join(dict.fromkeys(names))


def scaled_views(stored: list[Slots], scope: Scope) -> list[ScaledView]:
    """The properties of all fields with a scale."""
    views = []
    for field in stored:
        if field.encoding is not None and is_real(field.encoding) and field.value.sentinels:
            views.append(_of_float(field, scope))
        if not field.whole or not field.value.scaled or field.value.enum or field.value.flags:
            continue
        scale = ratio(field.value)
        name = scope.take(f"{field.title}_{unit_word(field.value.unit)}")
        limits = pairs(Ranges(tuple(field.value.quantity_intervals)))
        function, item = "_counts", "item" if field.is_list else "value"
        arguments = f'"{field.title}", {item}, {scale}, {limits}'
        if field.sentinels:
            function, arguments = "_counts_or_absent", f"{arguments}, {absent_states(field.value)}"
        write = f"{function}({arguments})"
        raw = "item" if field.is_list else f"self.{field.name}"
        read = in_unit(raw, scale)
        kind = "float"
        if field.sentinels:
            absent = within(raw, Ranges(field.sentinels))
            read, kind = f"None if {absent} else {read}", "float | None"
        unit = f" in {field.value.unit}" if field.value.unit else ""
        ends = f"It is None where the count stands for an absent value. {_of_none(field)} " if field.sentinels else ""
        accepted = "_Quantity | None" if field.sentinels else "_Quantity"
        ends += "Setting it stores the nearest count, of two the even one. Raises CodecError out of range."
        views.append(
            ScaledView(
                name,
                f"list[{kind}]" if field.is_list else kind,
                f"_Sequence[{accepted}]" if field.is_list else accepted,
                f"[{read} for item in self.{field.name}]" if field.is_list else read,
                f"[{write} for item in value]" if field.is_list else write,
                field.name,
                docstring([f"`{field.name}`{unit}. {ends}"], 8),
                bool(field.sentinels) and not field.is_list,
            )
        )
    return views


def power_views(
    record: RecordLayout, stored: list[Slots], scope: Scope, constants: Scope, owner: str
) -> tuple[list[ConstantView], list[ScaledView]]:
    """The units of all fields with an exponent, and the properties of those whose exponent is in the same record.

    `owner` is the class of the record.
    """
    units, views = [], []
    for field in stored:
        exponent = exponent_of(field.value, field.words.registers, record) if field.field.value is not None else None
        if exponent is None:
            continue
        unit = constants.take(f"{Name.of(field.title).upper()}_UNIT")
        places = [field.field, exponent.field] if exponent.field is not None else [field.field, exponent.register]
        values = [
            value_expression(value, place.order, place.swapped, field.words)
            for value, place in zip((field.value, exponent.value), places, strict=True)
            if place is not None
        ]
        holder = "the field" if exponent.field is not None else "the register"
        units.append(
            ConstantView(
                unit,
                f"_PowerUnit({literal(field.title)}, {values[0]}, {literal(exponent.name)}, {values[1]})",
                docstring([f"The unit of `{field.name}`, by the exponent in {holder} `{exponent.name}`."], 4),
            )
        )
        exponent_slot = next((other for other in stored if other.field is exponent.field), None)
        if exponent_slot is None:
            continue
        arguments = f"{{}}, self.{exponent_slot.name}"
        raw = "item" if field.is_list else f"self.{field.name}"
        read = f"{owner}.{unit}.in_unit({arguments.format(raw)})"
        write = f"{owner}.{unit}.from_unit({arguments.format('item' if field.is_list else 'value')})"
        kind = "float | None"
        symbol = field.value.quantity_unit
        text = f"`{field.name}`{f' in {symbol}' if symbol else ''}, by the exponent in `{exponent_slot.name}`."
        ends = "It is None where either stands for an absent value. Setting it stores the nearest count."
        ends += f" {_of_none(field)}" if field.sentinels else ""
        accepted = "_Quantity | None" if field.sentinels else "_Quantity"
        views.append(
            ScaledView(
                scope.take(f"{field.title}_{unit_word(symbol)}"),
                f"list[{kind}]" if field.is_list else kind,
                f"_Sequence[{accepted}]" if field.is_list else accepted,
                f"[{read} for item in self.{field.name}]" if field.is_list else read,
                f"[{write} for item in value]" if field.is_list else write,
                field.name,
                docstring([f"{text} {ends} Raises CodecError for an invalid exponent, and out of range."], 8),
            )
        )
    return units, views


@dataclass(frozen=True, slots=True)
class ConversionView:
    """The names of the two functions, the constant that they use, the call that creates it, and their docstrings."""

    name: str
    inverse: str
    constant: str
    call: str
    doc: list[str]
    inverse_doc: list[str]


def conversion_view(conversion: Conversion, device: Device, scope: Scope) -> ConversionView:
    """The view of a conversion."""
    full_scale = f"{conversion.full_scale:#x}"
    arguments = [literal(conversion.name), full_scale, pairs(_ranges(conversion, device))]
    arguments += ["complement=True"] if conversion.complement else []
    formula = f"reference * {f'(1 - raw / {full_scale})' if conversion.complement else f'raw / {full_scale}'}"
    printed = f"Printed: {sentence(conversion.printed)}" if conversion.printed else ""
    signal_names = ", ".join(f"`{name}`" for name in conversion.signals)
    count_doc = (
        f"The count is that of {signal_names}." if signal_names else f"The count is of type {conversion.type.name}."
    )
    references = " or ".join(_reference(path, device) for path in conversion.references)
    reference_doc = f" The device holds it in {references}." if references else ""
    paragraphs = [count_doc, f"The quantity is in the unit of the reference.{reference_doc}", printed]
    title = sentence(conversion.title or Name.of(conversion.name).title())
    inverse_doc = [
        f"The count that is nearest to a quantity; of two the even one. {title}",
        *paragraphs[:2],
        "Raises CodecError where the quantity is out of range, and where the reference is 0.",
    ]
    return ConversionView(
        name=scope.take(f"{conversion.name}_from_raw"),
        inverse=scope.take(f"{conversion.name}_to_raw"),
        constant=f"_{Name.of(conversion.name).upper()}_CONVERSION",
        call=f"_Conversion({', '.join(arguments)})",
        doc=docstring(described(f"{title.rstrip('.')}: {formula}", conversion, *paragraphs), 4),
        inverse_doc=docstring(inverse_doc, 4),
    )


def _ranges(conversion: Conversion, device: Device) -> Ranges:
    """The ranges of the signals where all have the same ones, else the range of the type."""
    signal_ranges = {device.signals[name].value.ranges for name in conversion.signals}
    ranges = signal_ranges.pop() if len(signal_ranges) == 1 else None
    return ranges or Ranges(((conversion.type.low, conversion.type.high),))


def _reference(path: str, device: Device) -> str:
    """Where a reference value is: `Pt317 (reference_speed, in rpm)`, or the name of another fact."""
    *_, owner, name = path.split("/")
    parameter_set = device.parameters.get(owner)
    row = (
        next((parameter for parameter in parameter_set.parameters if parameter.name == name), None)
        if parameter_set is not None
        else None
    )
    if parameter_set is None or row is None:
        return f"`{name}`"
    unit = f", in {row.value.unit}" if row.value.unit else ""
    return f"{row.printed_name or parameter_set.number_text(row.number)} (`{name}`{unit})"
