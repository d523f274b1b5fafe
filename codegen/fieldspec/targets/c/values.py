"""Single values in C: their types, how they are loaded and stored, and which of them are refused."""

from __future__ import annotations

from fieldspec.codec.layout.record import CaseLayout, FieldLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.primitives import PRIMITIVES, Kind
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.targets.c.bit_ranges import refused_bits_tests
from fieldspec.targets.c.digits import digits_call, digits_test, load_digits
from fieldspec.targets.c.encoded_texts import load_text, store_text, text_bytes_test, text_capacity, text_test
from fieldspec.targets.c.enums import enum_implies_range, enum_type, unknown_value_test
from fieldspec.targets.c.expressions import (
    IN,
    OUT,
    VALUE,
    ZERO,
    Call,
    Cast,
    Conditional,
    Element,
    Expression,
    Group,
    Identifier,
    Literal,
    Type,
    all_of,
    any_of,
    at_least,
    at_most,
    decimal,
    dereference,
    different,
    equal,
    greater,
    integer,
    less,
    negate,
    real,
    unsigned,
)
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Assignment, Body, Evaluation, Return, Variable, call, return_if

_TYPES = {
    **{
        name: f"{'' if primitive.signed else 'u'}int{8 * primitive.container}_t"
        for name, primitive in PRIMITIVES.items()
        if primitive.kind is Kind.INTEGER
    },
    "f32": "float",
    "f64": "double",
    "bool8": "bool",
    "bool16": "bool",
    "bit": "bool",
}
_NUL = Literal("'\\0'")


@dataclass(frozen=True, slots=True)
class WireValue:
    """A value and the order of its bytes; `swapped` says that the least significant 16-bit word comes first."""

    value: Value
    order: str
    swapped: bool

    @property
    def kind(self) -> Kind:
        """The kind of its type: an integer, a float, a text..."""
        return self.value.type.kind

    @property
    def size(self) -> int:
        """The number of its bytes on the wire."""
        return self.value.size

    @property
    def is_array(self) -> bool:
        """Whether C has it as an array: a text or bytes."""
        return self.kind in (Kind.TEXT, Kind.BYTES)

    @property
    def access(self) -> str:
        """The end of the names of functions that load and store it."""
        return access_name(self.size, self.order, self.swapped)


def field_value(field: FieldLayout | CaseLayout) -> WireValue:
    """The value of a field that has one, or of one of its cases."""
    assert field.value is not None
    return WireValue(field.value, field.order, field.swapped)


def type_name(value: Value) -> str:
    """The type of an element of a value: `uint16_t`, and `char` of a text."""
    kind = value.type.kind
    if kind is Kind.TEXT:
        return "char"
    return "uint8_t" if kind is Kind.BYTES else _TYPES[value.type.name]


def declare_value(wire: WireValue, name: str, count: int | None = None, const: bool = False) -> Variable:
    """The member, parameter or variable that has a value, or `count` of them: `char name[count][33]`"""
    dimensions = (decimal(count),) if count is not None else ()
    if wire.kind is Kind.TEXT:
        dimensions = (*dimensions, decimal(text_capacity(wire.value) + 1))
    elif wire.kind is Kind.BYTES:
        dimensions = (*dimensions, decimal(wire.size))
    return Variable(Type(type_name(wire.value), const=const), name, dimensions)


def accessed_type(naming: Naming, device: Device, value: Value) -> str:
    """The type of a value as a parameter or a result: that of its closed enum, where it may have it."""
    enum = enum_type(device, value)
    return type_name(value) if enum is None else naming.type("enum", enum.name)


def access_name(size: int, order: str, swapped: bool) -> str:
    """The end of the names of functions that load and store a number: `u32_be`, `u32_be_words_le`"""
    if size == 1:
        return "u8"
    first = "be" if order == "big" else "le"
    second = ("_words_le" if order == "big" else "_words_be") if swapped else ""
    return f"u{8 * size}_{first}{second}"


def real_functions(size: int) -> tuple[str, str]:
    """The functions from the bits of a floating-point number to the number, and back."""
    return ("float_of", "bits_of") if size == 4 else ("double_of", "bits_of_double")


