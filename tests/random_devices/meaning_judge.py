"""What values mean as a judge: quantities, names and bits of the explainer, and what people enter for values."""

from __future__ import annotations

import random
import struct
from collections.abc import Iterator
from decimal import Context, Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.values import DecodedValue, decode_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.values import MeaningError, raw_of
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.bits import bit_places, bits_of_word, number_of_bits, printed_number
from fieldspec.codec.reference.quantities import (
    NoQuantityError,
    count_of_quantity,
    quantity,
    scale_of,
    special_name,
    special_number,
)
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import replace
from fieldspec.language.model.encoding import is_count, is_real
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.value import Value
from python_package import class_of
from random_devices.drawn_words import pieces_text
from random_devices.inputs import number_or_text
from random_devices.meanings import Leaf, Meaning, leaves, meaning_of
from random_devices.python_judge import module_of_device
from random_devices.queries import Answer, Query, shapes

_FULL_PLACES = 6
"""Quantities with at most so many places are printed in full."""


class Meanings:
    """Says nothing about queries; raises AssertionError where a value means something else to the explainer."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.device = layout, layout.device
        self.codecs = codec(layout).links
        self.module = module_of_device(layout, number)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        for query in queries:
            if query.kind == "frame" and query.values is None:
                self._assert_frame(query)
        dice = random.Random(len(queries))
        for _, path, (value, order, swapped, _, _) in shapes(self.layout):
            self._assert_states(path[-1], value, order, swapped)
            for _ in range(4):
                raw = number_or_text(self.layout, value, dice)
                if is_count(value.encoding) and value.low <= raw <= value.high:
                    data = value_construct(value, order, swapped).build(raw)
                    read = decode_value(self.device, value, data, order, swapped)
                    self._assert_meaning(" ".join(path), Leaf("", value, raw, order, swapped, False), read)
        for word in self.device.flags.values():
            self._assert_word(word, dice.getrandbits(8 * word.type.size))
        return [Answer(reason=None)] * len(queries)

    # Decoding

    def _assert_frame(self, query: Query) -> None:
        link, direction, message = query.path
        try:
            wanted = self.codecs[link].decode(query.data, direction, message)
        except CodecError:
            return
        assert wanted.body is not None
        explanation = explained(self.layout, link, direction, query.data, message)
        rows = {row.path: row for row in explanation.rows if row.kind == "field"}
        for leaf in leaves(wanted.body, wanted.values):
            row = rows.get(leaf.path)
            if row is not None and leaf.value.parameter is None and not leaf.is_reserved:
                self._assert_meaning(f"{query.data.hex(' ')}: {leaf.path}", leaf, row)
        self._assert_entered(wanted.body, wanted.values)

    def _assert_meaning(self, text: str, leaf: Leaf, read: ExplanationRow | DecodedValue) -> None:
        """The quantity as it is printed, the names, and the bits of a value."""
        meaning = meaning_of(self.device, leaf.value, leaf.raw)
        printed = read.value if isinstance(read, ExplanationRow) else read.text
        conversion_meanings = [each for each in read.meanings if each.text.endswith(" of its reference")]
        for each in conversion_meanings:
            full = self.device.conversions[each.name].full_scale
            share, wanted = Fraction(each.text.split(" ")[0]), Fraction(100 * leaf.raw, full)
            assert abs(share - wanted) <= abs(wanted) / 10**5, f"{text}: {leaf.raw} is {share} %, not {float(wanted)} %"
        value_meanings = [each for each in read.meanings if each.kind != "state" and each not in conversion_meanings]
        names = [each.name for each in value_meanings if each.name]
        assert names == list(meaning.names), f"{text}: {leaf.raw} is {names}, not {meaning.names}"
        assert [each.bits for each in value_meanings if not each.name] == [str(place) for place in meaning.others], text
        is_number = is_count(leaf.value.encoding) or is_real(leaf.value.encoding)
        has_quantity = is_number and not meaning.state and not leaf.value.flags
        exact = quantity(leaf.value, leaf.raw, leaf.power) if has_quantity else None
        assert_printed(f"{text}: {leaf.raw}", leaf, exact, printed if exact is not None else "")
        if leaf.value.flags:
            self._assert_bits(text, leaf, meaning, read)

    def _assert_bits(self, text: str, leaf: Leaf, meaning: Meaning, read: ExplanationRow | DecodedValue) -> None:
        word = self.device.flags[leaf.value.flags]
        number = leaf.raw % (1 << 8 * word.type.size)
        bits = bits_of_word(word, number)
        states = [
            state.name
            for state in word.states
            if all(self._is(word, name, bits, 1) for name in state.set)
            and all(self._is(word, name, bits, 0) for name in state.clear)
        ]
        have = [each.name for each in read.meanings if each.kind == "state"]
        assert have == states, f"{text}: {number:#x} has the states {have}, not {states}"
        own = {each.name.partition("=")[0]: each for each in read.meanings if each.kind != "state" and each.name}
        for bit in word.bits:
            own_meaning = own.get(bit.name)
            if own_meaning is None:
                continue
            places = pieces_text(bit_places(bit))
            assert own_meaning.bits == places, f"{text}: {bit.name} is at {own_meaning.bits}, not {places}"
            if bit.unit and bit.last > bit.first and not bit.enum:
                exact = quantity(bit.as_value, number_of_bits(word, bit, number))
                own_leaf = Leaf("", bit.as_value, number, "big", False, False)
                assert_printed(f"{text}: {bit.name}", own_leaf, exact, own_meaning.text.partition(": ")[0])
        most = printed_number(word, 8 * word.type.size - 1)
        has_remark = any(f"bit {8 * word.type.size - 1} is its bit {most}." in note for note in read.notes)
        assert has_remark == (most == 0 and any(each.bits for each in read.meanings)), f"{text}: {read.notes}"

    def _read_word(self, word: Flags, number: int) -> tuple[Leaf, DecodedValue]:
        value = replace(
            word.bits[0].as_value, type=word.type, size=word.type.size, flags=word.name, enum="", ranges=None, unit="",
            scale=Decimal(1), scale_text="", offset=Decimal(0), default=None,
        )  # fmt: skip
        data = number.to_bytes(word.type.size, "big")
        return Leaf("", value, number, "big", False, False), decode_value(self.device, value, data, "big", False)

    @staticmethod
    def _is(word: Flags, name: str, bits: list[int], level: int) -> bool:
        bit = next(bit for bit in word.bits if bit.name == name)
        return all(bits[place] == level for place in bit_places(bit))

    def _assert_word(self, word: Flags, number: int) -> None:
        """The explainer has the numbers of all bits; generated Python has them too, and sets each alone."""
        self._assert_meaning(word.name, *self._read_word(word, number))
        bits = [bit for bit in word.bits if not bit.reserved]
        of = class_of(self.module, word.name, "Flags")
        wanted = [number_of_bits(word, bit, number) for bit in bits]
        assert list(of(number).flags().values()) == wanted, f"{word.name} {number:#x}: {of(number).flags()}"
        for (name, own), bit in zip(of(number).flags().items(), bits, strict=True):
            image = int(of(0, **{name: own}))
            assert image == number & sum(1 << place for place in bit_places(bit)), f"{word.name} {name}: {image:#x}"

    # Encoding

    def _assert_entered(self, record: RecordLayout, values: dict[str, Any]) -> None:
        """What people write for a value is that value."""
        if record.selector is not None:
            return
        for field in record.fields:
            value = field.value
            if value is None or field.is_list or field.field.reserved or value.parameter is not None:
                continue
            raw = values[field.name]
            for entered, wanted in entries(self.layout, value, raw):
                have: Any
                try:
                    have = raw_of(self.device, (), record, {field.name: entered})[field.name]
                except MeaningError as error:
                    have = f"refused: {error.detail}"
                if isinstance(wanted, str) and isinstance(have, str) and wanted in have:
                    continue
                assert have == wanted, f"{field.name} entered as {entered!r} is {have}, not {wanted}"

    def _assert_states(self, name: str, value: Value, order: str, swapped: bool) -> None:
        """Each state has its bytes, and these bytes mean it."""
        if value.const is not None:
            return
        for sentinel in value.sentinels:
            numbers = {special_number(value, sentinel.name)} if sentinel.is_nan else set(sentinel.interval)
            for number in numbers:
                data = value_construct(value, order, swapped).build(number)
                read = decode_value(self.device, value, data, order, swapped)
                names = [meaning.name for meaning in read.meanings]
                assert names == [sentinel.name], f"{name}: {data.hex(' ')} is {names}, not {sentinel.name}"
                assert not read.text, f"{name}: {data.hex(' ')} is {read.text}, and stands for {sentinel.name}"


def assert_printed(text: str, leaf: Leaf, exact: Fraction | None, printed: str) -> None:
    """A quantity is printed in full, or rounded to places that tell counts apart, with its unit."""
    value, is_float = leaf.value, is_real(leaf.value.encoding)
    own_unit = value.unit if leaf.power is None else value.quantity_unit
    scale = scale_of(value, leaf.power)
    has_none = exact is None or not (own_unit or ((scale != 1 or value.offset != 0) and not is_float))
    number, _, unit = printed.partition(" ")
    if has_none:
        assert not printed, f"{text} is {printed}, and has no quantity"
        return
    assert exact is not None
    assert unit == own_unit, f"{text} is {printed}, and its unit is {own_unit}"
    if is_float:
        form = {2: "<e", 4: "<f", 8: "<d"}[value.size]
        assert struct.pack(form, float(number)) == struct.pack(form, leaf.raw), f"{text} is printed as {number}"
        return
    own = Fraction(Decimal(number))
    if (exact * 10**_FULL_PLACES).denominator == 1:
        assert own == exact, f"{text} is {number}, not {exact}"
        return
    places = len(number.partition(".")[2])
    last = Fraction(1, 10**places)
    if own != exact:
        assert last < abs(scale), f"{text}: {number} does not tell counts apart"
    assert abs(own - exact) <= last / 2, f"{text} is {number}, not {float(exact)}"


def entries(layout: DeviceLayout, value: Value, raw: Any) -> Iterator[tuple[Any, Any]]:
    """What people may write for a raw value, and the raw value that it is, or a part of the reason for none."""
    if not is_count(value.encoding) or value.const is not None:
        return
    state = special_name(value, raw)
    for sentinel in value.sentinels:
        yield sentinel.name, special_number(value, sentinel.name)
    if value.enum and not state:
        member = layout.device.enums[value.enum].member(raw)
        for name in (member.name, *member.aliases) if member is not None else ():
            yield name, raw
    elif value.flags:
        word = layout.device.flags[value.flags]
        bits = [bit for bit in word.bits if not bit.reserved]
        image = sum(_image(bit, number_of_bits(word, bit, raw)) for bit in bits)
        reserved_bits = sum(_image(bit, bit.default or 0) for bit in word.bits if bit.reserved)
        yield [f"{bit.name}={number_of_bits(word, bit, raw)}" for bit in bits], image | reserved_bits
    elif value.unit and not value.scale_by and not value.enum:
        exact = quantity(value, raw) or Fraction(raw) * scale_of(value) + Fraction(value.offset)
        scaled = exact * 10**30
        if scaled.denominator == 1 and abs(exact) < 10**29:
            text = f"{Decimal(scaled.numerator).scaleb(-30, Context(prec=100)):f}"
            try:
                wanted: Any = count_of_quantity(value, exact)
            except NoQuantityError as error:
                wanted = error.state
            yield f"{text.rstrip('0').rstrip('.')} {value.unit}", wanted


__all__ = ["Meanings"]


def _image(bit: Bit, number: int) -> int:
    """The word in which the bits of a field are those of a number."""
    return sum((number >> index & 1) << place for index, place in enumerate(bit_places(bit)))
