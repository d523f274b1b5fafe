"""Programs of fields, judged by the reference codec: values, reasons of refusals, and which bytes gave what."""

from __future__ import annotations

import random
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.program.interpreter import Place, Row, run
from fieldspec.codec.program.lowering import field_program
from fieldspec.codec.reference import records as reference
from layouts import SPECS, TEST_SPECS, layouts, newest
from random_devices.inputs import record_values

NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]
ROUNDS = 6
"""Inputs of each record: over all devices some 2,500."""


def traced(layout: DeviceLayout, record: RecordLayout, data: bytes) -> tuple[dict[str, Any], list[Row]]:
    """The values that the programs of all fields of a record give, and the rows."""
    rows: list[Row] = []
    program = tuple(field_program(layout.device, record, field) for field in record.fields)
    return run(program, Place(data, 0, len(data)), rows, {}), rows


def is_fixed(record: RecordLayout) -> bool:
    """Whether nothing in a record varies in size, nor in type."""
    inner = [field.record for field in record.fields if field.record is not None]
    return record.size is not None and record.selector is None and not record.spans and all(map(is_fixed, inner))


def records(layout: DeviceLayout) -> list[RecordLayout]:
    """The records of a device that have one size."""
    bodies = [body for message in layout.messages.values() for body in message.bodies]
    return [record for record in (*layout.records.values(), *bodies) if is_fixed(record)]


def judged_bytes(layout: DeviceLayout, record: RecordLayout, dice: random.Random) -> bytes:
    """Bytes of a record that are right, or of which one is another, or any."""
    try:
        data = reference.encoded(record, record_values(layout, record, dice), layout.device)
    except reference.CodecError:
        data = dice.randbytes(record.size or 0)
    if not data or dice.random() < 0.5:
        return data
    place = dice.randrange(len(data))
    return data[:place] + dice.randbytes(1) + data[place + 1 :]


def without_nans(content: Any) -> Any:
    """The same content with texts for floating-point numbers, so that a NaN equals itself."""
    match content:
        case dict():
            return {name: without_nans(own) for name, own in content.items()}
        case list():
            return [without_nans(own) for own in content]
        case float():
            return float.__repr__(content)
        case _:
            return content


def reference_answer(layout: DeviceLayout, record: RecordLayout, data: bytes) -> tuple[Any, tuple[str, int] | None]:
    """The values that the reference gives; or the reason of its refusal, and the byte."""
    try:
        return without_nans(reference.decoded(record, data, layout.device)), None
    except reference.CodecError as error:
        return None, (error.reason, error.offset or 0)


def first_refusal(rows: list[Row]) -> tuple[str, int] | None:
    """The reason and the byte of what is refused first; what is remarked alone is not refused."""
    refused = [row for row in rows if row.failed is not None and row.failed.reason != "out_of_range"]
    return (refused[0].failed.reason, refused[0].offset) if refused and refused[0].failed is not None else None


@pytest.mark.parametrize("layout", NEWEST, ids=[layout.device.id for layout in NEWEST])
def test_programs_give_what_the_reference_gives_and_refuse_what_it_refuses(layout: DeviceLayout) -> None:
    dice = random.Random(layout.device.id)
    for record in records(layout):
        for _ in range(ROUNDS):
            data = judged_bytes(layout, record, dice)
            values, rows = traced(layout, record, data)
            right, refusal = reference_answer(layout, record, data)
            # What measures other fields is judged where the places of all are known.
            if refusal is None or refusal[0] != "wrong_measure":
                read_values = without_nans(values) if refusal is None else None
                assert (read_values, first_refusal(rows)) == (right, refusal), (record.name, data.hex())


def test_a_trace_goes_on_behind_what_is_refused_and_says_which_bytes_gave_what() -> None:
    layout = newest(TEST_SPECS, "compass")
    _, rows = traced(layout, layout.messages["measure"].request, bytes.fromhex("05 00 60"))
    assert [(row.path, row.offset, row.raw.hex(), row.content, row.failed and row.failed.reason) for row in rows] == [
        ("turn", 0, "05", 5, "unknown_value"),
        ("speed", 1, "0060", 512.0, "out_of_range"),
    ]


def test_the_elements_of_lists_have_paths_and_bytes_of_their_own() -> None:
    layout = newest(TEST_SPECS, "widget")
    record = layout.records["nest"]
    corners = next(field for field in record.fields if field.name == "corners")
    assert corners.record is not None
    names = [field.name for field in corners.record.fields]
    _, rows = traced(layout, record, bytes(record.size or 0))
    own = [(row.path, row.offset) for row in rows if row.path.startswith("corners")]
    assert [path for path, _ in own] == [f"corners[{index}].{name}" for index in (0, 1) for name in names]
    assert [offset for path, offset in own if path.endswith(f".{names[0]}")] == [corners.offset, corners.offset + 4]
