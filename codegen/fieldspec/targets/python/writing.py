"""The code that tests a field, writes it into its slots, and explains a refusal."""

from __future__ import annotations

from fieldspec.language.model.enums import Bit
from fieldspec.language.model.primitives import Kind, Primitive
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.value import Value
from fieldspec.targets.python.enums import EnumView
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal

FEW = 3
"""The largest number of comparisons that a test writes out; above it, a table is faster."""


def within(
    number: str, ranges: Ranges, singles: tuple[int, ...] = (), packed: tuple[int | None, int | None] = (None, None)
) -> str:
    """The condition that a number is in one of several intervals, or equals one of some others.

    `packed` are the least and the greatest number that `pack` accepts: the condition does not repeat these limits,
    and is empty where nothing else remains to be tested.
    """
    minimum, maximum = packed
    parts = []
    for low, high in merged([*ranges.intervals, *((value, value) for value in singles)]):
        if low == minimum and high == maximum:
            return ""
        if low == high:
            parts.append(f"{number} == {low}")
        elif low == minimum:
            parts.append(f"{number} <= {high}")
        else:
            parts.append(f"{number} >= {low}" if high == maximum else f"{low} <= {number} <= {high}")
    return parts[0] if len(parts) == 1 else f"({' or '.join(parts)})"


def fixed(field: Slots) -> list[str]:
    """The values of the slots of a constant, or of a reserved field that is not zero."""
    if field.skipped:
        return []
    number = field.constant if field.constant is not None else field.value.default
    assert isinstance(number, int)
    data = number.to_bytes(field.field.size, field.order, signed=field.value.type.signed)
    if field.parted:
        words = [data[index : index + 2] for index in range(0, len(data), 2)]
        halves = words[::-1] if field.field.swapped else words
        signed = field.value.type.signed
        return [
            str(int.from_bytes(half, field.order, signed=signed and letter == "h"))
            for half, letter in zip(halves, field.letters, strict=True)
        ]
    if field.foreign:
        return [_bytes_literal(field.bytes_of(number))] * max(field.count, 1)
    return [str(number)] * max(field.count, 1)


def _bytes_literal(data: bytes) -> str:
    return 'b"' + "".join(f"\\x{byte:02x}" for byte in data) + '"'


def conditions(field: Slots, value: str) -> list[str]:
    """The conditions on the value of a field, except those that `pack` tests itself."""
    tests: list[str] = []
    if field.repeated and field.field.field.repeat is not None:
        lengths = field.field.field.repeat
        tests.append(within(f"len({value})", lengths))
    elif field.is_list:
        tests.append(f"len({value}) == {field.count}")
    if field.decided:
        return tests
    item = "item" if field.is_list else value
    element_tests = _element_lines(field, item)
    if field.is_list:
        return tests + [f"all({condition} for item in {value})" for condition in element_tests]
    return element_tests


def _element_lines(field: Slots, value: str) -> list[str]:
    if field.field.record is not None:
        return []
    size = field.field.size
    if field.kind is Kind.TEXT and field.value.text_form is not None:
        return [f"{text_form(field.value, field.field.order)}.fits({value})"]
    if field.kind is Kind.TEXT:
        # A zero ends the text where it is read.
        return [f"len({value}) <= {size}", f'"\\0" not in {value}']
    if field.kind is Kind.BYTES:
        return [f"len({value}) == {size}"]
    if field.kind is Kind.FLOAT:
        return _float_tests(field, value)
    tests: list[str] = []
    raw = f"{value}.raw" if field.value.flags and not field.deferred else value
    enum = field.enum
    if enum is not None and not enum.open:
        tests.append(_member_test(enum, field, value))
    elif field.kind is Kind.BOOLEAN:
        tests.append(f"{value} <= 1")
    elif field.ranges is not None:
        tests.append(within(raw, field.ranges, field.sentinels, packed(field.value.type)))
    bounded = field.words.bounded.get(field.value.flags, ())
    tests += [within(f"({raw} & {bit.mask:#x})", Ranges(bit.images), (), (0, bit.mask)) for bit in bounded]
    return [test for test in tests if test]


