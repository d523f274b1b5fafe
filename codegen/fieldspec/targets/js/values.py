"""Expressions and statements that read, check and write one value in an array of bytes."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import has_sign
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.primitives import Kind
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.text_form import UTF_16
from fieldspec.language.model.value import Value
from fieldspec.targets.js.text import flag, literal

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
        return self.value.type.kind is Kind.INTEGER and self.value.number_size(self.size) > 6

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
        """The expression of the raw number at `base` + `offset`."""
        if self.value.has_characters:
            return self._digits(place(base, offset))
        if self.value.digits:
            return self._of_bcd(base, offset)
        return self._binary(base, offset)

    def _binary(self, base: str, offset: int) -> str:
        """The expression of the binary number."""
        byte_terms = [byte(base, offset + place) for place in self.places]
        signed = self.value.type.signed and self.value.type.kind is Kind.INTEGER
        if self.size == 1:
            return f"({byte_terms[0]} << 24) >> 24" if signed else byte_terms[0]
        if self.size <= 4:
            terms = [_shifted(term, 8 * (self.size - 1 - place)) for place, term in enumerate(byte_terms)]
            joined = " | ".join(terms)
            if signed:
                return (
                    f"({joined})" if self.size == 4 else f"(({joined}) << {32 - 8 * self.size}) >> {32 - 8 * self.size}"
                )
            return f"(({joined}) >>> 0)" if self.size == 4 else f"({joined})"
        high, low = _unsigned(byte_terms[:-4]), _unsigned(byte_terms[-4:])
        if self.size <= 6:
            number = f"{high} * 4294967296 + {low}"
            return f"signed48({number}, {8 * self.size})" if signed else f"({number})"
        joined = f"(BigInt({high}) << 32n) | BigInt({low})"
        return f"BigInt.asIntN({8 * self.size}, {joined})" if signed else f"({joined})"

    def _digits(self, position: str) -> str:
        """The expression of the number of characters."""
        function = "blankDigitsOf" if self.value.has_blanks else "digitsOf"
        return f"{function}({literal(self.name)}, b, {position}, {self._form}, {flag(self.wide)})"

    def _of_bcd(self, base: str, offset: int) -> str:
        """The expression of the number of two decimal digits in each byte."""
        listing = ", ".join(byte(base, offset + place) for place in self.places)
        return f"bcdOf({literal(self.name)}, [{listing}], {place(base, offset)}, {flag(self.wide)})"

    @property
    def _form(self) -> str:
        """The arguments for digits: bytes, characters that they may be, places, whether there is a sign, and bits.

        Behind blanks, digits are decimal: bytes, places, and whether there may be a sign.
        """
        if self.value.has_blanks:
            return f"{self.size}, {self.value.places}, {flag(self.value.type.signed)}"
        letters = {"upper_hex": "ABCDEF", "lower_hex": "abcdef"}.get(self.value.digits, "")
        bits = 8 * self.value.type.size if letters and self.value.type.signed else 0
        return f'{self.size}, "0123456789{letters}", {self.value.places}, {flag(has_sign(self.value))}, {bits}'

    def stored(self, number: str, base: str, offset: int) -> list[str]:
        """The statements that write a number, given by the name of a variable."""
        if self.value.has_characters:
            function = "putBlankDigits" if self.value.has_blanks else "putDigits"
            return [f"{function}({number}, b, {place(base, offset)}, {self._form});"]
        if self.value.digits:
            places = ", ".join(place(base, offset + index) for index in self.places)
            return [f"putBcd({number}, b, [{places}]);"]
        targets = [byte(base, offset + place) for place in reversed(self.places)]
        if self.size > 6:
            return [
                f"{target} = Number({number if not k else f'({number} >> {8 * k}n)'} & 255n);"
                for k, target in enumerate(targets)
            ]
        if self.size > 4:
            return [
                f"{target} = {number if not k else f'Math.floor({number} / {256**k})'} % 256;"
                for k, target in enumerate(targets)
            ]
        return [f"{target} = {number if not k else f'{number} >>> {8 * k}'};" for k, target in enumerate(targets)]

    @property
    def known(self) -> list[int] | None:
        """The numbers of a closed enum that may be sent, with those that stand for no value; None without one."""
        enum = self.device.enums.get(self.value.enum)
        if enum is None or enum.open:
            return None
        members = {member.value for member in enum.members if not member.unavailable}
        return sorted(members | {sentinel.value for sentinel in self.value.sentinels})

    @property
    def sendable(self) -> list[tuple[int, int]]:
        """The numbers that may be sent, as intervals in ascending order."""
        low, high = self.value.type.low, self.value.type.high
        ranges = self.value.writable_ranges
        intervals = [(low, high)]
        if ranges is not None:
            special = [(sentinel.value, sentinel.value) for sentinel in self.value.sentinels]
            intervals = merged([*ranges.intervals, *special])
        intervals = [(max(low, first), min(high, last)) for first, last in intervals if last >= low and first <= high]
        if self.known is not None:
            return merged((n, n) for n in self.known if any(first <= n <= last for first, last in intervals))
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
        signed, size, low, high = (
            self.value.type.signed,
            self.value.type.size,
            self.value.type.low,
            self.value.type.high,
        )
        if self.wide:
            return f'typeof {number} === "bigint" && {number} >= {low}n && {number} <= {high}n'
        if size == 4:
            return f"({number} | 0) === {number}" if signed else f"({number} >>> 0) === {number}"
        if size < 4:
            bounds = f" && {number} >= {low} && {number} <= {high}" if signed else f" && {number} <= {high}"
            return (f"({number} | 0) === {number}" if signed else f"({number} >>> 0) === {number}") + bounds
        return f"Number.isInteger({number}) && {number} >= {low} && {number} <= {high}"

    def read(self, variable: str, base: str, offset: int) -> Reading:
        """How the value at `base` + `offset` is read into a variable."""
        kind, name = self.value.type.kind, literal(self.name)
        position = place(base, offset)
        if kind is Kind.TEXT:
            if self.value.text_form is not None:
                call = f"encodedTextOf({name}, b, {position}, {self.value.size}, {self._text_form})"
                return Reading((), call, throws=True)
            return Reading((), f"textOf({name}, b, {position}, {self.size})", throws=True)
        if kind is Kind.BYTES:
            return Reading((), f"b.slice({position}, {place(base, offset + self.size)})")
        number = self.number(base, offset)
        if kind is Kind.FLOAT:
            return Reading((), f"{'doubleOf' if self.size == 8 else 'floatOf'}({number})")
        if kind is Kind.BOOLEAN:
            return Reading((), f"booleanOf({name}, {number}, {position})", throws=True)
        checks = list(self._checks(variable, position))
        if self.value.digits and not checks:
            return Reading((), number, throws=True)
        return Reading((f"const {variable} = {number};", *checks), variable) if checks else Reading((), number)

    def _checks(self, variable: str, position: str) -> Iterator[str]:
        """The statements that refuse a number that was received."""
        const, known = self.value.const, self.known
        low, high = self.value.type.low, self.value.type.high
        if const is not None:
            wrong = throw_wrong_number("wrong_const", self.name, variable, literal(f"not {const}"), position)
            yield f"if ({variable} !== {self.digits(const)}) {wrong}"
        if self.size > self.value.size:
            wrong = throw_wrong_number("unknown_value", self.name, variable, literal(f"not in {low}..{high}"), position)
            yield f"if ({variable} < {low} || {variable} > {high}) {wrong}"
        if known is not None and (test := self.test(variable, merged((number, number) for number in known))):
            text = literal(f"which {self.value.enum} does not list")
            yield f"if (!({test})) {throw_wrong_number('unknown_value', self.name, variable, text, position)}"

    def write(self, variable: str, base: str, offset: int) -> list[str]:
        """The statements that check a value, given by the name of a variable, and write it."""
        kind, name = self.value.type.kind, literal(self.name)
        position = place(base, offset)
        if kind is Kind.TEXT:
            if self.value.text_form is not None:
                return [f"putEncodedText({name}, {variable}, b, {position}, {self.value.size}, {self._text_form});"]
            return [f"putText({name}, {variable}, b, {position}, {self.size});"]
        if kind is Kind.BYTES:
            return [f"putBytes({name}, {variable}, b, {position}, {self.size});"]
        raw = f"{variable}Raw"
        if kind is Kind.BOOLEAN:
            return [f"const {raw} = numberOf({name}, {variable});", *self.stored(raw, base, offset)]
        if kind is Kind.FLOAT:
            arguments = f"{name}, {variable}, {self._float_ranges()}"
            function = "doubleBitsOf" if self.size == 8 else "bitsOf"
            return [f"const {raw} = {function}({arguments});", *self.stored(raw, base, offset)]
        return [*self.refusals(variable), *self.stored(variable, base, offset)]

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
        if self.value.size > 4 and not self.wide:
            # `&` has 32 bits, so the bits of a number of five or six bytes are divided out.
            first = bit.mask & -bit.mask
            masked = f"(Math.floor({number} / {first}) % {bit.mask // first + 1} * {first})"
        end = "n" * self.wide
        tests = [
            " && ".join([f"{masked} >= {low}{end}"] * (low > 0) + [f"{masked} <= {high}{end}"] * (high < bit.mask))
            for low, high in bit.images
        ]
        return " || ".join(f"({test})" for test in tests)

    def _number_refusals(self, variable: str) -> Iterator[str]:
        """The statements that refuse a number for its type, its enum and its range."""
        name, known = literal(self.name), self.known
        low, high = self.value.type.low, self.value.type.high
        tests = [self.whole(variable)]
        if known is not None:
            members = merged((number, number) for number in known)
            test = self.test(variable, members)
            test = f"{tests[0]} && ({test})" if test else tests[0]
            arguments = f"{name}, {variable}, {literal(self.value.enum)}, {flag(self.wide)}"
            yield f"if (!({test})) throw refusedMember({arguments});"
        if sendable_test := self.test(variable, self.sendable):
            tests.append(f"({sendable_test})" if " || " in sendable_test else sendable_test)
        if known is not None and self.sendable == merged((number, number) for number in known):
            return
        ranges = self.value.writable_ranges
        allowed = literal(ranges.text() if ranges else f"{low}..{high}")
        arguments = f"{name}, {variable}, {self.digits(low)}, {self.digits(high)}, {allowed}"
        yield f"if (!({' && '.join(tests)})) throw refusedNumber({arguments});"

    @property
    def _text_form(self) -> str:
        """The form of a text: `{ encoding: "utf_16", padding: 32, little: true }`"""
        form = self.value.text_form
        assert form is not None
        parts = [f"encoding: {literal(form.encoding)}"]
        parts += [f"padding: {form.padding}"] if form.padding else []
        parts += ["isRight: true"] if form.is_right else []
        parts += [f"terminator: {form.terminator}"] if form.terminator is not None else []
        parts += ["isTurned: true"] if form.is_turned else []
        parts += ["little: true"] if form.encoding == UTF_16 and self.order != "big" else []
        return f"{{ {', '.join(parts)} }}"

    def constant(self, number: int, base: str, offset: int) -> list[str]:
        """The statements that write a number that is known."""
        data = (number & ((1 << (8 * self.size)) - 1)).to_bytes(self.size, "big")
        return [
            f"{byte(base, offset + index)} = {value};" for index, value in zip(self.places, data, strict=True) if value
        ]


def byte(base: str, offset: int) -> str:
    """The byte at `base` + `offset` of the array `b`."""
    return f"b[{place(base, offset)}]"


def place(base: str, offset: int) -> str:
    """The expression of an offset from the start of the data: `o + 4`, or `o` for 0."""
    return f"{base} + {offset}" if offset else base


def throw_wrong_number(reason: str, name: str, number: str, detail: str, position: str) -> str:
    """The statement that refuses a number; `number`, `detail` and `position` are expressions."""
    return f"throw wrongNumber({literal(reason)}, {literal(name)}, {number}, {detail}, {position});"


def _shifted(term: str, shift: int) -> str:
    return f"({term} << {shift})" if shift else term


def _unsigned(terms: list[str]) -> str:
    """The number of up to four bytes, without a sign."""
    joined = " | ".join(_shifted(term, 8 * (len(terms) - 1 - index)) for index, term in enumerate(terms))
    return f"(({joined}) >>> 0)" if len(terms) == 4 else f"({joined})"