def load(naming: Naming, wire: WireValue, source: Expression) -> Expression:
    """`load_u16_be(in + 4)`: the number at `source`, a pointer to its first byte."""
    number = Call(naming.own(f"load_{wire.access}"), (source,))
    if wire.value.digits:
        return load_digits(naming, wire.value, source, number)
    if wire.kind is Kind.INTEGER and wire.value.type.signed:
        return Call(naming.own(f"signed_{8 * wire.size}"), (number,))
    return number


def store(naming: Naming, access: str, target: Expression, number: Expression) -> Evaluation:
    """`store_u16_be(out + 4, number);`"""
    return call(naming.own(f"store_{access}"), target, number)


def copy_bytes(naming: Naming, target: Expression, source: Expression, size: Expression) -> Evaluation:
    """`COPY(target, source, size);`, for bytes that do not overlap"""
    return call(naming.own_macro("copy"), target, source, size)


def clear_bytes(naming: Naming, target: Expression, size: Expression) -> Evaluation:
    """`CLEAR(target, size);`: fills bytes with zeros."""
    return call(naming.own_macro("clear"), target, size)


def status_type(naming: Naming) -> Type:
    """The C type that functions return as their status."""
    return naming.status_variable().type


def return_ok(naming: Naming) -> Return:
    """`return OK;`"""
    return Return(naming.status("ok"))


def refuse(naming: Naming, test: Expression, error: str) -> Body:
    """`if (test) { return ERR_OUT_OF_RANGE; }`"""
    return (return_if(test, naming.status(error)),)


def out_of_range_test(value: Value, number: Expression) -> Expression | None:
    """`!(value >= 1u && value <= 12u)`: whether a number may not be written; None where all of its type may be.

    Bounds that are those of the type are left out: compilers warn of comparisons that are always true. A sentinel
    beside the range is taken.
    """
    kind = value.type
    ranges = value.writable_ranges
    if ranges is None and kind.is_odd:
        ranges = Ranges(((kind.low, kind.high),))
    if ranges is None:
        return None
    if kind.kind is Kind.FLOAT:
        return _float_out_of_range_test(value, ranges, number)
    tests: list[Expression] = []
    for low, high in sorted(ranges.intervals):
        minimum, maximum = integer(low, kind.size, kind.signed), integer(high, kind.size, kind.signed)
        if low == high:
            tests.append(equal(number, minimum))
            continue
        bounds: list[Expression] = []
        if low > kind.low or (kind.is_odd and kind.signed):
            bounds.append(at_least(number, minimum))
        if high < kind.high or kind.is_odd:
            bounds.append(at_most(number, maximum))
        if not bounds:
            return None
        tests.append(all_of(bounds))
    tests += [
        equal(number, integer(sentinel.value, kind.size, kind.signed))
        for sentinel in value.sentinels
        if sentinel.value not in ranges
    ]
    return negate(tests[0] if len(tests) == 1 else any_of([Group(test) for test in tests]))


def _float_out_of_range_test(value: Value, ranges: Ranges, number: Expression) -> Expression:
    """`!(value >= -5.0f && value <= 5.0f)`, of which a NaN is out of range, as no comparison holds of it.

    Where a NaN stands for an absent value: `(value < -5.0f || value > 5.0f)`, in which none is.
    """
    sentinels = [(sentinel.value, sentinel.value) for sentinel in value.sentinels if not sentinel.is_nan]
    size = value.size
    bounds = [(real(low, size), real(high, size)) for low, high in sorted([*ranges.intervals, *sentinels])]
    if value.absent_nan:
        return all_of([Group(any_of([less(number, low), greater(number, high)])) for low, high in bounds])
    return negate(any_of([Group(all_of([at_least(number, low), at_most(number, high)])) for low, high in bounds]))


# Reading


