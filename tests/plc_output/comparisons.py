"""Generated functions compared with the reference codec on random values and random and damaged bytes."""

from __future__ import annotations

import math
import random
from typing import Any

from drawing import drawn_bytes, drawn_values
from loaded import judged, reason, words_in
from proving import Proof, without

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.language.model.encoding import is_count
from fieldspec.targets.controllers.routines.absent import absent_values
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.wrapping import framed


def compare_telegrams(prover: Proof, dice: random.Random, tries: int) -> None:
    """Compares the functions for process data, on random bytes and values. Raises AssertionError."""
    for message in telegrams(prover.world.layout):
        for data in (message.request, message.response):
            for _ in range(tries if data.size else 0):
                there_and_back(prover, data, drawn_bytes(data, dice))
                values = drawn_values(prover.world.layout, data, dice)
                for unit in ("bytes", "words") if data.size and data.size % 2 == 0 else ("bytes",):
                    packed(prover, data, unit, values)


def compare_absent(prover: Proof) -> None:
    """Compares what tells states from quantities, on each sentinel and what is next to it. Raises AssertionError."""
    for name, same in absent_values(prover.world.layout).items():
        value = same[0].value
        function = prover.world.routine(name, "is_absent")
        parameter = next(
            variable
            for role, variable, _, _ in prover.machine.unit.functions[function.lower()].variables
            if role == "VAR_INPUT"
        )
        for number in {sentinel.value + step for sentinel in value.sentinels for step in (-1, 0, 1)} | {0, 1}:
            if is_count(value.encoding) and not value.type.low <= number <= value.type.high:
                continue
            result = prover.machine.call(function, **{parameter: number})
            actual = result[0] if isinstance(result, tuple) else result
            assert actual == (value.sentinel(number) is not None), (name, number, actual)


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
