"""Generated functions compared with the reference codec on random values and random and damaged bytes."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from typing import Any

from drawing import drawn_bytes, drawn_values
from loaded import judged, reason, words_in
from proving import Proof, without

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.quantities import state_name
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.value import OUT_OF_RANGE, Value
from fieldspec.targets.controllers.routines.absent import absent_values, ranged_values
from fieldspec.targets.controllers.routines.quantities import quantities
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.wrapping import framed
from fieldspec.targets.controllers.statements.expressions import EnumType


def compare_telegrams(prover: Proof, dice: random.Random, tries: int) -> None:
    """Compares the functions for process data, on random bytes and values. Raises AssertionError."""
    for message in telegrams(prover.world.layout):
        for data in (message.request, message.response):
            for _ in range(tries if data.size else 0):
                there_and_back(prover, data, drawn_bytes(data, dice))
                values = drawn_values(prover.world.layout, data, dice)
                for unit in ("bytes", "words") if data.size and data.size % 2 == 0 else ("bytes",):
                    packed(prover, data, unit, values)


def compare_states(prover: Proof) -> None:
    """Compares what tells special values, and values out of range, from others, on the numbers about each bound.

    Raises AssertionError.
    """
    world, device = prover.world, prover.world.layout.device
    for name, same in absent_values(world.layout).items():
        value = same[0].value
        for number in numbers_about(value, value.special_intervals):
            actual = is_true(prover, world.routine(name, "is_absent"), number)
            assert actual == (value.sentinel(number) is not None), (name, number, actual)
    for name, same in ranged_values(world).items():
        value = same[0].value
        masks = [bit.mask for bit in device.flags[value.flags].bits] if value.flags else []
        members = {member.value for member in device.enums[value.enum].members} if value.enum else set()
        for number in numbers_about(value, [*bounds_of_value(value), *((mask, mask) for mask in masks)]):
            if isinstance(world.type_of(value), EnumType) and number not in members:
                continue
            actual = is_true(prover, world.routine(name, "is_out_of_range"), number)
            assert actual == (state_name(device, value, number) == OUT_OF_RANGE), (name, number, actual)
    for name, same in quantities(world.layout).items():
        value = same[0].value
        for number in numbers_about(value, bounds_of_value(value)):
            status, (_, *marks) = prover.positional(world.routine(name, "from_counts"), number)
            state = "" if all(quantity.trigger for quantity in same) else state_name(device, value, number)
            assert status == ("out_of_range" if value.sentinel(number) is not None else "ok"), (name, number)
            assert any(marks) == (state == OUT_OF_RANGE), (name, number)


def bounds_of_value(value: Value) -> list[tuple[float, float]]:
    """The intervals that a value states: its range, and its special values."""
    return [*(value.ranges.intervals if value.ranges is not None else ()), *value.special_intervals]


def numbers_about(value: Value, intervals: Iterable[tuple[float, float]]) -> set[float]:
    """The bounds of intervals and what is next to them, as far as a value has them."""
    bounds = {bound for interval in intervals for bound in interval} | {0, 1}
    numbers = {bound + step for bound in bounds for step in (-1, 0, 1)}
    return {number for number in numbers if not is_count(value.encoding) or value.low <= number <= value.high}


def is_true(prover: Proof, function: str, number: float) -> bool:
    """What a function with one input returns."""
    variables = prover.machine.unit.functions[function.lower()].variables
    parameter = next(variable for role, variable, _, _ in variables if role == "VAR_INPUT")
    result = prover.machine.call(function, **{parameter: number})
    return bool(result[0] if isinstance(result, tuple) else result)


def compare_requests(prover: Proof, dice: random.Random, tries: int) -> None:
    """Compares the functions that build requests, on random values. Raises AssertionError."""
    layout = prover.world.layout
    reference = codec(layout)
    for link in layout.links.values():
        for message in framed_messages(link, "request"):
            for _ in range(tries):
                values = {**head_values(link, "request", dice), **drawn_values(layout, message.request, dice)}
                status, frame = prover.build(link, message, values)
                try:
                    expected = reference.links[link.name].encode("request", message.name, values)
                except CodecError as error:
                    judged(status, error, (message.name, values))
                    continue
                about = message.name, values, status, frame.hex(), expected.hex()
                assert (status, frame.hex()) == ("ok", expected.hex()), about


def compare_responses(prover: Proof, dice: random.Random, tries: int) -> set[str]:
    """Compares the functions that parse responses, on random and on damaged frames; returns the refusals.

    Raises AssertionError.
    """
    layout = prover.world.layout
    reference = codec(layout)
    refused = set()
    for link in layout.links.values():
        for message in framed_messages(link, "response"):
            for number in range(tries):
                values = {**head_values(link, "response", dice), **drawn_values(layout, message.response, dice)}
                try:
                    frame = reference.links[link.name].encode("response", message.name, values)
                except CodecError:
                    continue
                frame = damaged(frame, dice) if number % 2 else frame
                if len(frame) > prover.world.frame.high + 1:
                    continue
                status, parsed_tree = prover.parse(link, message, frame)
                try:
                    meaning = reference.links[link.name].decode(frame, "response", message.name)
                except CodecError as error:
                    judged(status, error, (message.name, frame.hex(), error))
                    refused.add(status)
                    continue
                wanted = "refused" if meaning.error else "ok" if all_finite(meaning.values) else "no_number"
                assert status == wanted, (message.name, frame.hex(), status)
                if status == "ok":
                    expected = without(message.response, meaning.values)
                    assert {name: parsed_tree[name] for name in expected} == expected, (message.name, frame.hex())
    return refused


def there_and_back(prover: Proof, data: RecordLayout, frame: bytes) -> None:
    """Unpacks process data in both forms, compares with the reference, and packs them again."""
    device = prover.world.layout.device
    try:
        expected: Any = without(data, decoded(data, frame, device))
        status = "ok" if all_finite(expected) else "no_number"
    except CodecError as error:
        expected, status = None, reason(error)
    for unit, name in (("bytes", "aBytes"), ("words", "aWords")):
        if len(frame) % 2 and unit == "words":
            continue
        array = words_in(frame, unit, device.byte_order)
        copy = prover.machine.fresh(prover.world.names.structs[data.name].lower())
        actual, _ = prover.run(prover.world.routine("unpack", data.name, unit), **{name: array, "stData": copy})
        assert actual == status, (data.name, frame.hex())
        if expected is None or status == "no_number":
            continue
        assert prover.struct_out(data, copy) == expected, (data.name, unit)
        packed(prover, data, unit, expected)


def all_finite(values: Any) -> bool:
    """Whether no float among some values is infinite or no number: controllers do not compute with those."""
    if isinstance(values, dict):
        return all(map(all_finite, values.values()))
    if isinstance(values, list):
        return all(map(all_finite, values))
    return not isinstance(values, float) or math.isfinite(values)


def packed(prover: Proof, data: RecordLayout, unit: str, values: dict[str, Any]) -> None:
    """Packs values and compares with the reference."""
    device = prover.world.layout.device
    name = {"bytes": "aBytes", "words": "aWords"}[unit]
    size = data.size or 0
    array = [0xAA] * size if unit == "bytes" else [0xAAAA] * (size // 2)
    inner_struct = prover.struct_in(data, values)
    actual, _ = prover.run(prover.world.routine("pack", data.name, unit), **{name: array, "stData": inner_struct})
    try:
        expected = encoded(data, values, device)
    except CodecError as error:
        judged(actual, error, (data.name, values))
        return
    assert (actual, array) == ("ok", words_in(expected, unit, device.byte_order)), (data.name, values)


def is_compared(record: RecordLayout) -> bool:
    """Whether a record can be compared: the functions do not test the ranges of values that have several types."""
    return not any(field.cases for field in record.fields)


def framed_messages(link: LinkLayout, direction: str) -> list[MessageLayout]:
    """The messages whose fields are called other than the parts before them: the reference takes both by name."""
    heads = {part.name for part in link.frame(direction).header}
    messages = link.carried(direction).values() if framed(link) else ()
    records = ((message, message.data(direction)) for message in messages)
    return [
        message
        for message, record in records
        if is_compared(record) and not heads & {field.name for field in record.fields}
    ]


def head_values(link: LinkLayout, direction: str, dice: random.Random) -> dict[str, int]:
    """Random values for the parts before the body that users give."""
    return {
        part.name: dice.choice([0, 1, 2, part.value.type.high, dice.randint(0, part.value.type.high)])
        for part in link.frame(direction).header
        if part.is_argument and part.value is not None
    }


def damaged(frame: bytes, dice: random.Random) -> bytes:
    """A frame with a byte that differs, or one byte fewer or more."""
    spoiled_frame = bytearray(frame)
    way = dice.randrange(4)
    if way == 0:
        return bytes(spoiled_frame[:-1])
    if way == 1 or not frame:
        return bytes([*spoiled_frame, dice.randrange(256)])
    spoiled_frame[dice.randrange(len(spoiled_frame))] ^= 1 << dice.randrange(8)
    return bytes(spoiled_frame)
