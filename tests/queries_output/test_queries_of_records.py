"""Every record and every message as a query: its columns, and what it refuses, are those of the reference."""

from __future__ import annotations

import os
import random

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.foundation.names import Name
from layouts import SPECS, TEST_SPECS, has_digits, layouts
from queries_output.engines import ENGINES, engine_of
from queries_output.expected import Columns, is_equal, record_columns
from random_devices.inputs import record_bytes, record_values
from random_devices.queries import to_encode

NEWEST = {name: versions[-1] for root in (SPECS, TEST_SPECS) for name, versions in layouts(root).items()}
DEVICES = {name: layout for name, layout in NEWEST.items() if not has_digits(layout)}
PAYLOADS = 12
"""The random payloads of each record."""
TELEGRAMS = int(os.environ.get("FIELDSPEC_TELEGRAMS", "200"))
"""The random telegrams; `make queries` compares a million."""
AT_ONCE = 20000
"""The telegrams of one query."""


def records(layout: DeviceLayout) -> dict[str, RecordLayout]:
    """The records and the data of messages by the names of their queries."""
    queries = {Name.of(record.name).snake(): record for record in layout.records.values()}
    for message in layout.messages.values():
        for direction in message.message.directions:
            queries[f"{Name.of(message.name).snake()}_{direction}"] = message.data(direction)
    return queries


def payloads_of_examples(layout: DeviceLayout) -> dict[str, list[bytes]]:
    """The data of the example frames that a codec accepts, by the name of the query."""
    reference = codec(layout)
    result: dict[str, list[bytes]] = {}
    for example in layout.device.examples.values():
        if example.refused or example.exception_response or not example.message:
            continue
        frame = reference.links[example.link].decode(example.frame, example.direction, example.message)
        assert frame.body is not None
        data = encoded(frame.body, to_encode(frame.body, frame.values), layout.device)
        result.setdefault(f"{Name.of(example.message).snake()}_{example.direction}", []).append(data)
    return result


def payloads(layout: DeviceLayout, record: RecordLayout, dice: random.Random, count: int) -> list[bytes]:
    """Payloads of random values where these can be encoded, and random bytes."""
    data = []
    for number in range(count):
        if number % 2:
            data.append(record_bytes(record, dice))
            continue
        try:
            data.append(encoded(record, record_values(layout, record, dice), layout.device))
        except CodecError:
            data.append(record_bytes(record, dice))
    return [b"", *data]


def expected(layout: DeviceLayout, record: RecordLayout, data: bytes) -> str | Columns:
    """The reason for which the reference refuses some data, or their columns."""
    try:
        return record_columns(layout.device, record, decoded(record, data, layout.device))
    except CodecError as error:
        return error.reason


def compare(layout: DeviceLayout, engine: str, name: str, record: RecordLayout, data: list[bytes]) -> int:
    """Compares a query with the reference; the number of payloads that both decode."""
    rows = engine_of(engine, layout).rows(name, {"payload": data})
    assert len(rows) == len(data)
    accepted = 0
    for payload, row in zip(data, rows, strict=True):
        wanted = expected(layout, record, payload)
        where = (layout.device.id, name, payload.hex(" "))
        if isinstance(wanted, str):
            assert row["refusal"] == wanted, where
            continue
        assert row["refusal"] is None, where
        accepted += 1
        for column, value in wanted.items():
            assert is_equal(value, row[column]), (*where, column, value, row[column])
        others = {
            key: value for key, value in row.items() if key not in wanted and key not in ("refusal", "payload", "place")
        }
        assert all(value in (None, []) for value in others.values()), (*where, others)
    return accepted


@pytest.mark.proof(10)
@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("device", DEVICES)
def test_a_query_has_the_columns_of_the_reference_and_refuses_what_it_refuses(device: str, engine: str) -> None:
    layout, dice = DEVICES[device], random.Random(device)
    examples = payloads_of_examples(layout)
    for name, record in records(layout).items():
        accepted = compare(layout, engine, name, record, examples.get(name, []))
        assert accepted == len(examples.get(name, []))
        compare(layout, engine, name, record, payloads(layout, record, dice, PAYLOADS))


@pytest.mark.parametrize("engine", ENGINES)
def test_random_telegrams_have_the_columns_of_the_reference(engine: str) -> None:
    layout, dice = DEVICES["hiwin-e"], random.Random(18)
    record = layout.messages["telegram_111"].response
    for start in range(0, TELEGRAMS, AT_ONCE):
        data = [dice.randbytes(24) for _ in range(min(AT_ONCE, TELEGRAMS - start))]
        assert compare(layout, engine, "telegram_111_response", record, data) == len(data)
