"""Single values in C: their types, how they are loaded and stored, and which of them are refused."""

from __future__ import annotations

from fieldspec.codec.layout.accepted import (
    REASONS,
    Equals,
    Fits,
    HasCharacters,
    HasDigits,
    IsBit,
    Known,
    PartWithin,
    RealWithin,
    Test,
    Within,
    accepted,
)
from fieldspec.codec.layout.record import CaseLayout, FieldLayout
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_array,
)
from fieldspec.language.model.value import Value
from fieldspec.targets.c.conditions import refused_number
from fieldspec.targets.c.digits import digits_call, digits_test, load_digits, to_nibbles
from fieldspec.targets.c.encoded_texts import load_text, store_text, text_bytes_test, text_capacity, text_test
from fieldspec.targets.c.enums import enum_type
from fieldspec.targets.c.expressions import IN, OUT, VALUE, Call, Expression, Identifier, Literal, Type
from fieldspec.targets.c.literals import decimal, unsigned
from fieldspec.targets.c.machine import fixed_bits, literal, machine, of_bits, to_bits
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.number_access import access_name
from fieldspec.targets.c.statements import Assignment, Body, Evaluation, Return, Variable, call, return_if

if TYPE_CHECKING:
    from fieldspec.codec.layout.accepted import Reason

DATA, COUNT = "data", "count"
"""The members of bytes of varying length."""
_NUL = Literal("'\\0'")


@dataclass(frozen=True, slots=True)
class WireValue:
    """A value and the order of its bytes; `swapped` says that the least significant 16-bit word comes first."""

    value: Value
    order: str
    swapped: bool

    @property
    def encoding(self) -> Encoding:
        """How it is on the wire."""
        return self.value.encoding

    @property
    def size(self) -> int:
        """The number of its bytes on the wire."""
        return self.value.size

    @property
    def is_array(self) -> bool:
        """Whether C has it as an array: a text or bytes."""
        return is_array(self.encoding)

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
    return machine(value.encoding).type


def declare_value(wire: WireValue, name: str, count: int | None = None, const: bool = False) -> Variable:
    """The member, parameter or variable that has a value, or `count` of them: `char name[count][33]`

    Bytes of varying length have a struct: `struct { uint8_t data[64]; size_t count; } name`
    """
    if wire.value.is_marked:
        return Variable(Type(f"struct {{ {type_name(wire.value)} {DATA}[{wire.size}]; size_t {COUNT}; }}"), name)
    dimensions = (decimal(count),) if count is not None else ()
    return Variable(Type(type_name(wire.value), const=const), name, (*dimensions, *_own_dimensions(wire)))


def _own_dimensions(wire: WireValue) -> tuple[Expression, ...]:
    match wire.encoding:
        case Text():
            return (decimal(text_capacity(wire.value) + 1),)
        case Octets():
            return (decimal(wire.size),)
        case Whole() | Real() | Truth() | Digits():
            return ()
        case _:
            assert_never(wire.encoding)


def accessed_type(naming: Naming, device: Device, value: Value) -> str:
    """The type of a value as a parameter or a result: that of its closed enum, where it may have it."""
    enum = enum_type(device, value)
    return type_name(value) if enum is None else naming.type("enum", enum.name)


def load_bits(naming: Naming, wire: WireValue, source: Expression) -> Expression:
    """`load_u16_be(in + 4)`: the bits at `source`, a pointer to the first byte."""
    return Call(naming.own(f"load_{wire.access}"), (source,))


def load(naming: Naming, wire: WireValue, source: Expression) -> Expression:
    """`signed_16(load_u16_be(in + 4))`: the number at `source`, a pointer to its first byte."""
    encoding, bits = wire.encoding, load_bits(naming, wire, source)
    match encoding:
        case Digits():
            return load_digits(naming, wire.value, source, bits)
        case Whole() | Real() | Truth() | Text() | Octets():
            return of_bits(naming, encoding, bits)
        case _:
            assert_never(encoding)


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


# Reading


