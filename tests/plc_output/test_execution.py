"""The generated functions for frames and telegrams are run, on every example of every device and on random values.

They agree with the reference codec: on bytes, on values, and on what is refused and why.
"""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from comparisons import compare_requests, compare_responses, compare_telegrams, there_and_back
from loaded import WAY_NAMES, WAYS, judged, proof_by
from proving import Proof, without

from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets.controllers.routines.wrapping import framed

pytestmark = pytest.mark.proof()

TRIES = 25


@pytest.fixture(params=WAYS, ids=WAY_NAMES, scope="module")
def prover(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """What is generated for each device."""
    return proof_by(request, tmp_path_factory)


@pytest.mark.proof(4)
def test_every_request_of_an_example_is_built_byte_for_byte(prover: Proof) -> None:
    layout = prover.world.layout
    reference = codec(layout)
    for example in layout.device.examples.values():
        link = layout.links[example.link]
        if not framed(link) or example.direction != "request" or example.refused:
            continue
        meaning = reference.links[link.name].decode(example.frame, "request", example.message)
        assert meaning.message is not None
        if meaning.message.name not in layout.messages:
            continue  # it is left out, with the reason
        values = {**meaning.head, **meaning.values}
        status, frame = prover.build(link, layout.messages[meaning.message.name], values)
        assert (status, frame.hex()) == ("ok", example.frame.hex()), example.id


@pytest.mark.proof(5)
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


@pytest.mark.proof(7)
def test_telegrams_agree_with_the_reference_on_random_bytes_and_values(prover: Proof) -> None:
    compare_telegrams(prover, random.Random(prover.world.layout.device.id), TRIES)


@pytest.mark.proof(7)
def test_messages_agree_with_the_reference_on_random_values(prover: Proof) -> None:
    compare_requests(prover, random.Random(prover.world.layout.device.id), TRIES)


@pytest.mark.proof(4)
def test_responses_agree_with_the_reference_on_random_and_on_damaged_frames(prover: Proof) -> None:
    layout = prover.world.layout
    refused = compare_responses(prover, random.Random(layout.device.id), 2 * TRIES)
    if any(framed(link) for link in layout.links.values()):
        assert refused
