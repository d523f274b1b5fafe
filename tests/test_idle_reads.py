"""An idle device answers every block of registers that one request may read, and each of the values is decoded."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.audit.poll_blocks import PollBlock, polling_of
from fieldspec.checks.numbers import Legal
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RegisterLayout
from fieldspec.model.value import Kind, Value
from fieldspec.reference.records import decoded_value, value_construct
from layouts import SPECS, newest
from python_package import module_of

BLOCKS = [
    pytest.param(newest(SPECS, name), block, id=f"{name}-{block.start:04X}")
    for name in ("ck10", "tc100")
    for block in polling_of(newest(SPECS, name)).blocks
    if any(block.start <= register.address < block.start + block.words for register in newest(SPECS, name).registers)
]


def resting(layout: DeviceLayout, register: RegisterLayout) -> Any:
    """The value of an idle register: 0 if writing it starts something, else its initial or lowest legal value."""
    value = register.register.value
    if value.type.kind in (Kind.TEXT, Kind.BYTES):
        return bytes(value.size)
    if register.register.trigger or value.type.kind is Kind.FLOAT:
        return 0
    if value.const is not None:
        return value.const
    return value.default if isinstance(value.default, int) else _least(layout, value)


def _least(layout: DeviceLayout, value: Value) -> int:
    enum = layout.device.enums.get(value.enum)
    members = [member.value for member in enum.members] if enum is not None else []
    bounds = [low for low, _ in value.ranges.intervals] if value.ranges is not None else []
    legal = Legal(layout.device)
    return next(number for number in (0, *sorted(members), *sorted(bounds)) if not legal.objection(value, number))


def within(layout: DeviceLayout, block: PollBlock) -> list[tuple[RegisterLayout, bytes]]:
    """The registers that begin in a block, element by element, with the bytes of their values."""
    registers = []
    for register in layout.registers:
        for number in range(register.count):
            address = register.address + number * register.stride
            if block.start <= address and address + register.words <= block.start + block.words:
                whole = value_construct(register.register.value, register.order, register.swapped)
                data = whole.build(resting(layout, register))
                registers.append((register, data.ljust(2 * register.words, b"\0")))
    return registers


@pytest.mark.parametrize(("layout", "block"), BLOCKS)
def test_every_register_of_an_idle_device_is_decoded(layout: DeviceLayout, block: PollBlock) -> None:
    module = module_of(layout)
    constants = {register.name.partition("[")[0]: register for register in module.REGISTERS}
    answered = within(layout, block)
    assert answered
    for placed, data in answered:
        answer = placed.register.answer
        raw = value_construct(answer, placed.order, placed.swapped).parse(data[: answer.size])
        wanted = decoded_value(placed.name, answer, raw, layout.device, None)
        register = constants[placed.name] if placed.count == 1 else next(iter(constants[placed.name]))
        value = register.decode(data)
        assert getattr(value, "raw", value) == wanted, placed.name


def test_registers_that_start_something_are_among_those_read() -> None:
    started = [register.name for param in BLOCKS for register, _ in within(*param.values) if register.register.trigger]  # type: ignore[arg-type]
    assert {"start_move", "start_homing", "stop", "run_point_table", "save_all_parameters"} <= set(started)