def load_value(naming: Naming, wire: WireValue, source: Expression, target: Expression) -> Body:
    """`target = load_u16_be(in + 4);`: moves the value at `source` to `target` without a check."""
    encoding, size = wire.encoding, unsigned(wire.size)
    match encoding:
        case Text():
            if encoding.form is not None:
                return (load_text(naming, wire.value, wire.order, source, target),)
            end = Assignment(target.element(decimal(encoding.size)), _NUL)
            return copy_bytes(naming, target, source, size), end
        case Octets() if wire.value.is_marked:
            load_marked = Call(
                naming.own("load_marked"), (target.member(DATA), source, unsigned(wire.value.image_size))
            )
            return (Assignment(target.member(COUNT), load_marked),)
        case Octets():
            return (copy_bytes(naming, target, source, size),)
        case Whole() | Real() | Truth() | Digits():
            return (Assignment(target, load(naming, wire, source)),)
        case _:
            assert_never(encoding)


def check_loaded(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Refuses what was loaded from `source` to `target`: a wrong constant, or a value that the type does not have."""
    body: Body = ()
    for condition in accepted(device, wire.value).reading:
        test = _refused_bytes(naming, wire, condition.test, source, target)
        body += refuse(naming, test, f"err_{condition.reason}") if test is not None else ()
    return body


def _refused_bytes(
    naming: Naming, wire: WireValue, test: Test, source: Expression, number: Expression
) -> Expression | None:
    """What holds for bytes that a test refuses, from which a number was loaded; that of a constant was not."""
    match test:
        case HasDigits():
            return digits_test(naming, wire.value, source, load_bits(naming, wire, source)).negated()
        case HasCharacters():
            if test.text.form is not None:
                return text_bytes_test(naming, wire.value, wire.order, source).negated()
            return Call(naming.own("is_ascii"), (source, unsigned(wire.size))).negated()
        case IsBit():
            return refused_number(naming, wire.encoding, test, load_bits(naming, wire, source))
        case Equals():
            return refused_number(naming, wire.encoding, test, load(naming, wire, source))
        case Known() | Within() | RealWithin() | PartWithin() | Fits():
            return refused_number(naming, wire.encoding, test, number)
        case _:
            assert_never(test)


def decode_value(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Loads and checks a value; a constant is checked alone."""
    checks = check_loaded(naming, device, wire, source, target)
    if wire.value.const is not None:
        return checks
    return (*load_value(naming, wire, source, target), *checks)


def decode_enum(naming: Naming, device: Device, wire: WireValue) -> Body:
    """`*out = (stop_mode)number;`: a number is checked before it becomes a member of its enum."""
    number = Identifier("number")
    member = number.cast(accessed_type(naming, device, wire.value))
    return (
        Variable(Type(type_name(wire.value), const=True), number.name, value=load(naming, wire, IN)),
        *check_loaded(naming, device, wire, IN, number),
        Assignment(OUT.dereferenced(), member),
    )


def check_constant(naming: Naming, wire: WireValue, number: Expression) -> Body:
    """`if (load_u8(in + 4) != 3u) { return ERR_WRONG_CONST; }`"""
    assert wire.value.const is not None
    return refuse(naming, number.differs(literal(wire.encoding, wire.value.const)), "err_wrong_const")


# Writing


def check_stored(
    naming: Naming, device: Device, wire: WireValue, source: Expression, reasons: tuple[Reason, ...] = REASONS
) -> Body:
    """Refuses the value `source`, which is to be written, for one of some reasons."""
    body: Body = ()
    for condition in accepted(device, wire.value).writing:
        test = _refused_value(naming, wire, condition.test, source) if condition.reason in reasons else None
        body += refuse(naming, test, f"err_{condition.reason}") if test is not None else ()
    return body


def _refused_value(naming: Naming, wire: WireValue, test: Test, value: Expression) -> Expression | None:
    """What holds for a value of C that a test refuses; None where the type of C has no such value."""
    match test:
        case HasCharacters():
            if test.text.form is not None:
                return text_test(naming, wire.value, wire.order, value).negated()
            return Call(naming.own("is_text"), (value, unsigned(wire.size))).negated()
        case HasDigits() | IsBit():
            return None
        case Equals() | Known() | Within() | RealWithin() | PartWithin() | Fits():
            return refused_number(naming, wire.encoding, test, value)
        case _:
            assert_never(test)


def store_value(naming: Naming, wire: WireValue, source: Expression, target: Expression) -> Body:
    """`store_u16_be(out + 4, in->speed);`: writes the value `source` at `target` without a check."""
    encoding, size = wire.encoding, unsigned(wire.size)
    match encoding:
        case Text():
            if encoding.form is not None:
                return (store_text(naming, wire.value, wire.order, source, target),)
            return (call(naming.own("put_text"), target, source, size),)
        case Octets() if wire.value.is_marked:
            data, count = source.member(DATA), source.member(COUNT)
            refusal = refuse(naming, count.greater(size), "err_wrong_length")
            return (*refusal, call(naming.own("store_marked"), target, data, count, unsigned(wire.value.image_size)))
        case Octets():
            return (copy_bytes(naming, target, source, size),)
        case Digits():
            return (store_number(naming, wire, source, target),)
        case Whole() | Real() | Truth():
            return (store(naming, wire.access, target, to_bits(naming, encoding, source)),)
        case _:
            assert_never(encoding)


def store_number(naming: Naming, wire: WireValue, number: Expression, target: Expression) -> Evaluation:
    """`store_digits(out + 4, 6u, 2u, 0u, in->speed);`: writes a number as digits."""
    if wire.value.is_as_sent:
        function, arguments = digits_call(naming, wire.value, target, number)
        return call(function, *arguments)
    word = machine(Whole(8 * wire.size, Sign.NONE)).type
    return store(naming, wire.access, target, to_nibbles(naming, wire.value, number).cast(word))


def encode_value(naming: Naming, device: Device, wire: WireValue, source: Expression, target: Expression) -> Body:
    """Checks the value `source` and writes it at `target`."""
    return (*check_stored(naming, device, wire, source), *store_value(naming, wire, source, target))


def encode_enum(naming: Naming, device: Device, wire: WireValue) -> Body:
    """`store_u16_be(out, (uint16_t)value);`: checks a member of an enum, as a cast makes one of any number.

    A range that leaves out members is tested on a variable: gcc warns of bounds that the type of the enum implies.
    """
    number = Identifier("number")
    range_check = check_stored(naming, device, wire, number, ("out_of_range",))
    # No signed type that is too small for what a cast may have made of it.
    kind = "int64_t" if bounds_of(wire.encoding)[0] < 0 else type_name(wire.value)
    return (
        *((Variable(Type(kind, const=True), number.name, value=VALUE.cast(kind)),) if range_check else ()),
        *check_stored(naming, device, wire, VALUE, ("unknown_value",)),
        *range_check,
        store_whole(naming, wire, VALUE, OUT),
    )


def store_whole(naming: Naming, wire: WireValue, number: Expression, target: Expression) -> Evaluation:
    """`store_u16_be(out, (uint16_t)value);`: writes a whole number with a different C type, such as an enum.

    Raises AssertionError for a value that is not a whole number.
    """
    encoding, kind = wire.encoding, machine(wire.encoding)
    match encoding:
        case Digits():
            return store_number(naming, wire, number.cast(kind.type), target)
        case Whole():
            bits = to_bits(naming, encoding, number.cast(kind.type)) if kind.to_bits else number.cast(kind.word)
            return store(naming, wire.access, target, bits)
        case Real() | Truth() | Text() | Octets():
            raise AssertionError("no whole number")
        case _:
            assert_never(encoding)


def store_constant(naming: Naming, wire: WireValue, number: int, target: Expression) -> Body:
    """`store_u16_be(out + 4, 3u);`: writes a number that no user sets, a constant or that of a reserved field."""
    encoding = wire.encoding
    match encoding:
        case Text() | Octets():
            return (clear_bytes(naming, target, unsigned(wire.size)),)
        case Digits():
            return (store_number(naming, wire, literal(encoding, number), target),)
        case Whole() | Real() | Truth():
            return (store(naming, wire.access, target, fixed_bits(encoding, number)),)
        case _:
            assert_never(encoding)


def fixed_number(value: Value) -> int:
    """The value that is written for a field that no user sets: its constant, or its default, or 0."""
    if value.const is not None:
        return value.const
    return value.default if isinstance(value.default, int) else 0
