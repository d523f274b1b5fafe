"""Values outside of what is stated of them: reading returns what came, and says so where it says special values."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.quantities import state_name
from python_package import module_apart
from random_devices.agreement import layouts_of

CASE = Path(__file__).parent / "random_devices" / "cases" / "out_of_range.yaml"

USUAL = bytes.fromhex(
    "01 0000 00 01 00 00 0000000000000000 000001 00000000 0000000000000000 10 00 00 0005 0005 01 0001"
)
"""A record whose values are all as stated."""

REALS = ((0.0, None), (300.0, None), (-0.5, "out_of_range"), (float("inf"), "out_of_range"))
FIELDS: dict[str, tuple[tuple[float, str | None], ...]] = {
    "plain": ((0, "out_of_range"), (1, None), (10, None), (11, "out_of_range"), (255, "out_of_range")),
    "scaled": ((-32768, "unknown"), (100, None), (101, "out_of_range"), (205, "high"), (211, "out_of_range")),
    "gear": ((0, None), (5, None), (6, "out_of_range")),
    "lamps": ((0x0A, None), (0x0C, "out_of_range"), (0x0F, "out_of_range"), (0xF0, None)),
    "marks": ((0xFE, None), (0xFF, "off")),
    "wide": ((1 << 63, None), ((1 << 63) + 1, "out_of_range")),
    "three": ((2, None), (3, "out_of_range"), (0x10000, None), (0x20001, "out_of_range")),
    "real": (*REALS, (9999.0, "far"), (float("nan"), "not_measured")),
    "bare": ((1.0, None), (1.5, "out_of_range"), (float("nan"), "out_of_range")),
    "digits": ((10, None), (9, "out_of_range"), (21, "out_of_range")),
}
"""Numbers of the fields of the record, each with its state by the rule that the manual of the language states."""
ROWS = [(name, number, state) for name, rows in FIELDS.items() for number, state in rows]

REGISTERS: dict[str, tuple[tuple[float, str | None], ...]] = {
    "speed": ((0, "out_of_range"), (1, None), (11, "out_of_range")),
    "limit": ((1, None), (10, None), (11, "out_of_range")),
    "position": ((-5, None), (6, "out_of_range"), (99, "lost")),
    "start": ((1, None), (0, None), (7, None)),
    "selected": ((5, None), (6, "out_of_range")),
    "begin": ((1, None), (7, None)),
    "distance": (*REALS, (float("nan"), "not_measured")),
}
"""The same of registers. What is read of a trigger is nothing that was written, so that nothing is stated of it."""


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return layouts_of(CASE.read_text(encoding="utf-8"))[0]


@pytest.fixture(scope="module")
def module(layout: DeviceLayout) -> Any:
    return module_apart(layout, "out_of_range")


def image(layout: DeviceLayout, name: str, number: float) -> bytes:
    """The bytes of the usual record with another number in one field."""
    field = next(field for field in layout.messages["set"].data("request").fields if field.name == name)
    assert field.offset is not None
    assert field.size is not None
    if isinstance(number, float):
        data = struct.pack(">f" if field.size == 4 else ">d", number)
    elif name == "digits":
        data = bytes.fromhex(f"{number:02d}")
    else:
        data = number.to_bytes(field.size, "big", signed=number < 0)
    return USUAL[: field.offset] + data + USUAL[field.offset + field.size :]


@pytest.mark.parametrize(("name", "number", "state"), ROWS)
def test_the_reference_has_the_state_that_the_rule_gives(
    layout: DeviceLayout, name: str, number: float, state: str | None
) -> None:
    field = next(field for field in layout.messages["set"].data("request").fields if field.name == name)
    assert field.value is not None
    assert state_name(layout.device, field.value, number) == (state or "")


@pytest.mark.parametrize(("name", "number", "state"), ROWS)
def test_a_record_returns_what_came_with_its_state(
    layout: DeviceLayout, module: Any, name: str, number: float, state: str | None
) -> None:
    record = module.SetRequest.decode(image(layout, name, number))
    value = getattr(record, name)
    assert getattr(value, "raw", value) == pytest.approx(number, nan_ok=True)
    assert getattr(record, f"{name}_state") == state


def test_a_value_out_of_range_has_a_quantity(layout: DeviceLayout, module: Any) -> None:
    record = module.SetRequest.decode(image(layout, "scaled", 1010))
    assert (record.scaled, record.scaled_mm, record.scaled_state) == (1010, 101.0, "out_of_range")


def test_each_element_and_each_inner_record_has_its_own_state(module: Any) -> None:
    changed = bytearray(USUAL)
    changed[31:37] = bytes.fromhex("04 FF 0005 0009")
    record = module.SetRequest.decode(bytes(changed))
    assert (record.masses_state, record.inner.amount_state) == ([None, "out_of_range"], "out_of_range")
    assert not hasattr(record.inner, "rest_state")  # its range is that of its type


@pytest.mark.parametrize(
    ("end", "state"), [("01 000A", None), ("01 000B", "out_of_range"), ("02 000B", None), ("02 FFFF", "none")]
)
def test_a_field_of_several_types_has_the_state_of_the_one_that_came(module: Any, end: str, state: str | None) -> None:
    assert module.SetRequest.decode(USUAL[:-3] + bytes.fromhex(end)).content_state == state


@pytest.mark.parametrize(
    ("name", "number", "state"), [(name, *row) for name, rows in REGISTERS.items() for row in rows]
)
def test_a_register_has_the_state_of_what_is_read(module: Any, name: str, number: float, state: str | None) -> None:
    assert getattr(module, name.upper()).state_of(number) == state
