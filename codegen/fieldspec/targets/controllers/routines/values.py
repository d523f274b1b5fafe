"""Single values, from bytes into a variable and back, and names of their byte orders."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Precision,
    Real,
    Sign,
    Text,
    bounds_of,
    has_magnitude,
    is_array,
    is_odd,
    is_text,
    whole_bits,
)
from fieldspec.language.model.encoding import Truth as TruthValue
from fieldspec.language.model.encoding import Whole as WholeNumber
from fieldspec.language.model.encoding import number_of as number_of_encoding
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.holders import Holder
from fieldspec.targets.controllers.routines.reals import outside_precision
from fieldspec.targets.controllers.routines.stated import outside_part, outside_real
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    BYTE,
    UNSIGNED,
    ArrayType,
    Element,
    Elementary,
    EnumType,
    Expression,
    Member,
    Truth,
    Variable,
    Whole,
    number,
    outside,
)
from fieldspec.targets.controllers.statements.numbers import whole_type
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Loop, Statement, when


@dataclass(frozen=True, slots=True)
class Wire:
    """A value and the order of its bytes on the wire."""

    value: Value
    order: str
    swapped: bool

    @staticmethod
    def of_field(field: FieldLayout) -> Wire:
        """The wire value of a field that has a value."""
        assert field.value is not None
        return Wire(field.value, field.order, field.swapped)

    @staticmethod
    def of_register(register: RegisterLayout) -> Wire:
        """The wire value of a register in a write."""
        value = register.register.value
        return Wire(value, register.order, value.write_swapped(register.swapped))

    @staticmethod
    def of_answer(register: RegisterLayout) -> Wire:
        """The wire value of a register in a read, as the device answers it."""
        return Wire(register.register.answer, register.order, register.swapped)

    @property
    def bits(self) -> Elementary:
        """The type of the bit string that holds the value."""
        return BITS[self.value.size]

    @property
    def whole(self) -> Elementary:
        """The type of whole numbers that holds the value."""
        return whole_type(self.value.encoding)

    def literal(self, number_of: int) -> Whole:
        """The literal of the bit string of a number."""
        whole = number_of_encoding(self.value.encoding)
        bits = number_of if whole is None else whole_bits(whole, number_of)
        return Whole(bits & ((1 << 8 * self.value.size) - 1), self.bits)

    def number(self, world: World, bits: Expression) -> Expression:
        """The whole number in a bit string; the sign is repeated in bits that its type has beyond."""
        whole = number_of_encoding(self.value.encoding)
        if whole is None:
            return bits.converted(self.whole)
        match whole.sign:
            case Sign.NONE:
                return bits.converted(self.whole)
            case Sign.COMPLEMENT:
                if not is_odd(whole):
                    return bits.converted(self.whole)
                sign = 1 << (whole.bits - 1)
                moved = bits.combined("XOR", sign)
                return moved.converted(self.whole).combined("-", sign)
            case Sign.MAGNITUDE:
                return world.number_from_magnitude(whole, bits)
            case _:
                assert_never(whole.sign)

    def bits_of(self, world: World, source: Expression) -> Expression:
        """The bit string of a whole number that is within the bounds of the type."""
        whole = number_of_encoding(self.value.encoding)
        if whole is None or not has_magnitude(whole):
            return source.converted(self.bits)
        return world.magnitude_from_number(whole, source.converted(self.whole))

    def differs(self, world: World, bits: Expression, const: int) -> Expression:
        """Whether a bit string is that of another number: of a sign and a magnitude, zero has two."""
        if has_magnitude(self.value.encoding):
            return self.number(world, bits).compared("<>", const)
        return bits.compared("<>", self.literal(const))


def read(draft: Draft, wire: Wire, holder: Holder, target: Expression | None) -> list[Statement]:
    """The statements that read a value into a variable; without one, they refuse anything but the constant."""
    encoding = wire.value.encoding
    match encoding:
        case Text() | Octets():
            return [] if target is None else _characters_read(draft, wire, holder, target)
        case Real():
            return _number_read(draft, wire, holder, target, _reading_real(encoding.precision))
        case TruthValue():
            return _number_read(draft, wire, holder, target, _read_truth)
        case WholeNumber() | Digits():
            return _number_read(draft, wire, holder, target, _read_count)
        case _:
            assert_never(encoding)


_Reading = Callable[[Draft, Wire, Expression, Expression], list[Statement]]


def _number_read(
    draft: Draft, wire: Wire, holder: Holder, target: Expression | None, reading: _Reading
) -> list[Statement]:
    """The statements that reject any value except a constant, or read another value from its bits."""
    value = wire.value
    bits = holder.number(0, value.size, wire.order, wire.swapped)
    if value.const is not None:
        return [draft.refusal(wire.differs(draft.world, bits, value.const), "wrong_constant")]
    return [] if target is None else reading(draft, wire, bits, target)


def _reading_real(precision: Precision) -> _Reading:
    def reading(draft: Draft, wire: Wire, bits: Expression, target: Expression) -> list[Statement]:
        received = _received(draft, target, "rValue")
        call = draft.world.real_from_bits(precision, bits, received)
        refusal = draft.refusal(call.compared("<>", draft.status.of("ok")), "no_number")
        return [refusal, *_moved(target, received)]

    return reading


def _read_truth(draft: Draft, wire: Wire, bits: Expression, target: Expression) -> list[Statement]:
    raw = bits.converted(wire.whole)
    return [draft.refusal(raw.compared(">", 1), "unknown_value"), Assignment(target, raw.compared("=", 1))]


def _read_count(draft: Draft, wire: Wire, bits: Expression, target: Expression) -> list[Statement]:
    if isinstance(target.type, EnumType):
        name = wire.value.enum
        received = _received(draft, target, f"e{Name.of(name).pascal()}")
        raw = wire.number(draft.world, bits).converted(draft.world.raw_type(name))
        refusal = draft.refusal(draft.world.enum_from_raw(name, raw, received).negated(), "unknown_value")
        return [refusal, *_moved(target, received)]
    assert isinstance(target.type, Elementary)
    read_number = bits if target.type == wire.bits else wire.number(draft.world, bits).converted(target.type)
    statements: list[Statement] = [Assignment(target, read_number)]
    return [*statements, *_closed(draft, wire, target)]


def _received(draft: Draft, target: Expression, name: str) -> Expression:
    """Where a function puts its output: a local variable for an element of an array, and for what lies in one.

    The compiler of Beremiz and OpenPLC makes wrong C of an output that goes there directly.
    """
    holder = target
    while isinstance(holder, Member):
        holder = holder.of
    return draft.local(name, target.type) if isinstance(holder, Element) else target


def _moved(target: Expression, received: Expression) -> list[Statement]:
    """The assignment of a received output to its target; none where it is in the target already."""
    return [] if received is target else [Assignment(target, received)]


def write(draft: Draft, wire: Wire, holder: Holder, source: Expression) -> list[Statement]:
    """The statements that refuse a value that must not be sent, and store any other."""
    value, encoding = wire.value, wire.value.encoding
    match encoding:
        case Text() | Octets():
            return _write_characters(draft, wire, holder, source)
        case Real():
            raw = draft.local(_RAW[wire.bits.name], wire.bits)
            call = draft.world.bits_from_real(encoding.precision, source, raw)
            wrong = outside_precision(encoding.precision, source)
            limits = [] if wrong is None else [draft.refusal(wrong, "out_of_range")]
            if value.ranges is not None:
                limits = [draft.refusal(outside_real(value, source), "out_of_range")]
            stored = holder.stored(0, value.size, wire.order, wire.swapped, raw)
            return [*limits, draft.refusal(call.compared("<>", draft.status.of("ok")), "no_number"), *stored]
        case TruthValue():
            true = when(source, holder.stored(0, value.size, wire.order, wire.swapped, Whole(1, wire.bits)))
            zero = holder.stored(0, value.size, wire.order, wire.swapped, Whole(0, wire.bits))
            return [Condition(true.branches, tuple(zero))]
        case WholeNumber() | Digits():
            return _write_count(draft, wire, holder, source)
        case _:
            assert_never(encoding)


def _write_count(draft: Draft, wire: Wire, holder: Holder, source: Expression) -> list[Statement]:
    value = wire.value
    raw = draft.local(_RAW[wire.bits.name], wire.bits)
    if isinstance(source.type, EnumType):
        wide = draft.world.raw_type(value.enum)
        enum_number = draft.local(_RAW[wide.name], wide)
        call = draft.world.enum_to_raw(value.enum, source, enum_number)
        return [
            draft.refusal(call.negated(), "unknown_value"),
            *_put(draft.world, wire, holder, raw, enum_number.converted(wire.whole)),
        ]
    statements = _closed(draft, wire, source)
    if value.const is not None:
        differs = source.converted(wire.whole).compared("<>", value.const)
        statements.append(draft.refusal(differs, "wrong_constant"))
    ranges, bounds = value.writable_ranges, bounds_of(value.encoding)
    if ranges is None and bounds != (wire.whole.low, wire.whole.high):
        ranges = Ranges((bounds,))
    if ranges is not None:
        sentinels = [interval for interval in value.special_intervals if not ranges.includes(*interval)]
        wrong = outside(source.converted(wire.whole), [*ranges.intervals, *sentinels])
        if wrong is not None:
            statements.append(draft.refusal(wrong, "out_of_range"))
    statements += _bounded_bits(draft, wire, source)
    return [*statements, *_put(draft.world, wire, holder, raw, source)]


def _bounded_bits(draft: Draft, wire: Wire, source: Expression) -> Iterator[Statement]:
    """The statements that refuse a word with a bit field that is out of its range."""
    word = draft.world.layout.device.flags.get(wire.value.flags)
    for bit in word.bounded if word is not None else ():
        wrong = outside_part(bit, wire.value.size, source)
        if wrong is not None:
            yield draft.refusal(wrong, "out_of_range")


def _put(world: World, wire: Wire, holder: Holder, raw: Variable, source: Expression) -> list[Statement]:
    """The statements that store a number, through a variable where it has several parts."""
    value, bits = wire.value, wire.bits_of(world, source)
    direct = holder.stored(0, value.size, wire.order, wire.swapped, bits)
    if len(direct) == 1:
        return direct
    return [Assignment(raw, bits), *holder.stored(0, value.size, wire.order, wire.swapped, raw)]


def write_number(wire: Wire, holder: Holder, count: int) -> list[Statement]:
    """The statements that write `count` times a number that users do not state: a constant or a default."""
    default = wire.value.default if isinstance(wire.value.default, int) else 0
    number_of = default if wire.value.const is None else wire.value.const
    statements: list[Statement] = []
    for index in range(count):
        start = index * wire.value.size
        if is_array(wire.value.encoding):
            statements += [holder.byte_stored(start + byte, Whole(0, BYTE)) for byte in range(wire.value.size)]
        else:
            statements += holder.stored(start, wire.value.size, wire.order, wire.swapped, wire.literal(number_of))
    return statements


_RAW = {name: f"{prefix}Raw" for name, prefix in PREFIXES.items()}


def _closed(draft: Draft, wire: Wire, tested: Expression) -> list[Statement]:
    """The statements that refuse a number that a closed enum does not list."""
    name = wire.value.enum
    if not name or draft.world.layout.device.enums[name].open:
        return []
    members = draft.world.layout.device.enums[name].members
    known = {member.value for member in members if not member.unavailable}
    intervals = merged([*((number, number) for number in known), *wire.value.special_intervals])
    refused = outside(tested.converted(wire.whole), intervals) if intervals else Truth(True)
    return [] if refused is None else [draft.refusal(refused, "unknown_value")]


def runs(values: Iterable[int]) -> list[tuple[int, int]]:
    """The intervals of consecutive numbers among values."""
    intervals: list[tuple[int, int]] = []
    for value in sorted(values):
        if intervals and intervals[-1][1] == value - 1:
            intervals[-1] = (intervals[-1][0], value)
        else:
            intervals.append((value, value))
    return intervals


def _characters_read(draft: Draft, wire: Wire, holder: Holder, target: Expression) -> list[Statement]:
    assert isinstance(target.type, ArrayType)
    statements: list[Statement] = []
    for index in range(wire.value.size):
        element = target.element(index)
        statements.append(Assignment(element, holder.byte(index)))
    return [*statements, *_ascii(draft, wire, target)]


def _write_characters(draft: Draft, wire: Wire, holder: Holder, source: Expression) -> list[Statement]:
    statements = _ascii(draft, wire, source)
    for index in range(wire.value.size):
        statements.append(holder.byte_stored(index, source.element(index)))
    return statements


def _ascii(draft: Draft, wire: Wire, array: Expression) -> list[Statement]:
    """The statements that refuse a text with characters beyond ASCII."""
    if not is_text(wire.value.encoding):
        return []
    index = draft.local("iCharacter")
    character = array.element(index).converted(UNSIGNED[1])
    test = draft.refusal(character.compared(">", 127), "unknown_value")
    return [Loop(index, number(0), number(wire.value.size - 1), (test,))]


_FIRST = {True: "high_word_first", False: "low_word_first"}


def word_order(wires: Iterable[Wire]) -> str:
    """`high_word_first` or `low_word_first` where values of several words have that order; else empty."""
    orders = {
        _FIRST[(wire.order == "big") != wire.swapped]
        for wire in wires
        if not is_array(wire.value.encoding) and wire.value.size > 2
    }
    return orders.pop() if len(orders) == 1 else "both_word_orders" if orders else ""


def order_remark(layout: DeviceLayout, unit: str, has_several: bool = True) -> str:
    """The comment on the order of a value's bytes or words; empty without several."""
    if not has_several:
        return ""
    device = layout.device
    byte = "high" if device.byte_order == "big" else "low"
    word = "high" if device.word_order == "big" else "low"
    if unit == "bytes":
        return f"The {byte} byte of several comes first on the wire."
    return f"The {word} word of several comes first; a word is a number, whatever its byte order in memory."
