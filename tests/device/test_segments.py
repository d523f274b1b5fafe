"""Values in pieces: canopen reads and writes long objects of a simulated drive, and `live` those of canopen's node."""

from __future__ import annotations

import json
from collections.abc import Iterator

import canopen
import pytest
from canopen import objectdictionary as dictionary

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from layouts import TEST_SPECS
from simulators import Unit

FOLDER = str(TEST_SPECS)
NODE = 5
DEVICE_NAME = "parameters/objects/device_name"
KINDS = {
    (0x1008, 0): dictionary.VISIBLE_STRING,
    (0x2000, 0): dictionary.VISIBLE_STRING,
    (0x2001, 0): dictionary.UNSIGNED64,
}


@pytest.fixture(scope="module")
def drive() -> Iterator[SimulatedDevice]:
    with simulation("axis", ports={"sdo": "can://virtual/segments"}, unit_address=NODE, folder=FOLDER) as own:
        yield own


@pytest.fixture(scope="module")
def network(drive: SimulatedDevice) -> Iterator[canopen.Network]:
    own = canopen.Network()
    own.connect(interface="virtual", channel=drive.place.rpartition("/")[2])
    yield own
    own.disconnect()


@pytest.fixture
def node(network: canopen.Network) -> canopen.RemoteNode:
    """The drive as canopen sees it, anew each time: aborted streams of canopen send again when forgotten."""
    own = network.add_node(NODE, objects())
    own.sdo.RESPONSE_TIMEOUT = 20.0
    return own


def objects() -> dictionary.ObjectDictionary:
    """The long objects of the drive, as canopen sees them."""
    result = dictionary.ObjectDictionary()
    for (number, subindex), kind in KINDS.items():
        variable = dictionary.ODVariable(f"object_{number:x}", number, subindex)
        variable.data_type, variable.access_type = kind, "rw"
        result.add_object(variable)
    return result


@pytest.mark.parametrize("name", ["Axis", "Axis 1.", "Axis of nobody", "Axis of nobody, and all of 32 ch"])
def test_canopen_reads_a_text_of_any_length(drive: SimulatedDevice, node: canopen.RemoteNode, name: str) -> None:
    drive.command(set={DEVICE_NAME: name})
    assert node.sdo[0x1008].raw == name


@pytest.mark.parametrize("label", ["", "A", "Left", "Right", "Label 7", "exactly twenty chars"])
def test_canopen_writes_a_text_and_reads_it_again(node: canopen.RemoteNode, label: str) -> None:
    node.sdo[0x2000].raw = label
    assert node.sdo[0x2000].raw == label


def test_canopen_writes_a_number_of_eight_bytes(node: canopen.RemoteNode) -> None:
    node.sdo[0x2001].raw = 9_876_543_210
    assert node.sdo[0x2001].raw == 9_876_543_210


@pytest.mark.parametrize(
    ("number", "data", "code"),
    [
        (0x2001, b"12345", 0x06070010),
        (0x2001, (10**14).to_bytes(8, "little"), 0x06090030),
        (0x2000, b"more than twenty characters", 0x06070010),
        (0x1008, b"another name", 0x06010002),
        (0x6064, b"12345678", 0x06010002),
        (0x3000, b"12345678", 0x06020000),
    ],
)
def test_a_long_value_that_no_object_takes_is_aborted(
    node: canopen.RemoteNode, number: int, data: bytes, code: int
) -> None:
    with pytest.raises(canopen.SdoAbortedError) as aborted:
        node.sdo.download(number, 0, data)
    assert aborted.value.code == code


def answers(*frames: str) -> list[str]:
    """What the drive answers to the data of some frames, one by one."""
    unit = Unit("axis", "sdo", folder=TEST_SPECS)
    head = bytes.fromhex("00 00 06 01 08 00 00 00")
    return [unit.server.answer("sdo", head + bytes.fromhex(frame)).frame[8:].hex(" ").upper() for frame in frames]


BEGUN = "60 00 20 00 00 00 00 00"
WRITE_LABEL = "21 00 20 00 07 00 00 00"