def _float_tests(field: Slots, value: str) -> list[str]:
    """The conditions on a floating-point number. Every comparison with a NaN is false."""
    if field.ranges is None:
        return []
    parts = [f"{low} <= {value} <= {high}" for low, high in field.ranges.intervals]
    parts += [f"{value} == {number}" for number in field.sentinels]
    parts += [f"{value} != {value}"] * field.value.absent_nan
    return [parts[0] if len(parts) == 1 else f"({' or '.join(parts)})"]


def packed(type: Primitive) -> tuple[int, int]:
    """The least and the greatest number that `pack` accepts for a type; for a boolean these are more than 0 and 1."""
    return type.low, (1 << (8 * type.size - type.signed)) - 1


def greatest(field: Slots) -> int:
    """The greatest number that the conditions of an unsigned field accept."""
    if field.kind is Kind.BOOLEAN:
        return 1
    if field.enum is not None and not field.enum.open:
        members = [value for value in field.enum.values if field.ranges is None or value in field.ranges]
        return max([*members, *field.sentinels], default=0)
    if field.ranges is None:
        return packed(field.value.type)[1]
    return max([high for _, high in field.ranges.intervals] + [*field.sentinels])


def _member_test(enum: EnumView, field: Slots, number: str) -> str:
    """The condition that a number is one of the members that the ranges allow, or a sentinel.

    Two comparisons are faster than a look-up, so a table is used only where the members are far apart.
    """
    members = [value for value in enum.values if field.ranges is None or value in field.ranges]
    limits = packed(field.value.type)
    test = (
        within(number, Ranges(tuple((value, value) for value in members)), field.sentinels, limits) if members else ""
    )
    if members and sum(map(test.count, ("<=", ">=", "=="))) <= FEW:
        return test
    known = f"{number} in {enum.table}"
    if field.sentinels:
        known = f"({known} or {within(number, Ranges(tuple((value, value) for value in field.sentinels)))})"
    if field.ranges is None or len(members) == len(enum.values):
        return known
    allowed = within(number, field.ranges, field.sentinels, limits)
    return f"{known} and {allowed}" if allowed else known


def values(field: Slots, expression: str) -> list[str]:
    """The expressions that fill the slots of a field."""
    if field.parted:
        raw = f"{expression}.raw" if field.value.flags and not field.deferred else expression
        parts = [f"{raw} & 65535", *(f"{raw} >> {16 * part} & 65535" for part in range(1, field.parted - 1))]
        parts.append(f"{raw} >> {16 * (field.parted - 1)}")
        return parts if field.big else parts[::-1]
    if not field.is_list:
        return [_item(field, expression)]
    item = _item(field, "item")
    return [f"*{expression}" if item == "item" else f"*[{item} for item in {expression}]"]


def _item(field: Slots, expression: str) -> str:
    if field.field.record is not None:
        return f"{expression}.encode()"
    if field.kind is Kind.TEXT and field.value.text_form is not None:
        return f"{text_form(field.value, field.field.order)}.data({expression})"
    if field.kind is Kind.TEXT:
        return f'{expression}.encode("ascii")'
    raw = f"{expression}.raw" if field.value.flags and not field.deferred else expression
    if not field.foreign:
        return raw
    turned = field.field.swapped
    if field.value.digits:
        return f"{digits_form(field.value, field.field.order, turned)}.data({raw}, {turned})"
    order = "big" if (field.field.order == "big") != turned else "little"
    if field.kind is Kind.FLOAT:
        return f'_float_bytes({raw}, "{">" if order == "big" else "<"}{field.value.type.letter}", {turned})'
    signed = ", signed=True" if field.value.type.signed else ""
    data = f'{raw}.to_bytes({field.field.size}, "{order}"{signed})'
    return f"_turned({data})" if turned else data


def digits_letters(value: Value, order: str, swapped: bool) -> str:
    """What the runtime knows of digits: order and type, their form, the bytes, and the places behind a point."""
    sign = ">" if (order == "big") != swapped else "<"
    form = "blank_decimal" if value.has_blanks else value.digits
    return f"{sign}{value.type.name} {form} {value.size} {value.places}"


def digits_form(value: Value, order: str, swapped: bool) -> str:
    """The expression of what reads and writes the digits of a value."""
    return f"_digits({literal(digits_letters(value, order, swapped))})"


