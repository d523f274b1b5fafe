"""The work of the outputs grows with the device, not with its square.

Calls of functions are counted instead of seconds: they are the same in every run.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks" / "peers"))

import registers

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.reading.project import read
from fieldspec.targets import OUTPUTS
from layouts import SPECS, layout_at

FEW, MANY = 50, 200


MODBUS = "uses: [{protocol: modbus, links: [rtu], messages: [read_registers, write_registers]}]\n"


def layout_of(count: int, with_messages: bool) -> DeviceLayout:
    """A device with so many registers, without a message or with those of Modbus that read and write them."""
    ((path, text),) = registers.spec(count).items()
    if with_messages:
        text = text[: text.index("links:")] + MODBUS + text[text.index("enums:") :]
    protocol = "protocols/modbus.yaml"
    (spec,) = read({path: text.encode(), protocol: (SPECS / protocol).read_bytes()}).devices.values()
    return layout_at(spec, spec.versions()[-1])


def calls_of(output: str, layout: DeviceLayout) -> int:
    """How many functions are called to write an output."""
    count = 0

    def profile(frame: object, event: str, argument: object) -> None:
        nonlocal count
        count += event == "call"

    write = OUTPUTS[output].files
    sys.setprofile(profile)
    try:
        write([layout])
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.proof(5)
@pytest.mark.parametrize("with_messages", [False, True], ids=["alone", "with messages"])
@pytest.mark.parametrize("output", OUTPUTS)
def test_four_times_the_registers_take_four_times_the_work(output: str, with_messages: bool) -> None:
    calls_of(output, layout_of(10, with_messages))  # what is made once
    few, many = (calls_of(output, layout_of(count, with_messages)) for count in (FEW, MANY))
    assert many < few * MANY / FEW * 1.05
