"""Every request of the manuals' examples gets the answer of the examples from a device in the state of that answer."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import codec
from fieldspec.codec.reference.frames import Decoded
from fieldspec.language.model.texts import Example
from fieldspec.tools.simulator import parameters
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from simulators import parts_of

DEVICES = ("tc100", "ck10", "esc11", "hiwin-e")


def answered(layout: DeviceLayout) -> list[tuple[Example, Example]]:
    """The examples of requests, each with the example that answers it."""
    examples = layout.device.examples
    return [(examples[example.reply_to], example) for example in examples.values() if example.reply_to]


PAIRS = [
    pytest.param(device, request, response, id=f"{device}-{response.id}")
    for device in DEVICES
    for request, response in answered(parts_of(device)[0])
]


def set_state(engine: Engine, asked: Decoded, response: Decoded) -> None:
    """Puts a device into the state that an answer shows."""
    memory = engine.memory
    engine._shows = []
    for name, number in response.head.items():
        memory.fields[f"links/{response.link}/response/{name}"] = number
    if response.error or response.message is None or asked.message is None:
        return
    access = engine.layout.device.register_access(response.message.message)
    if access is not None and access.operation == "read":
        for address, word in enumerate(response.values[access.values], asked.values[access.start]):
            memory.words[engine.layout.device.space_name(access.space), address] = word
        return
    target = parameters.target_of(engine, asked.message.request, asked.values)
    value_field = parameters.part_of(response.message.response, "value")
    if target is not None and value_field is not None:
        content = response.values[value_field.name]
        raws = content if isinstance(content, list) else [content]
        for index, raw in zip(target.elements, raws, strict=True):
            memory.elements[target.set_name, target.number, index] = raw
        if response.message.response.selector is not None:
            memory.formats[target.set_name, target.number] = response.values[response.message.response.selector.name]
        return
    every = parameters.part_of(response.message.response, "values")
    if every is not None and every.value is not None and every.value.parameter is not None:
        rows = parameters.numbers_of(engine.layout.device.sets(every.value.parameter.set))
        for (set_name, number, _), raw in zip(rows, response.values[every.name], strict=True):
            memory.elements[set_name, number, 0] = raw
        return
    for field in response.message.response.fields:
        content: Any = response.values[field.name]
        if field.record is not None:
            collection = next(
                part["from"] for part in engine.behaviour.of_kind("answer") if part.subject == field.field.place.path
            )
            memory.lists[collection] = content if isinstance(content, list) else [content]
        elif isinstance(content, str):
            memory.fields[field.field.place.path] = content.encode()
        else:
            memory.fields[field.field.place.path] = int(content)


STATES: dict[str, dict[str, str]] = {"write-mastership-while-excited-response": {"drive": "operation"}}
"""The states of machines in which an answer is given."""

FORCED = {"rtu-identity-refused": "device_failure"}
"""Answers that show a failure within the device."""


@pytest.mark.proof(45)
@pytest.mark.parametrize(("device", "request_example", "response_example"), PAIRS)
def test_a_request_gets_its_answer(device: str, request_example: Example, response_example: Example) -> None:
    layout, behaviour = parts_of(device)
    engine = Engine(layout, behaviour)
    frames = codec(layout).links[request_example.link]
    response = frames.decode(response_example.frame, "response", response_example.message)
    addressed = layout.links[request_example.link].response.role("unit_address")
    server = Server(engine, response.head[addressed.name] if addressed is not None else 1)
    try:
        asked = frames.decode(request_example.frame, "request", request_example.message)
    except ValueError:
        asked = response
    if asked is not response:
        set_state(engine, asked, response)
    if device == "ck10" and not response.error:
        engine.states["servo"] = "energized"
    engine.states |= STATES.get(response_example.id, {})
    answer = server.answer(request_example.link, request_example.frame, "", FORCED.get(response_example.id, ""))
    assert answer.frame.hex(" ") == response_example.frame.hex(" "), answer.text
