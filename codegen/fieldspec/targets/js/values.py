"""Expressions and statements that read, check and write one value in an array of bytes."""

from __future__ import annotations

import json
from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import (
    NIBBLES,
    PACKED_DECIMAL,
    digits_bytes,
    digits_letters,
    has_sign,
    is_complement,
)
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    number_of,
    sign_of,
    whole_bits,
)
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.text_form import UTF_16, TextForm
from fieldspec.language.model.value import Value
from fieldspec.targets.explainer.codecs import constant_name
from fieldspec.targets.js.number_bytes import (
    BYTES_OF_OPERATOR,
    byte,
    place,
    real_functions,
    stored_bits,
    whole_number,
)
from fieldspec.targets.js.text import flag, literal, runs_of
from fieldspec.targets.runtime_values import is_wide, sign_data

INLINE = 6
"""The number of intervals up to which a test is written out; more are looked up in an array."""


@dataclass(frozen=True, slots=True)
class Reading:
    """How a value is read: statements that bind and check it, and its expression, which may throw too."""

    lines: tuple[str, ...]
    expression: str
    throws: bool = False


@dataclass(frozen=True, slots=True)
class Slot:
    """A value in `size` bytes, which may be more than its type has. `order` and `swapped` as in `FieldLayout`."""

    name: str
    value: Value
    size: int
    order: str
    swapped: bool
    device: Device

    @property
    def wide(self) -> bool:
        """Whether its numbers are bigints."""
        return is_wide(self.value.encoding)

    @property
    def places(self) -> tuple[int, ...]:
        """The places of its bytes, the most significant one first."""
        places = list(range(self.size))
        if self.order != "big":
            places.reverse()
        if self.swapped:
            words = [places[index : index + 2] for index in range(0, self.size, 2)]
            places = [place for word in reversed(words) for place in word]
        return tuple(places)

    def number(self, base: str, offset: int) -> str:
        """The expression of the raw number at `base` + `offset`. Raises AssertionError for a text and for bytes."""
        encoding = self.value.encoding
        match encoding:
            case Whole():
                return whole_number(encoding.sign, self._bytes(base, offset))
            case Real() | Truth():
                return whole_number(Sign.NONE, self._bytes(base, offset))
            case Digits():
                return self._digits(encoding, base, offset)
            case Text() | Octets():
                raise AssertionError("a text or bytes are not a number")
            case _:
                assert_never(encoding)

    def _bytes(self, base: str, offset: int) -> list[str]:
        """Its bytes, the most significant one first."""
        return [byte(base, offset + index) for index in self.places]

    def _digits(self, digits: Digits, base: str, offset: int) -> str:
        """The expression of the number of characters, or of two decimal digits in each byte."""
        name, wide, position = literal(self.name), flag(self.wide), place(base, offset)
        if self.value.codec:
            return f"codedNumberOf({name}, b, {position}, {wide}, {digits.size}, {constant_name(self.value.codec)})"
        if digits.form in NIBBLES:
            listing = ", ".join(self._bytes(base, offset))
            return f"bcdOf({name}, [{listing}], {position}, {wide}{_sign_nibble(digits)})"
        if digits.has_blanks:
            return f"blankDigitsOf({name}, b, {position}, {self._form(digits)}, {wide})"
        return f"digitsOf({name}, b, {position}, {wide}, {self._form(digits)})"

    def _form(self, digits: Digits) -> str:
        """The arguments for digits: bytes, characters that they may be, places, whether there is a sign, and bits.

        After blanks, digits are decimal: bytes, places, and whether there may be a sign.
        """
        if digits.has_blanks:
            return f"{digits.size}, {digits.places}, {flag(digits.number.sign.is_signed)}"
        letters = digits_letters(self.value).decode("ascii")
        bits = digits.number.bits if is_complement(self.value) else 0
        low_first = ", true" * self.value.is_low_first
        return f'{digits.size}, "{letters}", {digits.places}, {flag(has_sign(self.value))}, {bits}{low_first}'

    def stored(self, number: str, base: str, offset: int) -> list[str]:
        """The statements that write a number, given by the name of a variable. Raises AssertionError like `number`."""
        encoding = self.value.encoding
        match encoding:
            case Whole():
                return self._stored_whole(encoding, number, base, offset)
            case Real() | Truth():
                return stored_bits(number, self._bytes(base, offset))
            case Digits():
                if self.value.codec:
                    form = constant_name(self.value.codec)
                    return [f"putCodedNumber({number}, b, {place(base, offset)}, {form});"]
                if encoding.form in NIBBLES:
                    places = ", ".join(place(base, offset + index) for index in self.places)
                    return [f"putBcd({number}, b, [{places}]{_sign_nibble(encoding)});"]
                function = "putBlankDigits" if encoding.has_blanks else "putDigits"
                return [f"{function}({number}, b, {place(base, offset)}, {self._form(encoding)});"]
            case Text() | Octets():
                raise AssertionError("a text or bytes are not a number")
            case _:
                assert_never(encoding)

    def _stored_whole(self, whole: Whole, number: str, base: str, offset: int) -> list[str]:
        match whole.sign:
            case Sign.NONE | Sign.COMPLEMENT:
                return stored_bits(number, self._bytes(base, offset))
            case Sign.MAGNITUDE:
                bits = f"{number}Bits"
                stored = stored_bits(bits, self._bytes(base, offset))
                return [f"const {bits} = magnitudeBits({number}, {whole.bits});", *stored]
            case _:
                assert_never(whole.sign)

    @property
    def known(self) -> list[tuple[int, int]] | None:
        """The numbers of a closed enum that may be sent, with those that stand for no value; None without one."""
        enum = self.device.enums.get(self.value.enum)
        if enum is None or enum.open:
            return None
        members = ((member.value, member.value) for member in enum.members if not member.unavailable)
        return merged([*members, *self.value.special_intervals])

    @property
    def sendable(self) -> list[tuple[int, int]]:
        """The numbers that may be sent, as intervals in ascending order."""
        low, high = self.value.type.low, self.value.type.high
        ranges = self.value.writable_ranges
        intervals = [(low, high)]
        if ranges is not None:
            intervals = merged([*ranges.intervals, *self.value.special_intervals])
        intervals = [(max(low, first), min(high, last)) for first, last in intervals if last >= low and first <= high]
        if self.known is not None:
            return [
                (max(low, first), min(high, last))
                for low, high in self.known
                for first, last in intervals
                if max(low, first) <= min(high, last)
            ]
        return intervals

    def digits(self, number: int) -> str:
        """A number as a literal of its type."""
        return f"{number}n" if self.wide else str(number)

    def test(self, number: str, intervals: list[tuple[int, int]]) -> str:
        """The condition that a number of the type is in one of some intervals; empty where all are."""
        low, high = self.value.type.low, self.value.type.high
        if intervals == [(low, high)]:
            return ""
        if len(intervals) > INLINE:
            rows = ", ".join(f"[{self.digits(first)}, {self.digits(last)}]" for first, last in intervals)
            return f"within([{rows}], {number})"
        terms = []
        for first, last in intervals:
            parts = [f"{number} >= {self.digits(first)}"] * (first > low) + [f"{number} <= {self.digits(last)}"] * (
                last < high
            )
            terms.append(f"{number} === {self.digits(first)}" if first == last else " && ".join(parts))
        return " || ".join(f"({term})" if " && " in term and len(terms) > 1 else term for term in terms) or "false"

    def whole(self, number: str) -> str:
        """The condition that a value of any type is a number of the type of the slot."""
        low, high, whole = self.value.type.low, self.value.type.high, number_of(self.value.encoding)
        assert whole is not None
        if self.wide:
            return f'typeof {number} === "bigint" && {number} >= {low}n && {number} <= {high}n'
        if whole.bits > 8 * BYTES_OF_OPERATOR:
            return f"Number.isInteger({number}) && {number} >= {low} && {number} <= {high}"
        if low == 0 and high & (high + 1) == 0 and whole.bits < 8 * BYTES_OF_OPERATOR:
            return f"{number} === ({number} & {high})"
        operator, widest = ("|", Whole(32, Sign.COMPLEMENT)) if whole.sign.is_signed else (">>>", Whole(32, Sign.NONE))
        lowest, highest = widest.bounds
        bounds = [f"{number} >= {low}"] * (low > lowest) + [f"{number} <= {high}"] * (high < highest)
        return " && ".join([f"{number} === ({number} {operator} 0)", *bounds])

    def read(self, variable: str, base: str, offset: int) -> Reading:
        """How the value at `base` + `offset` is read into a variable."""
        encoding, name = self.value.encoding, literal(self.name)
        position = place(base, offset)
        match encoding:
            case Text():
                if encoding.form is None:
                    return Reading((), f"textOf({name}, b, {position}, {self.size})", throws=True)
                call = f"encodedTextOf({name}, b, {position}, {encoding.size}, {self._text_form(encoding.form)})"
                return Reading((), call, throws=True)
            case Octets() if self.value.is_marked:
                mark = f"b.lastIndexOf(1, {place(base, offset + self.size - 1)})"
                return Reading((), f"b.slice({position}, {mark})")
            case Octets():
                return Reading((), f"b.slice({position}, {place(base, offset + self.size)})")
            case Real():
                return Reading((), f"{real_functions(encoding.precision)[0]}({self.number(base, offset)})")
            case Truth():
                return Reading((), f"booleanOf({name}, {self.number(base, offset)}, {position})", throws=True)
            case Whole() | Digits():
                return self._read_count(variable, base, offset)
            case _:
                assert_never(encoding)

    def _read_count(self, variable: str, base: str, offset: int) -> Reading:
        number, checks = self.number(base, offset), list(self._checks(variable, place(base, offset)))
        if checks:
            return Reading((f"const {variable} = {number};", *checks), variable)
        return Reading((), number, throws=bool(self.value.digits))

    def _checks(self, variable: str, position: str) -> Iterator[str]:
        """The statements that refuse a number that was received."""
        const, known = self.value.const, self.known
        if const is not None:
            wrong = throw_wrong_number("wrong_const", self.name, variable, literal(f"not {const}"), position)
            yield f"if ({variable} !== {self.digits(const)}) {wrong}"
        if known is not None and (test := self.test(variable, known)):
            text = literal(f"which {self.value.enum} does not list")
            yield f"if (!({test})) {throw_wrong_number('unknown_value', self.name, variable, text, position)}"

    def write(self, variable: str, base: str, offset: int) -> list[str]:
        """The statements that check a value, given by the name of a variable, and write it."""
        encoding, name = self.value.encoding, literal(self.name)
        position, raw = place(base, offset), f"{variable}Raw"
        match encoding:
            case Text():
                if encoding.form is None:
                    return [f"putText({name}, {variable}, b, {position}, {self.size});"]
                form = self._text_form(encoding.form)
                return [f"putEncodedText({name}, {variable}, b, {position}, {encoding.size}, {form});"]
            case Octets() if self.value.is_marked:
                put = f"putBytes({name}, {variable}, b, {position}, {self.value.size}, 0);"
                return [put, f"b[{position} + {variable}.length] = 1;"]
            case Octets():
                data = variable if self.size else f"{variable} ?? new Uint8Array()"
                return [f"putBytes({name}, {data}, b, {position}, {self.size});"]
            case Truth():
                return [f"const {raw} = numberOf({name}, {variable});", *self.stored(raw, base, offset)]
            case Real():
                function = real_functions(encoding.precision)[1]
                call = f"{function}({name}, {variable}, {self._float_ranges()})"
                return [f"const {raw} = {call};", *self.stored(raw, base, offset)]
            case Whole() | Digits():
                return [*self.refusals(variable), *self.stored(variable, base, offset)]
            case _:
                assert_never(encoding)

    def _float_ranges(self) -> str:
        """The ranges of a floating-point number, and the numbers beside them that stand for no value."""
        ranges = self.value.ranges
        intervals = "null" if ranges is None else f"[{', '.join(f'[{low}, {high}]' for low, high in ranges.intervals)}]"
        absent_numbers = ", ".join(
            "NaN" if sentinel.is_nan else str(sentinel.value) for sentinel in self.value.sentinels
        )
        return f"{intervals}, [{absent_numbers}]"

    def refusals(self, variable: str) -> Iterator[str]:
        """The statements that refuse a number that may not be sent: for its constant, its enum, and then its range."""
        name, const = literal(self.name), self.value.const
        if const is not None:
            wrong = throw_wrong_number("wrong_const", self.name, variable, literal(f"not {const}"), "null")
            yield f"if ({variable} !== {self.digits(const)}) {wrong}"
            return
        yield from self._number_refusals(variable)
        word = self.device.flags.get(self.value.flags)
        for bit in word.bounded if word is not None else ():
            allowed = literal(bit.ranges.text() if bit.ranges is not None else "")
            yield f"if (!({self._bit_test(variable, bit)})) throw refusedBits({name}, {literal(bit.name)}, {allowed});"

    def _bit_test(self, number: str, bit: Bit) -> str:
        """The condition that a field of bits of a word is in its range."""
        masked = f"({number} & {bit.mask}n)" if self.wide else f"(({number} & {bit.mask}) >>> 0)"
        if bit.pieces:
            masked = f"bitsNumber({runs_of(bit)}, {number}, false)"
        elif self.value.size > BYTES_OF_OPERATOR and not self.wide:
            # `&` has 32 bits, so the bits of a number of five or six bytes are divided out.
            first = bit.mask & -bit.mask
            masked = f"(Math.floor({number} / {first}) % {bit.mask // first + 1} * {first})"
        end = "n" * self.wide
        tests = [
            " && ".join(
                [f"{masked} >= {low}{end}"] * (low > 0) + [f"{masked} <= {high}{end}"] * (high < bit.greatest_image)
            )
            for low, high in bit.images
        ]
        return " || ".join(f"({test})" for test in tests)

    def _number_refusals(self, variable: str) -> Iterator[str]:
        """The statements that refuse a number for its type, its enum and its range."""
        name, known = literal(self.name), self.known
        low, high = self.value.type.low, self.value.type.high
        tests = [self.whole(variable)]
        if known is not None:
            test = self.test(variable, known)
            test = f"{tests[0]} && ({test})" if test else tests[0]
            arguments = f"{name}, {variable}, {literal(self.value.enum)}, {flag(self.wide)}"
            yield f"if (!({test})) throw refusedMember({arguments});"
        if sendable_test := self.test(variable, self.sendable):
            tests.append(f"({sendable_test})" if " || " in sendable_test else sendable_test)
        if known is not None and self.sendable == known:
            return
        ranges = self.value.writable_ranges
        allowed = literal(ranges.text() if ranges else f"{low}..{high}")
        arguments = f"{name}, {variable}, {allowed}{', true' * self.wide}"
        yield f"if (!({' && '.join(tests)})) throw refusedNumber({arguments});"

    def _text_form(self, form: TextForm) -> str:
        """The form of a text: `{ encoding: "utf_16", padding: 32, little: true }`"""
        parts = [f"encoding: {literal(form.encoding)}"]
        parts += [f"padding: {form.padding}"] if form.padding else []
        parts += ["isRight: true"] if form.is_right else []
        parts += [f"terminator: {form.terminator}"] if form.terminator is not None else []
        parts += ["isTurned: true"] if form.is_turned else []
        parts += ["little: true"] if form.encoding == UTF_16 and self.order != "big" else []
        return f"{{ {', '.join(parts)} }}"

    def constant(self, number: int, base: str, offset: int) -> list[str]:
        """The statements that write a number that is known."""
        places = tuple(range(self.size)) if self.value.has_characters else self.places
        if self.value.digits:
            data = digits_bytes(self.value, number)
        else:
            data = whole_bits(Whole(8 * self.size, sign_of(self.value.encoding)), number).to_bytes(self.size, "big")
        return [f"{byte(base, offset + index)} = {value};" for index, value in zip(places, data, strict=True) if value]


def value_functions(read: Slot, write: Slot) -> tuple[str, str]:
    """The functions that read and write a value in its own bytes."""
    reading = read.read("number", "o", 0)
    body = f"{{ {' '.join(reading.lines)} return {reading.expression}; }}" if reading.lines else reading.expression
    return f"(b, o) => {body}", f"(value, b, o) => {{ {' '.join(write.write('value', 'o', 0))} }}"


def sign_literal(value: Value) -> str:
    """How the number of a value shows that it is below zero, as the runtime knows it."""
    return json.dumps(sign_data(value.encoding))


def throw_wrong_number(reason: str, name: str, number: str, detail: str, position: str) -> str:
    """The statement that refuses a number; `number`, `detail` and `position` are expressions."""
    return f"throw wrongNumber({literal(reason)}, {literal(name)}, {number}, {detail}, {position});"


def _sign_nibble(digits: Digits) -> str:
    """The further arguments for digits with a nibble that is a sign: whether there may be `-`, and the form."""
    signed, is_packed = digits.number.sign.is_signed, digits.form == PACKED_DECIMAL
    return f", {flag(signed)}" * (signed or is_packed) + f", {literal(digits.form)}" * is_packed
