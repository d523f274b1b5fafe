"""A device at rest answers every block of registers that one request may read, and each value of it is decoded."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.audit.poll_blocks import PollBlock, polling_of
from fieldspec.checks.numbers import Legal
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RegisterLayout
from fieldspec.model.value import Kind, Value
from fieldspec.reference.records import decoded_value, value_construct
from laid_out import SPECS, newest
from python_package import module_of

BLOCKS = [
    pytest.param(newest(SPECS, name), block, id=f"{name}-{block.start:04X}")
    for name in ("ck10", "tc100")
    for block in polling_of(newest(SPECS, name)).blocks
    if any(block.start <= laid.address < block.start + block.words for laid in newest(SPECS, name).registers)
]


def resting(layout: DeviceLayout, laid: RegisterLayout) -> Any:
    """What a register answers at rest: 0 where writing starts something, else its initial value, or the least legal."""
    value = laid.register.value
    if value.type.kind in (Kind.TEXT, Kind.BYTES):
        return bytes(value.size)
    if laid.register.trigger or value.type.kind is Kind.FLOAT:
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
    """The registers that begin in a block, each element of several, with what they answer."""
    found = []
    for laid in layout.registers:
        for number in range(laid.count):
            address = laid.address + number * laid.stride
            if block.start <= address and address + laid.words <= block.start + block.words:
                whole = value_construct(laid.register.value, laid.order, laid.swapped)
                data = whole.build(resting(layout, laid))
                found.append((laid, data.ljust(2 * laid.words, b"\0")))
    return found


@pytest.mark.parametrize(("layout", "block"), BLOCKS)
def test_every_register_of_an_idle_device_is_decoded(layout: DeviceLayout, block: PollBlock) -> None:
    module = module_of(layout)
    constants = {register.name.partition("[")[0]: register for register in module.REGISTERS}
    answered = within(layout, block)
    assert answered
    for laid, data in answered:
        answer = laid.register.answer
        raw = value_construct(answer, laid.order, laid.swapped).parse(data[: answer.size])
        wanted = decoded_value(laid.name, answer, raw, layout.device, None)
        register = constants[laid.name] if laid.count == 1 else next(iter(constants[laid.name]))
        found = register.decode(data)
        assert getattr(found, "raw", found) == wanted, laid.name


def test_what_starts_something_is_among_what_is_read() -> None:
    started = [laid.name for param in BLOCKS for laid, _ in within(*param.values) if laid.register.trigger]  # type: ignore[arg-type]
    assert {"start_move", "start_homing", "stop", "run_point_table", "save_all_parameters"} <= set(started)
