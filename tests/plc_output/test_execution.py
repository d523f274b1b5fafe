"""The generated functions for frames and telegrams are run, on every example of every device and on random values.

They agree with the reference codec: on bytes, on values, and on what is refused and why.
"""

from __future__ import annotations

import math
import random
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from drawing import drawn_bytes, drawn_values
from loaded import WAY_NAMES, WAYS, judged, proof_by, reason, words_in
from proving import Proof, without

from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.plc.routines.messages import telegrams
from fieldspec.plc.routines.wrapping import framed
from fieldspec.reference import CodecError, codec
from fieldspec.reference.records import decoded, encoded

TRIES = 25


@pytest.fixture(params=WAYS, ids=WAY_NAMES, scope="module")
def prover(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """What is generated for each device."""
    return proof_by(request, tmp_path_factory)


def test_every_request_of_an_example_is_built_byte_for_byte(prover: Proof) -> None:
    layout = prover.world.layout
    reference = codec(layout)
    for example in layout.device.examples.values():
        link = layout.links[example.link]
        if not framed(link) or example.direction != "request" or example.refused:
            continue
        meaning = reference.links[link.name].decode(example.frame, "request", example.message)
        assert meaning.message is not None
        values = {**meaning.head, **meaning.values}
        status, frame = prover.build(link, layout.messages[meaning.message.name], values)
        assert (status, frame.hex()) == ("ok", example.frame.hex()), example.id


def test_every_response_of_an_example_is_parsed_to_its_values(prover: Proof) -> None:
    layout = prover.world.layout
    reference = codec(layout)
    for example in layout.device.examples.values():
        link = layout.links[example.link]
        if not framed(link) or example.direction != "response":
            continue
        for message in link.carried("response").values():
            try:
                meaning = reference.links[link.name].decode(example.frame, "response", message.name)
            except CodecError as error:
                status, _ = prover.parse(link, message, example.frame)
                judged(status, error, (example.id, message.name))
                continue
            status, values = prover.parse(link, message, example.frame)
            if meaning.message is not message:
                assert status == "unknown_code", (example.id, message.name)
            elif meaning.error:
                assert status == "refused", example.id
                assert values == without(layout.records[link.link.exception_response.record], meaning.values), (
                    example.id
                )
            else:
                heads = {part.name for part in link.response.header}
                parts = {name: part for name, part in meaning.head.items() if name in heads & set(values)}
                assert status == "ok", (example.id, status)
                assert values == {**parts, **without(message.response, meaning.values)}, example.id


def test_every_telegram_of_an_example_is_unpacked_and_packed_again(prover: Proof) -> None:
    layout = prover.world.layout
    for example in layout.device.examples.values():
        message = layout.messages.get(example.message)
        if message is None or framed(layout.links[example.link]):
            continue
        there_and_back(prover, message.data(example.direction), example.frame)


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


def test_telegrams_agree_with_the_reference_on_random_bytes_and_values(prover: Proof) -> None:
    dice = random.Random(prover.world.layout.device.id)
    for message in telegrams(prover.world.layout):
        for data in (message.request, message.response):
            for _ in range(TRIES if data.size else 0):
                there_and_back(prover, data, drawn_bytes(data, dice))
                values = drawn_values(prover.world.layout, data, dice)
                for unit in ("bytes", "words") if data.size and data.size % 2 == 0 else ("bytes",):
                    packed(prover, data, unit, values)


def test_messages_agree_with_the_reference_on_random_values(prover: Proof) -> None:
    layout = prover.world.layout
    dice, reference = random.Random(layout.device.id), codec(layout)
    for link in layout.links.values():
        for message in framed_messages(link, "request"):
            for _ in range(TRIES):
                values = {**head_values(link, "request", dice), **drawn_values(layout, message.request, dice)}
                status, frame = prover.build(link, message, values)
                try:
                    expected = reference.links[link.name].encode("request", message.name, values)
                except CodecError as error:
                    judged(status, error, (message.name, values))
                    continue
                assert (status, frame.hex()) == ("ok", expected.hex()), (message.name, values)


def framed_messages(link: LinkLayout, direction: str) -> list[MessageLayout]:
    """The messages whose fields are called other than the parts before them: the reference takes both by name."""
    heads = {part.name for part in link.frame(direction).header}
    messages = link.carried(direction).values() if framed(link) else ()
    return [message for message in messages if not heads & {field.name for field in message.data(direction).fields}]


def head_values(link: LinkLayout, direction: str, dice: random.Random) -> dict[str, int]:
    """Random values for the parts before the body that users give."""
    return {
        part.name: dice.choice([0, 1, 2, part.value.type.high, dice.randint(0, part.value.type.high)])
        for part in link.frame(direction).header
        if part.is_argument and part.value is not None
    }


def test_responses_agree_with_the_reference_on_random_and_on_damaged_frames(prover: Proof) -> None:
    layout = prover.world.layout
    dice, reference = random.Random(layout.device.id), codec(layout)
    refused = set()
    for link in layout.links.values():
        for message in framed_messages(link, "response"):
            for number in range(2 * TRIES):
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
                assert status == ("refused" if meaning.error else "ok"), (message.name, frame.hex())
                if not meaning.error:
                    expected = without(message.response, meaning.values)
                    assert {name: parsed_tree[name] for name in expected} == expected, (message.name, frame.hex())
    if any(framed(link) for link in layout.links.values()):
        assert refused


def damaged(frame: bytes, dice: random.Random) -> bytes:
    """A frame with a byte that differs, or one byte fewer or more."""
    spoiled_frame = bytearray(frame)
    way = dice.randrange(4)
    if way == 0:
        return bytes(spoiled_frame[:-1])
    if way == 1:
        return bytes([*spoiled_frame, dice.randrange(256)])
    spoiled_frame[dice.randrange(len(spoiled_frame))] ^= 1 << dice.randrange(8)
    return bytes(spoiled_frame)
