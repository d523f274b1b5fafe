"""The code that tests a field, writes it into its slots, and explains a refusal."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.digits import digits_arguments
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfPrecision,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_truth,
    struct_letter,
)
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.value import Value
from fieldspec.targets.python.codecs import codec_key
from fieldspec.targets.python.enums import EnumView
from fieldspec.targets.python.runs import image, place_of
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal

FEW = 3
"""The largest number of comparisons that a test writes out; above it, a table is faster."""


def within(
    number: str,
    ranges: Ranges,
    further: Iterable[tuple[int, int]] = (),
    packed: tuple[int | None, int | None] = (None, None),
) -> str:
    """The condition that a number is in one of several intervals, or in one of some further ones.

    `packed` are the least and the greatest number that `pack` accepts: the condition does not repeat these limits,
    and is empty where nothing else remains to be tested.
    """
    minimum, maximum = packed
    parts = []
    for low, high in merged([*ranges.intervals, *further]):
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
    if field.parted:
        data = field.bytes_of(number)
        words = [data[index : index + 2] for index in range(0, len(data), 2)]
        return [
            str(int.from_bytes(word, field.order, signed=letter == "h"))
            for word, letter in zip(words, field.letters, strict=True)
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
    size, encoding = field.field.size, field.value.encoding
    match encoding:
        case Text():
            if encoding.form is not None:
                return [f"{text_form(field.value, field.field.order)}.fits({value})"]
            # A zero ends the text where it is read.
            return [f"len({value}) <= {size}", f'"\\0" not in {value}']
        case Octets():
            return [f"len({value}) == {size}"]
        case Real():
            return _float_tests(field, value)
        case Whole() | Digits() | Truth():
            return _number_tests(field, value)
        case _:
            assert_never(encoding)


def _number_tests(field: Slots, value: str) -> list[str]:
    """The conditions on a whole number, a truth value, a word of bits or a member of an enum."""
    tests: list[str] = []
    raw = f"{value}.raw" if field.value.flags and not field.deferred else value
    enum = field.enum
    if enum is not None and not enum.open:
        tests.append(_member_test(enum, field, value))
    elif is_truth(field.value.encoding):
        tests.append(f"{value} <= 1")
    elif field.ranges is not None:
        tests.append(within(raw, field.ranges, field.sentinels, packed(field.value.encoding)))
    bounded = field.words.bounded(field.value.flags)
    tests += [within(f"({image(raw, bit)})", Ranges(bit.images), (), (0, bit.greatest_image)) for bit in bounded]
    return [test for test in tests if test]


def _float_tests(field: Slots, value: str) -> list[str]:
    """The conditions on a floating-point number. Every comparison with a NaN is false."""
    if field.ranges is None:
        return []
    parts = [f"{low} <= {value} <= {high}" for low, high in field.ranges.intervals]
    parts += [f"{value} == {number}" for number, _ in field.sentinels]
    parts += [f"{value} != {value}"] * field.value.absent_nan
    return [parts[0] if len(parts) == 1 else f"({' or '.join(parts)})"]


def packed(encoding: Encoding) -> tuple[int, int]:
    """The least and the greatest number that `pack` accepts; for a truth value these are more than 0 and 1."""
    match encoding:
        case Truth():
            return Whole(encoding.bits, Sign.NONE).bounds
        case Whole() | Digits() | Real() | Text() | Octets():
            return bounds_of(encoding)
        case _:
            assert_never(encoding)


def greatest(field: Slots) -> int:
    """The greatest number that the conditions of an unsigned field accept."""
    if is_truth(field.value.encoding):
        return 1
    if field.enum is not None and not field.enum.open:
        members = [value for value in field.enum.values if field.ranges is None or value in field.ranges]
        return max([*members, *(high for _, high in field.sentinels)], default=0)
    if field.ranges is None:
        return packed(field.value.encoding)[1]
    return max(high for _, high in (*field.ranges.intervals, *field.sentinels))


def _member_test(enum: EnumView, field: Slots, number: str) -> str:
    """The condition that a number is one of the members that the ranges allow, or a sentinel.

    Two comparisons are faster than a look-up, so a table is used only where the members are far apart.
    """
    members = [value for value in enum.values if field.ranges is None or value in field.ranges]
    limits = packed(field.value.encoding)
    test = (
        within(number, Ranges(tuple((value, value) for value in members)), field.sentinels, limits) if members else ""
    )
    if members and sum(map(test.count, ("<=", ">=", "=="))) <= FEW:
        return test
    known = f"{number} in {enum.table}"
    if field.sentinels:
        known = f"({known} or {within(number, Ranges(field.sentinels))})"
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
    raw = f"{expression}.raw" if field.value.flags and not field.deferred else expression
    turned, encoding = field.field.swapped, field.value.encoding
    match encoding:
        case Text():
            if encoding.form is not None:
                return f"{text_form(field.value, field.field.order)}.data({expression})"
            return f'{expression}.encode("ascii")'
        case Octets():
            return raw
        case Digits():
            return f"{digits_form(field.value, field.field.order, turned)}.data({raw}, {turned})"
        case Real():
            return f"_float_bytes({raw}, {real_letters(field, encoding)}, {turned})" if field.foreign else raw
        case Whole():
            return _foreign_number(field, raw, encoding.sign) if field.foreign else raw
        case Truth():
            return _foreign_number(field, raw, Sign.NONE) if field.foreign else raw
        case _:
            assert_never(encoding)


def _foreign_number(field: Slots, raw: str, sign: Sign) -> str:
    """The bytes of a whole number."""
    arguments, turned = f'{field.field.size}, "{sent_order(field)}"', field.field.swapped
    match sign:
        case Sign.NONE:
            data = f"{raw}.to_bytes({arguments})"
        case Sign.COMPLEMENT:
            data = f"{raw}.to_bytes({arguments}, signed=True)"
        case Sign.MAGNITUDE:
            data = f"_magnitude_bytes({raw}, {arguments})"
        case _:
            assert_never(sign)
    return f"_turned({data})" if turned else data


def sent_order(field: Slots) -> str:
    """The order of all bytes of a number, after the bytes of each word are exchanged if its words are."""
    return "big" if (field.field.order == "big") != field.field.swapped else "little"


def real_letters(field: Slots, real: Real) -> str:
    """The order and the letter of a floating-point number, as a literal."""
    return literal(f"{'>' if sent_order(field) == 'big' else '<'}{struct_letter(real)}")


real_word = OfPrecision(half="half", single="float", double="double")
"""The name of a floating-point format in the runtime."""


def digits_letters(value: Value, order: str, swapped: bool) -> str:
    """The arguments of the runtime for the digits of a value."""
    return digits_arguments(value, (order == "big") == swapped, codec_key(value.codec) if value.codec else "")


def digits_form(value: Value, order: str, swapped: bool) -> str:
    """The expression of what reads and writes the digits of a value."""
    return f"_digits({literal(digits_letters(value, order, swapped))})"


def text_letters(value: Value, order: str) -> str:
    """The arguments of the form of a text: its encoding, its bytes, its padding and its terminator."""
    form = value.text_form
    assert form is not None
    return form.arguments(value.size, order)


def text_form(value: Value, order: str) -> str:
    """The expression of the object of the runtime that reads and writes a text in its form."""
    return f"_text_form({literal(text_letters(value, order))})"


def measured(field: Slots, other: Slots, expression: str, decided: str) -> str:
    """The value of a field that measures another one; `decided` is the size of an element with several types."""
    measure = field.field.measure
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
    size, encoding = str(field.field.size), field.value.encoding
    match encoding:
        case Text():
            if encoding.form is not None:
                return f"{text_form(field.value, field.field.order)}.refused", []
            return "_refused_text", [size]
        case Octets():
            return "_refused_bytes", [size]
        case Real():
            function = f"_refused_{real_word(encoding.precision)}"
            if field.ranges is None:
                return function, []
            absent_numbers = [*map(interval_text, field.sentinels), *(['float("nan")'] * field.value.absent_nan)]
            return function, [pairs(field.ranges), *([tuple_of(absent_numbers)] if absent_numbers else [])]
        case Whole() | Digits() | Truth():
            return _refusing_number(field, *bounds_of(encoding))
        case _:
            assert_never(encoding)


def _refusing_number(field: Slots, low: int, high: int) -> tuple[str, list[str]]:
    """The function that explains the refusal of a whole number from `low` to `high`."""
    ranges = pairs(field.ranges)
    if field.value.flags:
        bits = bounded_bits(field.words.bounded(field.value.flags))
        return "_refused_flags", [str(high), *([ranges or "()"] if ranges or bits else []), *bits]
    arguments = [ranges or "()", tuple_of(map(interval_text, field.sentinels))]
    if field.enum is not None and not field.enum.open:
        arguments += [field.enum.table, literal(field.enum.title)]
    while arguments and arguments[-1] == "()":
        arguments.pop()
    return "_refused_number", [str(low), str(high), *arguments]


def bounded_bits(bits: tuple[Bit, ...]) -> list[str]:
    """The fields of bits that have a range, as one argument: name, mask, what may be in the mask, and a text."""
    if not bits:
        return []
    rows = [
        f"({literal(bit.name)}, {place_of(bit)}, {pairs(Ranges(bit.images))}, {literal(bit.ranges.text())})"
        for bit in bits
        if bit.ranges is not None
    ]
    return [tuple_of(rows)]


def pairs(ranges: Ranges | None) -> str:
    """Ranges as a tuple of pairs; an empty text for none."""
    return tuple_of(f"({low}, {high})" for low, high in ranges.intervals) if ranges else ""


def interval_text(interval: tuple[int, int]) -> str:
    """The numbers of an interval: `65535`, `range(65024, 65280)`"""
    low, high = interval
    return str(low) if low == high else f"range({low}, {high + 1})"


def tuple_of(items: object) -> str:
    """A tuple of expressions; a range of numbers as it is."""
    if isinstance(items, range):
        return repr(items)
    texts = [str(item) for item in items]  # type: ignore[attr-defined]
    return f"({texts[0]},)" if len(texts) == 1 else f"({', '.join(texts)})"