@pytest.mark.parametrize(
    ("frames", "last"),
    [
        # The toggle bit does not alternate; then nothing is on its way.
        ((WRITE_LABEL, "10 41 42 43 44 45 46 47"), "80 00 20 00 00 00 03 05"),
        ((WRITE_LABEL, "10 41 42 43 44 45 46 47", "01 41 42 43 44 45 46 47"), "80 00 00 00 01 00 04 05"),
        # Fewer and more bytes than were announced.
        ((WRITE_LABEL, "05 41 42 43 44 45 00 00"), "80 00 20 00 10 00 07 06"),
        ((WRITE_LABEL, "00 41 42 43 44 45 46 47", "1D 48 00 00 00 00 00 00"), "80 00 20 00 10 00 07 06"),
        # Pieces without a beginning, and those of a value that another request has ended.
        (("60 00 00 00 00 00 00 00",), "80 00 00 00 01 00 04 05"),
        ((WRITE_LABEL, "40 41 60 00 00 00 00 00", "01 41 42 43 44 45 46 47"), "80 00 00 00 01 00 04 05"),
        ((WRITE_LABEL, "60 00 00 00 00 00 00 00"), "80 00 20 00 01 00 04 05"),
        # Nothing answers an abort, which ends what is on its way.
        ((WRITE_LABEL, "80 00 20 00 00 00 00 08"), ""),
        ((WRITE_LABEL, "80 00 20 00 00 00 00 08", "01 41 42 43 44 45 46 47"), "80 00 00 00 01 00 04 05"),
        # As it should be.
        ((WRITE_LABEL, "01 41 42 43 44 45 46 47"), "20 00 00 00 00 00 00 00"),
    ],
)
def test_a_simulated_drive_aborts_pieces_that_do_not_follow(frames: tuple[str, ...], last: str) -> None:
    own = answers(*frames)
    if frames[0] == WRITE_LABEL:
        assert own[0] == BEGUN
    assert own[-1] == last


def test_a_loss_of_power_ends_what_is_on_its_way() -> None:
    unit = Unit("axis", "sdo", folder=TEST_SPECS)
    unit.ask("download_segments", index=0x2000, subindex=0, size=7)
    unit.engine.power_on()
    answer = unit.answer("download_segment", command=1, data=b"ABCDEFG")
    assert answer.text == "refused, segment_unexpected: no value is on its way"


def live(place: str, *arguments: str) -> int:
    """The exit code of a verb."""
    options = ("--port", place, "--unit", str(NODE), "--timeout", "0.5", "--specs", FOLDER)
    return main(["live", "axis", *arguments, "--link", "sdo", *options])


def test_live_reads_and_writes_values_in_pieces(drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    drive.command(set={DEVICE_NAME: "Axis of nobody"})
    assert live(drive.place, "write", "label=Left and right", "travel=9876543210", "--yes") == 0
    capsys.readouterr()
    assert live(drive.place, "read", "device_name", "label", "travel", "--format", "json") == 0
    assert [row["value"] for row in json.loads(capsys.readouterr().out)] == [
        "Axis of nobody",
        "Left and right",
        9876543210,
    ]


def test_live_reads_and_writes_the_long_objects_of_a_node_of_canopen(
    request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> None:
    network = canopen.Network()
    network.connect(interface="virtual", channel=request.node.name)
    own = network.create_node(NODE, objects())
    own.sdo[0x1008].raw = "Node of canopen"
    place = f"can://virtual/{request.node.name}"
    assert live(place, "write", "label=Left and right", "travel=9876543210", "--yes") == 0
    capsys.readouterr()
    assert live(place, "read", "device_name", "label", "travel", "--format", "json") == 0
    assert [row["value"] for row in json.loads(capsys.readouterr().out)] == [
        "Node of canopen",
        "Left and right",
        9876543210,
    ]
    assert (own.sdo[0x2000].raw, own.sdo[0x2001].raw) == ("Left and right", 9876543210)
    network.disconnect()
