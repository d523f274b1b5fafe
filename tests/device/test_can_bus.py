"""CAN buses as carriers: canopen asks a simulated drive, and `live` reads it, over a virtual bus."""

from __future__ import annotations

import json
from collections.abc import Iterator

import canopen
import pytest
from canopen import objectdictionary as dictionary

from fieldspec.carriers.can_bus import CanBus
from fieldspec.carriers.carrier import CarrierError
from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from layouts import TEST_SPECS

FOLDER = str(TEST_SPECS)
NODE = 5
POSITION = "messages/read_position/response/position"


@pytest.fixture
def drive(request: pytest.FixtureRequest) -> Iterator[SimulatedDevice]:
    place = f"can://virtual/{request.node.name}"
    with simulation("axis", ports={"sdo": place}, unit_address=NODE, folder=FOLDER) as device:
        device.command(set={POSITION: -1000})
        yield device


def objects() -> dictionary.ObjectDictionary:
    """An object that the drive has, and one that it does not have."""
    result = dictionary.ObjectDictionary()
    for name, index in (("position", 0x6064), ("missing", 0x6099)):
        variable = dictionary.ODVariable(name, index, 0)
        variable.data_type, variable.access_type = dictionary.INTEGER32, "rw"
        result.add_object(variable)
    return result


def live(place: str, *arguments: str) -> int:
    """The exit code of a verb."""
    options = ("--port", place, "--unit", str(NODE), "--timeout", "0.5", "--specs", FOLDER)
    return main(["live", "axis", *arguments, "--link", "sdo", *options])


def test_canopen_reads_a_simulated_drive(drive: SimulatedDevice) -> None:
    network = canopen.Network()
    network.connect(interface="virtual", channel=drive.place.rpartition("/")[2])
    try:
        node = network.add_node(NODE, objects())
        network.send_message(0x701, b"\x05")  # a heartbeat of another node, which nobody answers
        assert node.sdo["position"].raw == -1000
        with pytest.raises(canopen.SdoAbortedError) as aborted:
            node.sdo["missing"].raw  # noqa: B018
        assert aborted.value.code == 0x06020000
    finally:
        network.disconnect()


def test_live_reads_a_drive_over_a_bus(drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live(drive.place, "read", "read_position.position", "--format", "json") == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row["value"] == -1000


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["simulate", "axis"], "say on which bus sdo is: --port sdo=can://socketcan/can0"),
        (["simulate", "axis", "--port", "sdo=pty"], "sdo is a CAN bus; write where it is as can://INTERFACE/CHANNEL"),
        (["simulate", "servo", "--port", "can://virtual/x"], "bus is no CAN bus; use a serial port"),
        (["simulate", "axis", "--port", "can://virtual"], "can://virtual is no CAN bus"),
        (["simulate", "axis", "--port", "can://virtual/x?fd=1"], "fd=1 is no option; write ?bitrate=500000"),
        (["simulate", "axis", "--port", "can://nothing/x"], "cannot open can://nothing/x"),
        (["live", "axis", "read", "--link", "sdo", "--port", "tcp://127.0.0.1:1"], "sdo is a CAN bus"),
        (["live", "servo", "read", "--port", "can://virtual/x"], "bus is no CAN bus"),
        (["live", "axis", "read", "--link", "vehicle", "--port", "can://virtual/x"], "nothing says which priority"),
    ],
)
def test_a_place_that_is_none_for_a_link_is_refused(
    arguments: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*arguments, "--specs", FOLDER]) == 2
    assert text in capsys.readouterr().err


def test_frames_of_others_on_a_bus_are_left_out_where_they_carry_no_data() -> None:
    import can

    carrier = CanBus("can://virtual/remote")
    with can.Bus(interface="virtual", channel="remote") as other:
        other.send(can.Message(arbitration_id=0x123, is_remote_frame=True))
        other.send(can.Message(arbitration_id=0x123, is_extended_id=True, data=b"\x01"))
        assert carrier.read(1.0) == b""
        assert carrier.read(1.0) == bytes.fromhex("80 00 01 23 01 00 00 00 01")
    carrier.close()
    with pytest.raises(CarrierError, match="is closed"):
        carrier.read(0.1)