def load_value(naming: Naming, wire: WireValue, source: Expression, target: Expression) -> Body:
    """`target = load_u16_be(in + 4);`: moves the value at `source` to `target` without a check."""
    if wire.value.text_form is not None:
        return (load_text(naming, wire.value, wire.order, source, target),)
    if wire.kind is Kind.TEXT:
        end = Assignment(Element(target, decimal(wire.size)), _NUL)
        return copy_bytes(naming, target, source, unsigned(wire.size)), end
    if wire.kind is Kind.BYTES:
        return (copy_bytes(naming, target, source, unsigned(wire.size)),)
    number = load(naming, wire, source)
    if wire.kind is Kind.FLOAT:
        number = Call(naming.own(real_functions(wire.size)[0]), (number,))
    elif wire.kind is Kind.BOOLEAN:
        number = different(number, ZERO)
    return (Assignment(target, number),)


def check_loaded(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Refuses what was loaded from `source` to `target`: a wrong constant, or a value that the type does not have."""
    if wire.value.const is not None:
        return check_constant(naming, wire, source)
    if wire.value.text_form is not None:
        return refuse(naming, negate(text_bytes_test(naming, wire.value, wire.order, source)), "err_unknown_value")
    if wire.kind is Kind.TEXT:
        ascii_test = Call(naming.own("is_ascii"), (source, unsigned(wire.size)))
        return refuse(naming, negate(ascii_test), "err_unknown_value")
    if wire.kind is Kind.BOOLEAN:
        return refuse(naming, greater(load(naming, wire, source), unsigned(1)), "err_unknown_value")
    tests: Body = ()
    if wire.value.digits:
        number = Call(naming.own(f"load_{wire.access}"), (source,))
        tests = refuse(naming, negate(digits_test(naming, wire.value, source, number)), "err_unknown_value")
    unknown = unknown_value_test(naming, device, wire.value, target)
    return (*tests, *(refuse(naming, unknown, "err_unknown_value") if unknown is not None else ()))


def decode_value(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Loads and checks a value; a constant is checked alone."""
    checks = check_loaded(naming, device, wire, source, target)
    if wire.value.const is not None:
        return checks
    return (*load_value(naming, wire, source, target), *checks)


def decode_enum(naming: Naming, device: Device, wire: WireValue) -> Body:
    """`*out = (stop_mode)number;`: a number is checked before it becomes a member of its enum."""
    number = Identifier("number")
    member = Cast(accessed_type(naming, device, wire.value), number)
    return (
        Variable(Type(type_name(wire.value), const=True), number.name, value=load(naming, wire, IN)),
        *check_loaded(naming, device, wire, IN, number),
        Assignment(dereference(OUT), member),
    )


def check_constant(naming: Naming, wire: WireValue, source: Expression) -> Body:
    """`if (load_u8(in + 4) != 3u) { return ERR_WRONG_CONST; }`"""
    assert wire.value.const is not None
    constant = integer(wire.value.const, wire.value.number_size(wire.size), wire.value.type.signed)
    return refuse(naming, different(load(naming, wire, source), constant), "err_wrong_const")


# Writing


def check_stored(naming: Naming, device: Device, wire: WireValue, source: Expression) -> Body:
    """Refuses the value `source`, which is to be written: unknown to its closed enum, or out of its range."""
    if wire.value.text_form is not None:
        return refuse(naming, negate(text_test(naming, wire.value, wire.order, source)), "err_unknown_value")
    if wire.kind is Kind.TEXT:
        ascii_test = Call(naming.own("is_text"), (source, unsigned(wire.size)))
        return refuse(naming, negate(ascii_test), "err_unknown_value")
    if wire.kind not in (Kind.INTEGER, Kind.FLOAT):
        return ()
    checks = _check_known(naming, device, wire, source) + _check_range(naming, device, wire, source)
    return checks + _check_bits(naming, device, wire, source)


def _check_known(naming: Naming, device: Device, wire: WireValue, source: Expression) -> Body:
    unknown = unknown_value_test(naming, device, wire.value, source)
    return refuse(naming, unknown, "err_unknown_value") if unknown is not None else ()


def _check_range(naming: Naming, device: Device, wire: WireValue, source: Expression) -> Body:
    out_of_range = None if enum_implies_range(device, wire.value) else out_of_range_test(wire.value, source)
    return refuse(naming, out_of_range, "err_out_of_range") if out_of_range is not None else ()


def _check_bits(naming: Naming, device: Device, wire: WireValue, source: Expression) -> Body:
    tests = refused_bits_tests(device.flags.get(wire.value.flags), wire.size, source)
    return tuple(statement for test in tests for statement in refuse(naming, test, "err_out_of_range"))


def store_value(naming: Naming, wire: WireValue, source: Expression, target: Expression) -> Body:
    """`store_u16_be(out + 4, in->speed);`: writes the value `source` at `target` without a check."""
    if wire.value.text_form is not None:
        return (store_text(naming, wire.value, wire.order, source, target),)
    if wire.kind is Kind.TEXT:
        return (call(naming.own("put_text"), target, source, unsigned(wire.size)),)
    if wire.kind is Kind.BYTES:
        return (copy_bytes(naming, target, source, unsigned(wire.size)),)
    number_type = f"uint{8 * wire.value.type.container}_t"
    number = source
    if wire.kind is Kind.FLOAT:
        number = Call(naming.own(real_functions(wire.size)[1]), (source,))
    elif wire.kind is Kind.BOOLEAN:
        number = Cast(number_type, Conditional(source, decimal(1), ZERO))
    elif wire.value.type.signed:
        number = Cast(number_type, source)
    if wire.value.digits:
        return (store_number(naming, wire, source, target),)
    return (store(naming, wire.access, target, number),)


def store_number(naming: Naming, wire: WireValue, number: Expression, target: Expression) -> Evaluation:
    """`store_digits(out + 4, 6u, 2u, 0u, in->speed);`: writes a number as digits."""
    if wire.value.has_characters:
        function, arguments = digits_call(naming, wire.value, target, number)
        return call(function, *arguments)
    container = next(size for size in (1, 2, 4, 8) if size >= wire.size)
    return store(naming, wire.access, target, Cast(f"uint{8 * container}_t", Call(naming.own("to_bcd"), (number,))))


def encode_value(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Checks the value `source` and writes it at `target`."""
    return (*check_stored(naming, device, wire, source), *store_value(naming, wire, source, target))


def encode_enum(naming: Naming, device: Device, wire: WireValue) -> Body:
    """`store_u16_be(out, (uint16_t)value);`: checks a member of an enum, as a cast makes one of any number.

    A range that leaves out members is tested on a variable: gcc warns of bounds that the type of the enum implies.
    """
    number = Identifier("number")
    range_check = _check_range(naming, device, wire, number)
    # No signed type that is too small for what a cast may have made of it.
    kind = "int64_t" if wire.value.type.signed else type_name(wire.value)
    return (
        *((Variable(Type(kind, const=True), number.name, value=Cast(kind, VALUE)),) if range_check else ()),
        *_check_known(naming, device, wire, VALUE),
        *range_check,
        _store_member(naming, wire),
    )


def _store_member(naming: Naming, wire: WireValue) -> Evaluation:
    member = Cast(f"uint{8 * wire.value.type.container}_t", VALUE)
    if wire.value.digits:
        return store_number(naming, wire, Cast(type_name(wire.value), VALUE), OUT)
    return store(naming, wire.access, OUT, member)


def store_constant(naming: Naming, wire: WireValue, number: int, target: Expression) -> Body:
    """`store_u16_be(out + 4, 3u);`: writes a number that no user sets, a constant or that of a reserved field."""
    if wire.is_array:
        return (clear_bytes(naming, target, unsigned(wire.size)),)
    if wire.value.digits:
        return (store_number(naming, wire, integer(number, wire.value.type.size, wire.value.type.signed), target),)
    raw = number & ((1 << (8 * wire.size)) - 1)
    return (store(naming, wire.access, target, integer(raw, wire.size, False)),)


def fixed_number(value: Value) -> int:
    """What is written for a field that no user sets: its constant, or its default, or 0."""
    if value.const is not None:
        return value.const
    return value.default if isinstance(value.default, int) else 0
