"""Clients take no answer that repeats another request: under another name, of another number of words or value."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.frames import codec
from fieldspec.command.pipeline import layouts, load
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.tools.live.client import Client, NoAnswerError, Timing
from python_package import write
from test_client_parts import Line

SPEC = """
device:
  id: writer
  name: Writer
  vendor: Nobody
  manual: {title: The writer of nothing, file: writer.txt, sha256: "%s", lines: 99}
links:
  - name: line
    byte_order: big
    source: 1 L1
    request: &line
      - {name: station, role: unit_address, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
    response: *line
messages:
  - name: write
    code: 0x10
    source: 2 L1
    request:
      - {name: address, type: u16}
      - {name: word_count, type: u16, measures: {items: values}}
      - {name: values, type: u16, repeat: 1..9}
    response:
      - {name: address, type: u16, same_as: address}
      - {name: word_count, type: u16, same_as: word_count}
    accesses: [{operation: write, start: address, count: word_count, values: values}]
  - name: write_one
    code: 0x06
    source: 2 L2
    request: [{name: address, type: u16}, {name: value, type: u16}]
    response: [{name: at, type: u16, same_as: address}, {name: kept, type: u16, same_as: value}]
    accesses: [{operation: write, start: address, values: value}]
  - name: move
    code: 0x20
    source: 2 L3
    request: [{name: place, type: i16}]
    response: [{name: goal, type: i16, same_as: place}]
registers:
  - group: values
    title: Values
    section: "3"
    source: L3
    rows:
      - {at: 0, name: speed, type: u16, checked: {words: 1}, access: rw, source: L4}
"""
EXCHANGES: dict[str, tuple[dict[str, Any], dict[str, Any], dict[str, int]]] = {
    "write": ({"address": 5, "values": [7, 8]}, {"address": 5, "word_count": 2}, {"address": 6, "word_count": 1}),
    "write_one": ({"address": 5, "value": 7}, {"at": 5, "kept": 7}, {"at": 6, "kept": 8}),
    "move": ({"place": -3}, {"goal": -3}, {"goal": 3}),
}
"""What is asked, what the right answer to it has, and other numbers for each field of the answer."""
WRONG = [(message, field) for message, (_, _, wrong) in EXCHANGES.items() for field in wrong]


@pytest.fixture(scope="module")
def writer() -> DeviceLayout:
    """The device."""
    return layouts(load({"writer/device.yaml": (SPEC % ("1" * 64)).encode()}).devices["writer"])[0]


@pytest.fixture(scope="module")
def module(writer: DeviceLayout, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """Its package."""
    folder = tmp_path_factory.mktemp("writer")
    outputs = shared() | files([writer])
    write(folder, {path.replace(PACKAGE, "devices_of_writer", 1): text for path, text in outputs.items()})
    sys.path.insert(0, str(folder))
    yield importlib.import_module("devices_of_writer.writer")
    sys.path.remove(str(folder))


def asked(kind: str, writer: DeviceLayout, module: Any, message: str, answer: dict[str, Any]) -> bool:
    """Whether a client takes an answer to a message."""
    frame = codec(writer).links["line"].encode("response", message, {"station": 1, **answer})
    values, line = EXCHANGES[message][0], Line(frame.hex())
    if kind == "live":
        try:
            Client(writer, "line", line, 1, Timing(0.001, 0, 0)).ask(message, values)
        except NoAnswerError:
            return False
        return True
    client = importlib.import_module("devices_of_writer.writer.client")
    errors = importlib.import_module("devices_of_writer.errors")
    request = getattr(module, "".join(word.title() for word in message.split("_")) + "Request")(**values)
    try:
        client.Client(line, unit_address=1, retries=0, timeout=0.001).ask(request)
    except errors.NoAnswerError:
        return False
    return True


@pytest.mark.parametrize("message", EXCHANGES)
@pytest.mark.parametrize("kind", ["live", "generated"])
def test_a_client_takes_the_right_answer(kind: str, message: str, writer: DeviceLayout, module: Any) -> None:
    assert asked(kind, writer, module, message, EXCHANGES[message][1])


@pytest.mark.parametrize(("message", "field"), WRONG)
@pytest.mark.parametrize("kind", ["live", "generated"])
def test_a_client_takes_no_answer_to_another_request(
    kind: str, message: str, field: str, writer: DeviceLayout, module: Any
) -> None:
    _, right, wrong = EXCHANGES[message]
    assert not asked(kind, writer, module, message, {**right, field: wrong[field]})
