"""Generated Python asks an idle device for its registers, and decodes what it answers, as the vectors say."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.targets.vectors.backend import idle_vectors
from layouts import SPECS, TEST_SPECS, newest
from python_package import module_of

DEVICES = {name: newest(root, name) for root, name in ((SPECS, "ck10"), (SPECS, "tc100"), (TEST_SPECS, "widget"))}
READS: list[Any] = [
    pytest.param(device, read, id=f"{device}-{read['address']:04X}")
    for device, layout in DEVICES.items()
    for read in idle_vectors([layout])
]


@pytest.mark.parametrize(("device", "read"), READS)
def test_every_register_of_an_idle_device_is_decoded(device: str, read: dict[str, Any]) -> None:
    layout = DEVICES[device]
    module = module_of(layout)
    constants = {register.name.partition("[")[0]: register for register in module.REGISTERS}
    registers = {register.name: register for register in layout.registers}
    values = layout.messages[read["message"]].message.single_access.values
    numbers = read["response"]["values"][values]
    words = numbers if isinstance(numbers, list) else [numbers]
    for full_name, wanted in read["registers"].items():
        name, _, index = full_name.rstrip("]").partition("[")
        if name not in registers:
            continue  # an element of a record table
        register = registers[name]
        number = int(index) - register.register.index_from if index else 0
        at = register.address + number * register.stride - read["address"]
        data = b"".join(word.to_bytes(2, "big") for word in words[at : at + register.words])
        constant = constants[name] if register.count == 1 else next(iter(constants[name]))
        value = constant.decode(data)
        raw = getattr(value, "raw", value)
        assert (raw.hex() if isinstance(raw, bytes) else raw) == wanted, full_name


def test_registers_that_start_something_are_among_those_read() -> None:
    names = {name for param in READS for name in param.values[1]["registers"]}
    assert {"start_move", "start_homing", "stop", "run_point_table", "save_all_parameters"} <= names
