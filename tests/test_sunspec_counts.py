"""A table whose number of elements the device says, as model 160 of SunSpec does, against pysunspec2 over TCP."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from sunspec2.modbus.client import SunSpecModbusClientDeviceTCP, SunSpecModbusClientModel

from command_line import CommandLine
from fieldspec.cli import main
from fieldspec.codec.layout.read_plan import read_plan
from fieldspec.testing import SimulatedDevice
from layouts import TEST_SPECS
from python_package import codec_error, runtime
from sunspec import CLIENT, INVERTER, LAYOUT, SECONDS, address, put, simulated_inverter

CodecError = codec_error()


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulated_inverter() as running:
        yield running


@pytest.fixture(scope="module")
def client(device: SimulatedDevice) -> Iterator[Any]:
    """The generated client."""
    with runtime("transports").tcp(*address(device)) as transport:
        yield CLIENT.Client(transport, link="tcp", timeout=SECONDS)


@pytest.mark.parametrize("count", [2, 1, 0])
def test_the_modules_of_a_device_are_as_many_as_it_says(
    device: SimulatedDevice, client: Any, capsys: pytest.CaptureFixture[str], count: int
) -> None:
    put(device, "module_count", count)
    put(device, "tracker_length", 8 + 20 * count)
    put(device, "module_current_sf", -2)
    for number, current in ((1, 812), (2, 1234)):
        put(device, f"modules[{number}].current", current)
    host, port = address(device)
    other = SunSpecModbusClientDeviceTCP(slave_id=1, ipaddr=host, ipport=port, timeout=SECONDS)
    try:
        other.connect()
        start = INVERTER.TRACKER_MODEL.address
        head, size = other.read(start, 2), 8 + 20 * count
        model = SunSpecModbusClientModel(160, model_addr=start, model_len=size, data=head, mb_device=other)
        model.read()
        peers = [module.points["DCA"].cvalue for module in model.groups.get("module", [])]
    finally:
        other.close()
    assert peers == [8.12, 12.34][:count]
    records = client.read_table(INVERTER.modules)
    assert [INVERTER.Module.CURRENT_UNIT.in_unit(record.current, -2) for record in records] == peers
    for number in range(count + 1, 3):
        with pytest.raises(runtime("errors").RefusedError):
            client.read(INVERTER.modules[number])
    place = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "1", "--specs", str(TEST_SPECS))
    names = ("modules[1].current", "modules[2].current")
    assert main(["live", "inverter", "read", *names, "--format", "json", *place]) == (0 if count == 2 else 1)
    rows = json.loads(capsys.readouterr().out)
    assert [row["meaning"] for row in rows] == [
        f"{text} A" if number < count else f"refused: The device has no such element: module_count is {count}."
        for number, text in enumerate(("8.12", "12.34"))
    ]
    assert main(["scan", "inverter", "0x9CBA..0x9CEB", *place]) == 0
    assert "modules" not in capsys.readouterr().out
    assert main(["live", "inverter", "dump", "-", *place]) == 0
    addresses = {int(line.partition(",")[0], 16) for line in capsys.readouterr().out.splitlines()[1:]}
    assert addresses & set(range(40132, 40172)) == set(range(40132, 40132 + 20 * count))


def test_more_elements_than_a_table_has_are_refused() -> None:
    assert INVERTER.modules.count_by is INVERTER.MODULE_COUNT
    assert [element.address for element in INVERTER.modules.present(1)] == [40132]
    for count, reason in ((3, "out_of_range"), (-1, "out_of_range"), (True, "wrong_type")):
        with pytest.raises(CodecError) as refused:
            INVERTER.modules.present(count)
        assert refused.value.reason == reason


def test_each_element_that_may_be_absent_is_read_by_itself() -> None:
    blocks = {block.start: block.end for block in read_plan(LAYOUT).blocks}
    assert (blocks[40132], blocks[40152]) == (40152, 40172)
    assert 40132 in blocks.values()


def test_a_frame_with_the_count_says_which_elements_the_device_has_not_got(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    data = b"".join(word.to_bytes(2, "big") for word in (1, *[0] * 41))
    request = f"0001 0000 0006 01 03 {40130:04X} 002A"
    frame = f"0001 0000 {len(data) + 3:04X} 01 03 {len(data):02X} {data.hex()}"
    options = ("--request", request, "--link", "tcp", "--direction", "response", "--format", "json")
    rows = {row["path"]: row["notes"] for row in json.loads(run("decode", "inverter", frame, *options)[1])["registers"]}
    assert rows["modules[1].current"] == []
    assert rows["modules[2].current"] == ["The device has no such element: module_count is 1."]
