"""Groups of registers, tables and parameters as queries, and the findings of audits, against the reference."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import pytest

from fieldspec.codec.explain.values import decode_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import Orders, RecordLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.records import decoded
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_text, is_truth
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import unit_word
from layouts import SPECS, TEST_SPECS, newest
from queries_output.engines import ENGINES, engine_of
from queries_output.expected import Columns, Exponent, is_equal, record_columns, value_columns

WORDS = ("tc100", "widget", "hostile", "meter", "wattmeter", "counter", "inverter")
PARAMETERS = ("hiwin-e", "widget", "mover", "esc11")
FIND = {"out_of_range", "unknown_value", "wrong_const"}


def layout_of(device: str) -> DeviceLayout:
    return newest(SPECS if (SPECS / device).exists() else TEST_SPECS, device)


def columns_of(
    layout: DeviceLayout, name: str, value: Value, data: bytes, order: str, swapped: bool, trigger: bool = False
) -> Columns:
    """The columns of a value in some bytes; null where a codec refuses them."""
    raw = value_construct(value, order, swapped).parse(data)
    if is_text(value.encoding):
        raw = None if any(byte > 0x7F for byte in raw) else raw.rstrip(b"\0").decode("ascii")
        return {name: raw}
    if is_truth(value.encoding) and not value.enum:
        return {name: bool(raw) if raw in (0, 1) else None}
    return dict(value_columns(layout.device, name, value, raw, trigger=trigger))


def group_rows(layout: DeviceLayout, group: Any, start: int, payload: bytes) -> Iterator[tuple[str, Any]]:
    """The columns of the registers that lie within a payload."""
    places = {register.name: register for register in layout.registers}
    for register in group.registers:
        own = places[register.name]
        for number in range(own.count):
            offset = 2 * (own.address + number * own.stride - start)
            if register.reserved or offset < 0 or offset + register.value.size > len(payload):
                continue
            suffix = f"_{number + register.index_from}" if own.count > 1 else ""
            data = payload[offset : offset + register.value.size]
            name = f"{Name.of(own.name).snake()}{suffix}"
            columns = columns_of(layout, name, register.answer, data, own.order, own.swapped, register.trigger)
            yield from scaled_columns(layout, name, register.answer, columns, payload, start).items()


def scaled_columns(
    layout: DeviceLayout, name: str, value: Value, columns: Columns, payload: bytes, start: int
) -> Columns:
    """The columns of a register, with its quantity where the exponent of its scale is in the payload, too."""
    exponent = layout.device.register(value.scale_by) if value.scale_by else None
    if exponent is None or exponent.value.ranges is None:
        return columns
    raw = columns.get(f"{name}_raw", columns.get(name))
    at = 2 * (exponent.address - start)
    data = payload[at : at + 2] if at >= 0 else b""
    power = int.from_bytes(data, "big", signed=True) if len(data) == 2 else None
    is_known = power in exponent.value.ranges and value.sentinel(raw) is None
    quantity = float(value.scaled_by(power or 0).in_unit(raw)) if is_known else None
    others = {key: column for key, column in columns.items() if key not in (name, f"{name}_raw")}
    return {f"{name}_{unit_word(value.quantity_unit)}": quantity, f"{name}_raw": raw, **others}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("device", WORDS)
def test_registers_within_a_payload_have_their_values_and_others_are_null(device: str, engine: str) -> None:
    layout, dice = layout_of(device), random.Random(device)
    names = {record.name for record in layout.records.values()}
    for group in layout.device.word_groups():
        addresses = [register.address for register in group.registers]
        starts = [dice.choice(addresses) - dice.choice((0, 0, 1, 3)) for _ in range(12)]
        payloads = [dice.randbytes(2 * dice.randint(0, 40)) for _ in starts]
        query = group.name if group.name not in (*names, "int") else f"{group.name}_registers"
        rows = engine_of(engine, layout).rows(query, {"start": starts, "payload": payloads})
        for start, payload, row in zip(starts, payloads, rows, strict=True):
            wanted = dict(group_rows(layout, group, start, payload))
            for column, value in row.items():
                # DuckDB gives a column of the source another name where a register has its name.
                if column not in ("place", "start", "payload", "start_1"):
                    assert is_equal(wanted.get(column), value), (column, start, payload.hex(), value)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_register_has_a_quantity_where_the_payload_has_the_exponent_of_its_scale(engine: str) -> None:
    cases = {
        "268EFFFF": 987.0,
        "268E000A": 9870e10,
        "D972FFF6": -9870e-10,
        "00070000": 7.0,
        "268E000B": None,
        "268E8000": None,
        "268E7FFF": None,
        "8000FFFF": None,
        "268E": None,
    }
    payloads = list(map(bytes.fromhex, cases))
    rows = engine_of(engine, layout_of("inverter")).rows("inverter", {"start": [40084] * 9, "payload": payloads})
    assert [row["power_w"] for row in rows] == list(cases.values())
    assert [row["power_raw"] for row in rows] == [int.from_bytes(data[:2], "big", signed=True) for data in payloads]
    assert {row["power_state"] for row in rows} == {None, "not_implemented"}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("device", ["tc100", "ck10", "widget", "inverter"])
def test_each_element_of_a_table_within_a_payload_is_a_row(device: str, engine: str) -> None:
    layout, dice = layout_of(device), random.Random(device)
    for name, table in layout.tables.items():
        own, size = table.table, table.record.size or 0
        starts = [own.base + dice.randrange(own.stride * 3) for _ in range(6)]
        payloads = [dice.randbytes(2 * dice.randint(0, 3 * own.stride)) for _ in starts]
        rows = element_rows(layout, engine, name, starts, payloads, list(own.indexes))
        count = 0
        for place, (start, payload) in enumerate(zip(starts, payloads, strict=True)):
            for index in own.indexes:
                offset = 2 * (own.address(index) - start)
                data = payload[offset : offset + size] if offset >= 0 else b""
                if len(data) < size:
                    assert (place, index) not in rows
                    continue
                count += 1
                row = rows[place, index]
                refusal, wanted = answer_of(layout, table.record, data, exponents_of(layout, payload, start))
                assert row["refusal"] == refusal
                assert all(is_equal(value, row[column]) for column, value in wanted.items())
        assert count == len(rows)


def exponents_of(layout: DeviceLayout, payload: bytes, start: int) -> dict[str, Exponent]:
    """The exponents of scales in a payload, None where it does not have them."""
    names = {field.value.scale_by for table in layout.tables.values() for field in table.record.fields if field.value}
    registers = [register for register in layout.device.registers() if register.name in names]
    places = {register.name: 2 * (register.address - start) for register in registers}
    words = {name: payload[at : at + 2] if at >= 0 else b"" for name, at in places.items()}
    return {
        register.name: (
            register.value,
            int.from_bytes(words[register.name], "big", signed=True) if len(words[register.name]) == 2 else None,
        )
        for register in registers
    }


def answer_of(
    layout: DeviceLayout, record: RecordLayout, data: bytes, exponents: dict[str, Exponent]
) -> tuple[str | None, Columns]:
    """The reason for which the reference refuses some data, and the columns of data that it decodes."""
    try:
        return None, record_columns(layout.device, record, decoded(record, data, layout.device), exponents)
    except CodecError as error:
        return error.reason, {}


def element_rows(
    layout: DeviceLayout, engine: str, name: str, starts: list[int], payloads: list[bytes], indexes: list[int]
) -> dict[tuple[int, int], dict[str, Any]]:
    """The rows of a table by the place of the payload and the number of the element."""
    runner = engine_of(engine, layout)
    if engine == "duckdb":
        rows = runner.rows(name, {"start": starts, "payload": payloads})
        return {(row["place"], row["element"]): row for row in rows}
    arguments = {
        "start": [start for start in starts for _ in indexes],
        "payload": [payload for payload in payloads for _ in indexes],
        "element": indexes * len(starts),
    }
    rows = runner.rows(name, arguments)
    known = [row for row in rows if any(row[key] is not None for key in row if key not in (*arguments, "place"))]
    return {(row["place"] // len(indexes), row["element"]): row for row in known}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("device", PARAMETERS)
def test_a_parameter_has_the_value_of_its_number(device: str, engine: str) -> None:
    layout, dice = layout_of(device), random.Random(device)
    orders = Orders(layout.device.byte_order, layout.device.word_order)
    for parameters in layout.device.parameters.values():
        rows, wanted = [], []
        for parameter in parameters.parameters:
            if parameter.reserved or not parameter.name:
                continue
            inner = dice.choice([None, *(sub for sub in parameter.subindices if not sub.reserved)])
            value = (inner or parameter).value
            answer = value.as_answer(parameter.trigger)
            data = dice.randbytes(value.size)
            covered = [low for sub in parameter.subindices for low, _ in sub.indices.intervals]
            subindex = inner.indices.low if inner else max(covered, default=0) + 1000
            name = Name.of(parameter.name).snake()
            if inner is not None:
                name = f"{name}_{Name.of(inner.name).snake() or inner.indices.low}"
            rows.append((parameters.base + parameter.number, subindex, data))
            wanted.append(columns_of(layout, name, answer, data, *orders.of(value), parameter.trigger))
        columns = zip(*rows, strict=True)
        arguments = dict(zip(("number", "subindex", "payload"), map(list, columns), strict=True))
        for expected, row in zip(wanted, engine_of(engine, layout).rows(parameters.name, arguments), strict=True):
            for column, actual in row.items():
                if column not in arguments and column != "place":
                    assert is_equal(expected.get(column), actual), (column, row["number"], expected, actual)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("device", ["tc100", "widget", "hostile"])
def test_findings_are_those_of_the_explanation_and_reserved_bits(device: str, engine: str) -> None:
    layout, dice = layout_of(device), random.Random(device)
    names = {record.name for record in layout.records.values()}
    places = {register.name: register for register in layout.registers}
    for group in layout.device.word_groups():
        name = f"{group.name}_findings"
        if group.name in (*names, "int"):
            name = f"{group.name}_registers_findings"
        starts = [dice.choice([register.address for register in group.registers]) for _ in range(8)]
        payloads = [dice.randbytes(2 * dice.randint(1, 30)) for _ in starts]
        rows = engine_of(engine, layout).rows(name, {"start": starts, "payload": payloads})
        reported = {(row["place"], row["field"], row["reason"]) for row in rows}
        wanted = set()
        for place, (start, payload) in enumerate(zip(starts, payloads, strict=True)):
            for register in group.registers:
                own = places[register.name]
                offset = 2 * (own.address - start)
                if own.count > 1 or offset < 0 or offset + register.value.size > len(payload) or register.reserved:
                    continue
                data = payload[offset : offset + register.value.size]
                value = replace(register.answer)
                reason = decode_value(layout.device, value, data, own.order, own.swapped).reason
                if reason:
                    wanted.add((place, Name.of(own.name).snake(), reason))
        single = {Name.of(own.name).snake() for own in layout.registers if own.count == 1 and not own.register.reserved}
        assert wanted == {row for row in reported if row[2] in FIND and row[1] in single}
        assert all(row["raw"] is not None for row in rows if row["reason"] != "unknown_value")
