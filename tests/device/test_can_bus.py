"""CAN buses as carriers: canopen asks a simulated drive, and `live` reads it, over a virtual bus."""

from __future__ import annotations

import json
from collections.abc import Iterator

import canopen
import pytest
from canopen import objectdictionary as dictionary

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.carriers.can_bus import CanBus
from fieldspec.tools.carriers.carrier import CarrierError
from layouts import TEST_SPECS

FOLDER = str(TEST_SPECS)
NODE = 5
POSITION = "parameters/objects/position"


@pytest.fixture
def drive(request: pytest.FixtureRequest) -> Iterator[SimulatedDevice]:
    place = f"can://virtual/{request.node.name}"
    with simulation("axis", ports={"sdo": place}, unit_address=NODE, folder=FOLDER) as device:
        device.command(set={POSITION: -1000})
        yield device


ENTRIES = (
    ("position", 0x6064, 0, dictionary.INTEGER32),
    ("target", 0x607A, 0, dictionary.INTEGER32),
    ("wide_mode", 0x6060, 0, dictionary.INTEGER32),
    ("missing", 0x60FF, 0, dictionary.INTEGER32),
    ("highest", 0x6099, 0, dictionary.UNSIGNED8),
    ("zero_search", 0x6099, 2, dictionary.UNSIGNED32),
    ("beyond", 0x6099, 3, dictionary.UNSIGNED32),
    ("element_of_a_value", 0x607B, 1, dictionary.INTEGER32),
)


@pytest.fixture
def node(drive: SimulatedDevice) -> Iterator[canopen.RemoteNode]:
    """The drive as canopen sees it, with objects that it does not have."""
    network = canopen.Network()
    network.connect(interface="virtual", channel=drive.place.rpartition("/")[2])
    yield network.add_node(NODE, dictionary.ObjectDictionary())
    network.disconnect()


def entry(node: canopen.RemoteNode, name: str) -> canopen.sdo.base.SdoVariable:
    """An object as canopen reads and writes it."""
    own, index, subindex, kind = next(row for row in ENTRIES if row[0] == name)
    variable = dictionary.ODVariable(own, index if index != 0x607B else 0x607A, subindex)
    variable.data_type, variable.access_type = kind, "rw"
    return canopen.sdo.base.SdoVariable(node.sdo, variable)


def live(place: str, *arguments: str) -> int:
    """The exit code of a verb."""
    options = ("--port", place, "--unit", str(NODE), "--timeout", "0.5", "--specs", FOLDER)
    return main(["live", "axis", *arguments, "--link", "sdo", *options])


def test_canopen_reads_and_writes_the_objects_of_a_simulated_drive(node: canopen.RemoteNode) -> None:
    node.network.send_message(0x701, b"\x05")  # a heartbeat of another node, which nobody answers
    assert (entry(node, "position").raw, entry(node, "highest").raw) == (-1000, 2)
    entry(node, "target").raw = -70_000
    entry(node, "zero_search").raw = 3_000_000_000
    assert (entry(node, "target").raw, entry(node, "zero_search").raw) == (-70_000, 3_000_000_000)


@pytest.mark.proof(4)
@pytest.mark.parametrize(
    ("name", "value", "code"),
    [
        ("missing", None, 0x06020000),
        ("missing", 1, 0x06020000),
        ("beyond", None, 0x06090011),
        ("element_of_a_value", None, 0x06090011),
        ("position", 1, 0x06010002),
        ("highest", 3, 0x06010002),
        ("target", 1_000_001, 0x06090030),
        ("wide_mode", 1, 0x06070010),
    ],
)
def test_a_simulated_drive_aborts_what_no_object_takes(
    node: canopen.RemoteNode, name: str, value: int | None, code: int
) -> None:
    own = entry(node, name)
    with pytest.raises(canopen.SdoAbortedError) as aborted:
        own.raw if value is None else setattr(own, "raw", value)
    assert aborted.value.code == code


def test_live_reads_and_writes_objects_by_name_over_a_bus(
    drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert live(drive.place, "read", "position", "--format", "json") == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row["value"] == -1000
    assert live(drive.place, "write", "homing_speeds.zero_search=500 increment/s", "target=-3", "--yes") == 0
    capsys.readouterr()
    assert live(drive.place, "read", "homing_speeds.zero_search", "target", "identity", "--format", "json") == 0
    assert [row["value"] for row in json.loads(capsys.readouterr().out)] == [500, -3, 4, 0, 0, 0, 0]
    assert live(drive.place, "write", "homing_speeds.highest_subindex=3", "--yes") == 2
    assert "homing_speeds.highest_subindex can only be read" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["simulate", "axis"], "say on which bus sdo is: --port sdo=can://socketcan/can0"),
        (["simulate", "axis", "--port", "sdo=pty"], "sdo is a CAN bus; write where it is as can://INTERFACE/CHANNEL"),
        (["simulate", "servo", "--port", "can://virtual/x"], "bus is not a CAN bus; use a serial port"),
        (["simulate", "axis", "--port", "can://virtual"], "can://virtual is not a CAN bus"),
        (["simulate", "axis", "--port", "can://virtual/x?fd=1"], "fd=1 is not an option; write ?bitrate=500000"),
        (["live", "axis", "read", "--link", "sdo", "--port", "can://virtual/x?bitrate="], "bitrate= is not an option"),
        (["simulate", "axis", "--port", "can://nothing/x"], "cannot open can://nothing/x"),
        (["live", "axis", "read", "--link", "sdo", "--port", "tcp://127.0.0.1:1"], "sdo is a CAN bus"),
        (["live", "servo", "read", "--port", "can://virtual/x"], "bus is not a CAN bus"),
        (
            ["live", "axis", "read", "read_hours", "--link", "vehicle", "--port", "can://virtual/x"],
            "the priority in the identifier of requests on vehicle is unknown",
        ),
    ],
)
def test_a_place_that_is_none_for_a_link_is_refused(
    arguments: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*arguments, "--specs", FOLDER]) == 2
    assert text in capsys.readouterr().err


def test_remote_requests_and_data_of_others_on_a_bus_are_told_apart_and_errors_left_out() -> None:
    import can

    carrier = CanBus("can://virtual/remote")
    with can.Bus(interface="virtual", channel="remote") as other:
        other.send(can.Message(arbitration_id=0x123, is_remote_frame=True))
        other.send(can.Message(arbitration_id=0x123, is_extended_id=True, data=b"\x01"))
        other.send(can.Message(is_error_frame=True))
        assert carrier.read(1.0) == bytes.fromhex("C0 00 01 23 00 00 00 00")
        assert carrier.read(1.0) == bytes.fromhex("80 00 01 23 01 00 00 00 01")
        assert carrier.read(1.0) == b""
    carrier.close()
    with pytest.raises(CarrierError, match="is closed"):
        carrier.read(0.1)