def text_letters(value: Value, order: str) -> str:
    """The arguments of the form of a text: its encoding, its bytes, its padding and its terminator."""
    form = value.text_form
    assert form is not None
    end = "-" if form.terminator is None else str(form.terminator)
    side = "right" if form.is_right else "left"
    return f"{form.codec(order)} {value.size} {form.padding} {end} {side}{' turned' * form.is_turned}"


def text_form(value: Value, order: str) -> str:
    """The expression of the object of the runtime that reads and writes a text in its form."""
    return f"_text_form({literal(text_letters(value, order))})"


def measured(field: Slots, other: Slots, expression: str, decided: str) -> str:
    """The value of a field that measures another one; `decided` is the size of an element with several types."""
    measure = field.field.field.measures
    assert measure is not None
    size = decided if other.decided else str(other.field.size)
    if not other.is_list and not other.decided:
        return str(measure.number(1, other.field.size))
    if not other.is_list:
        return plus(size if measure.of == "bytes" else "1", measure.plus)
    items = f"len({expression})"
    return plus(f"{items} * {size}" if measure.of == "bytes" and size != "1" else items, measure.plus)


def plus(expression: str, number: int) -> str:
    """The sum of an expression and a number."""
    return f"{expression} {'+' if number > 0 else '-'} {abs(number)}" if number else expression


def refusal(field: Slots) -> str:
    """The expression of the refusal of a field: a CodecError, or None."""
    title, attribute = literal(field.title), f"self.{field.name}"
    function, limits = _refusing(field)
    if not field.is_list:
        return f"{function}({', '.join([title, attribute, *limits])})"
    repeat = field.field.field.repeat
    lengths = (repeat.low, repeat.high) if repeat else (field.count, field.count)
    return f"_refused_list({', '.join([title, attribute, *map(str, lengths), function, *limits])})"


def _refusing(field: Slots) -> tuple[str, list[str]]:
    """The function that explains the refusal of one element, and its arguments after name and value."""
    if field.field.record is not None:
        return "_refused_record", [field.element_type]
    size, primitive = str(field.field.size), field.value.type
    if field.kind is Kind.TEXT and field.value.text_form is not None:
        return f"{text_form(field.value, field.field.order)}.refused", []
    if field.kind is Kind.TEXT:
        return "_refused_text", [size]
    if field.kind is Kind.BYTES:
        return "_refused_bytes", [size]
    if field.kind is Kind.FLOAT:
        function = "_refused_float" if size == "4" else "_refused_double"
        if field.ranges is None:
            return function, []
        absent_numbers = [*map(str, field.sentinels), *(['float("nan")'] * field.value.absent_nan)]
        return function, [pairs(field.ranges), *([tuple_of(absent_numbers)] if absent_numbers else [])]
    ranges = pairs(field.ranges)
    if field.value.flags:
        bits = bounded_bits(field.words.bounded.get(field.value.flags, ()))
        return "_refused_flags", [str(primitive.high), *([ranges or "()"] if ranges or bits else []), *bits]
    arguments = [ranges or "()", tuple_of(field.sentinels)]
    if field.enum is not None and not field.enum.open:
        arguments += [field.enum.table, literal(field.enum.title)]
    while arguments and arguments[-1] == "()":
        arguments.pop()
    return "_refused_number", [str(primitive.low), str(primitive.high), *arguments]


def bounded_bits(bits: tuple[Bit, ...]) -> list[str]:
    """The fields of bits that have a range, as one argument: name, mask, what may be in the mask, and a text."""
    if not bits:
        return []
    rows = [
        f"({literal(bit.name)}, {bit.mask:#x}, {pairs(Ranges(bit.images))}, {literal(bit.ranges.text())})"
        for bit in bits
        if bit.ranges is not None
    ]
    return [tuple_of(rows)]


def pairs(ranges: Ranges | None) -> str:
    """Ranges as a tuple of pairs; an empty text for none."""
    return tuple_of(f"({low}, {high})" for low, high in ranges.intervals) if ranges else ""


def tuple_of(items: object) -> str:
    """A tuple of expressions."""
    texts = [str(item) for item in items]  # type: ignore[attr-defined]
    return f"({texts[0]},)" if len(texts) == 1 else f"({', '.join(texts)})"
