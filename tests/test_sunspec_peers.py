"""Registers with scale factors, as SunSpec defines them, against pysunspec2 over TCP.

The models of the made-up inverter are compared with the model definitions that pysunspec2 brings along.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
from sunspec2.modbus.client import SunSpecModbusClientDeviceTCP

from command_line import CommandLine
from fieldspec.cli import main
from fieldspec.codec.explain.occupants import Occupant
from fieldspec.language.model.value import Value
from fieldspec.testing import SimulatedDevice
from layouts import TEST_SPECS
from python_package import codec_error, runtime
from sunspec import CLIENT, INVERTER, LAYOUT, SECONDS, address, occupant, put, simulated_inverter

CodecError = codec_error()
MODELS = {"inverter": 103, "trackers": 160}
# Raw values at bounds of their types and at usual places; the last one of each type stands for "not implemented".
RAW = {
    "u16": (0, 1, 2304, 65534, 65535),
    "i16": (-32767, -1, 9870, 32767, -32768),
    "u32": (1, 123456789, 0xFFFFFFFE, 0),
}


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulated_inverter() as running:
        yield running


@pytest.fixture(scope="module")
def peer(device: SimulatedDevice) -> Iterator[Any]:
    """A device of pysunspec2 that has found the models of the simulated one."""
    host, port = address(device)
    client = SunSpecModbusClientDeviceTCP(slave_id=1, ipaddr=host, ipport=port, timeout=SECONDS)
    client.scan()
    yield client
    client.close()


@pytest.fixture(scope="module")
def client(device: SimulatedDevice) -> Iterator[Any]:
    """The generated client."""
    with runtime("transports").tcp(*address(device)) as transport:
        yield CLIENT.Client(transport, link="tcp", timeout=SECONDS)


@dataclass(frozen=True)
class Point:
    """A value of a register or a field, and the point of pysunspec2. `unit` converts counts, `read` asks the device."""

    occupant: Occupant
    peer: Any
    unit: Any
    read: Callable[[Any], Any]

    @property
    def value(self) -> Value:
        return self.occupant.value

    @property
    def exponent(self) -> str:
        """The register with the exponent of the scale."""
        return self.value.scale_by


def points(peer: Any, group: str) -> list[Point]:
    """The registers of a group, and the fields of the modules after it."""
    model = peer.models[MODELS[group]][0]
    rows = [
        Point(
            occupant(register.name),
            model.points[register.printed_name],
            getattr(INVERTER, register.name.upper()),
            lambda client, name=register.name: client.read(getattr(INVERTER, name.upper())),
        )
        for own in LAYOUT.device.groups
        if own.name == group
        for register in own.registers
        if register.count == 1
    ]
    return rows + (module_points(model.groups["module"]) if group == "trackers" else [])


def module_points(modules: Any) -> list[Point]:
    return [
        Point(
            occupant(f"modules[{number}].{field.name}"),
            module.points[field.field.printed_name],
            getattr(INVERTER.Module, f"{field.name.upper()}_UNIT", None),
            lambda client, number=number, name=field.name: getattr(client.read(INVERTER.modules[number]), name),
        )
        for number, module in enumerate(modules, 1)
        for field in LAYOUT.records["module"].fields
    ]


def scaled(rows: Iterable[Point]) -> list[Point]:
    return [row for row in rows if row.exponent]


def test_pysunspec2_knows_the_models_and_where_they_end(peer: Any) -> None:
    assert peer.base_addr == 40000
    assert [model.model_id for model in peer.model_list] == [1, 103, 160]
    assert len(peer.models[160][0].groups["module"]) == 2
    assert INVERTER.END_MODEL.address == 40002 + sum(model.len + 2 for model in peer.model_list)


@pytest.mark.parametrize("group", MODELS)
def test_every_point_has_the_type_the_place_and_the_unit_of_the_public_model(peer: Any, group: str) -> None:
    units = {None: "", "C": "°C", "Pct": "%", "Secs": "s"}
    kinds = {
        "i16": ("int16", "sunssf"),
        "u16": ("uint16", "enum16", "count"),
        "u32": ("acc32", "uint32", "bitfield32"),
    }
    for row in points(peer, group):
        value, point = row.value, row.peer
        assert row.occupant.address == point.model.model_addr + point.offset, row.occupant.path
        assert point.pdef["type"] in kinds.get(value.type.name, ("string",)), row.occupant.path
        assert (row.exponent != "") == (point.sf is not None), row.occupant.path
        if row.exponent:
            assert LAYOUT.device.register(row.exponent).printed_name == point.sf  # type: ignore[union-attr]
            assert value.quantity_unit in (units.get(point.pdef.get("units"), point.pdef.get("units")), "V")


@pytest.mark.parametrize("power", [-10, -2, 0, 3, 10])
@pytest.mark.parametrize("group", MODELS)
def test_what_pysunspec2_reads_is_what_the_codec_and_the_client_read(
    device: SimulatedDevice, peer: Any, client: Any, group: str, power: int
) -> None:
    rows = scaled(points(peer, group))
    for turn in range(5):
        raws = [RAW[row.value.type.name][(at + turn) % len(RAW[row.value.type.name])] for at, row in enumerate(rows)]
        for row, raw in zip(rows, raws, strict=True):
            put(device, row.exponent, power)
            put(device, row.occupant.path, raw)
        peer.models[MODELS[group]][0].read()
        for at, (row, raw) in enumerate(zip(rows, raws, strict=True)):
            quantity = row.unit.in_unit(raw, power)
            assert row.peer.cvalue == (None if quantity is None else pytest.approx(quantity, rel=1e-9)), row.occupant
            if at == turn:
                assert row.read(client) == raw
                if isinstance(row.unit, runtime("_registers").Register):
                    assert client.read_in_unit(row.unit) == quantity


@pytest.mark.parametrize("group", MODELS)
def test_the_client_reads_what_pysunspec2_encodes(device: SimulatedDevice, peer: Any, client: Any, group: str) -> None:
    model, exponents = peer.models[MODELS[group]][0], {-2: 12.34, 0: 210, 2: 45600}
    rows = scaled(points(peer, group))
    for power, quantity in exponents.items():
        for row in rows:
            name = LAYOUT.device.register(row.exponent).printed_name  # type: ignore[union-attr]
            model.points[name].value = power
            row.peer.sf_value = None
            row.peer.cvalue = quantity
            assert row.peer.value is not None, row.occupant.path
        memory = device.simulation.engine.memory
        data = model.get_mb()
        for at in range(4, len(data), 2):
            memory.words["", model.model_addr + at // 2] = int.from_bytes(data[at : at + 2], "big")
        for row in rows[::4]:
            assert row.read(client) == row.peer.value == row.unit.from_unit(quantity, power), row.occupant.path
            assert row.unit.in_unit(row.peer.value, power) == pytest.approx(quantity), row.occupant.path


def test_an_exponent_that_is_not_implemented_leaves_no_quantity(device: SimulatedDevice, client: Any) -> None:
    device.set(**{"registers/power": 5, "registers/power_sf": -0x8000})
    assert client.read_in_unit(INVERTER.POWER) is None
    assert client.read(INVERTER.POWER) == 5


def test_a_quantity_is_written_by_the_exponent_that_the_device_has(device: SimulatedDevice, client: Any) -> None:
    device.set(**{"registers/power_limit_sf": 1})
    client.write_in_unit(INVERTER.POWER_LIMIT, 1500)
    assert device.value("registers/power_limit") == 150
    device.set(**{"registers/power_limit_sf": -1})
    client.write_in_unit(INVERTER.POWER_LIMIT, Decimal("0.25"))  # the nearest count, of two the even one
    assert device.value("registers/power_limit") == 2
    with pytest.raises(runtime("errors").InvalidValueError, match="not in"):
        client.write_in_unit(INVERTER.POWER_LIMIT, 3001)
    device.set(**{"registers/power_limit_sf": -0x8000})
    with pytest.raises(runtime("errors").InvalidValueError, match=r"not an exponent in -10\.\.10"):
        client.write_in_unit(INVERTER.POWER_LIMIT, 1)
    assert device.value("registers/power_limit") == 2


def test_pysunspec2_writes_what_the_client_reads(peer: Any, client: Any) -> None:
    common = peer.models[1][0]
    common.read()
    common.points["DA"].value = 17
    common.write()
    assert client.read(INVERTER.DEVICE_ADDRESS) == 17


def test_a_group_has_quantities_where_it_has_the_exponents(device: SimulatedDevice, client: Any) -> None:
    device.set(**{"registers/current": 123, "registers/current_sf": -1})
    values = client.read_group(CLIENT.INVERTER)
    assert values.in_unit(INVERTER.CURRENT) == 12.3


def test_a_frame_explains_a_quantity_where_it_has_the_exponent(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    options = ("--link", "tcp", "--direction", "response", "--format", "json")
    for start, words, text in (
        (40084, "26 8E FF FF", "987.0 W"),
        (40084, "26 8E 00 03", "9870000 W"),
        (40084, "26 8E 80 00", "9870 \N{MULTIPLICATION SIGN}10^power_sf W"),
        (40084, "26 8E 00 0B", "9870 \N{MULTIPLICATION SIGN}10^power_sf W"),
        (40084, "26 8E", "9870 \N{MULTIPLICATION SIGN}10^power_sf W"),
        (40084, "80 00 FF FF", ""),
    ):
        data = bytes.fromhex(words)
        request = f"0001 0000 0006 01 03 {start:04X} {len(data) // 2:04X}"
        frame = f"0001 0000 {len(data) + 3:04X} 01 03 {len(data):02X} {data.hex()}"
        code, output, _ = run("decode", "inverter", frame, "--request", request, *options)
        (row,) = [row for row in json.loads(output)["registers"] if row["path"] == "power"]
        assert (code, row["value"] or "") == (0, text), words


def test_live_reads_quantities_and_takes_counts(device: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    def live(*arguments: str) -> int:
        place = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "1", "--specs", str(TEST_SPECS))
        return main(["live", "inverter", *arguments, *place])

    device.set(**{"registers/power": 9870, "registers/power_sf": -1, "registers/power_limit_sf": 2})
    assert live("read", "power", "--format", "json") == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["name"], row["value"], row["meaning"]) == ("power", 9870, "987.0 W")
    assert live("write", "power_limit=25") == 0
    assert device.value("registers/power_limit") == 25
    assert live("write", "power_limit=2500W") == 2
    assert "its scale is in power_limit_sf, so give a count" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("register", "arguments", "reason"),
    [
        ("POWER", (1,), "wrong_type"),
        ("POWER", (1, 11), "out_of_range"),
        ("POWER", (1, 1.0), "out_of_range"),
        ("POWER", (1, True), "out_of_range"),
        ("POWER_SF", (1, 2), "wrong_type"),
    ],
)
def test_an_exponent_that_is_none_is_refused(register: str, arguments: tuple[Any, ...], reason: str) -> None:
    for method in ("in_unit", "from_unit"):
        with pytest.raises(CodecError) as refused:
            getattr(getattr(INVERTER, register), method)(*arguments)
        assert refused.value.reason == reason


def test_a_record_has_quantities_where_it_has_the_exponent() -> None:
    phase = INVERTER.Phase(current=-123, phase_sf=-1)
    assert phase.current_a == -12.3
    phase.current_a = 4.56
    assert phase.current == 46
    phase.phase_sf = phase.PHASE_SF_NOT_IMPLEMENTED
    assert phase.current_a is None
    phase.phase_sf = 11
    with pytest.raises(CodecError, match=r"phase_sf is 11, not an exponent in -10\.\.10"):
        phase.current_a  # noqa: B018
    snapshot = INVERTER.ReadSnapshotResponse(7, 0xFFFF, [1, 2], 3, [phase])
    assert (snapshot.limit_w, snapshot.limits_w) == (None, [1000.0, 2000.0])
    snapshot.limits_w = [5000, Decimal("6499.5")]
    assert snapshot.limits == [5, 6]
    assert snapshot.ENERGY_UNIT.in_unit(snapshot.energy, 2) == 700.0


def test_a_message_explains_quantities_by_the_exponents_in_it(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    data = bytes.fromhex("00000007 0019 0001 FFFF FE 007B FF 007B 80")
    frame = f"0001 0000 {len(data) + 2:04X} 01 41 {data.hex()}"
    code, output, _ = run("decode", "inverter", frame, "--link", "tcp", "--direction", "response", "--format", "json")
    texts = {row["path"]: row["value"] for row in json.loads(output)["rows"]}
    times = "\N{MULTIPLICATION SIGN}10^"
    assert code == 0
    assert [texts[name] for name in ("energy", "limit", "limits[1]", "phases[0].current", "phases[1].current")] == [
        f"7 {times}energy_sf Wh",
        "0.25 W",
        "655.35 W",
        "12.3 A",
        f"123 {times}phase_sf A",
    ]


def test_a_frame_explains_the_fields_of_a_table_by_the_exponent_in_a_register(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    words = [0] * (40152 - 40124)
    words[0], words[40141 - 40124] = 0xFFFE, 123
    data = b"".join(word.to_bytes(2, "big") for word in words)
    request = f"0001 0000 0006 01 03 {40124:04X} {len(words):04X}"
    frame = f"0001 0000 {len(data) + 3:04X} 01 03 {len(data):02X} {data.hex()}"
    options = ("--request", request, "--link", "tcp", "--direction", "response", "--format", "json")
    rows = json.loads(run("decode", "inverter", frame, *options)[1])["registers"]
    assert next(row["value"] for row in rows if row["path"] == "modules[1].current") == "1.23 A"


def test_live_reads_the_fields_of_a_table_as_quantities(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, "modules[2].voltage", 4012)
    put(device, "module_voltage_sf", -1)
    place = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "1", "--specs", str(TEST_SPECS))
    assert main(["live", "inverter", "read", "modules[2].voltage", "--format", "json", *place]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["value"], row["meaning"]) == (4012, "401.2 V")


def test_an_exported_list_names_the_exponent_and_is_compared_without_a_difference(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run, path = CommandLine(capsys, monkeypatch, TEST_SPECS), tmp_path / "inverter.csv"
    assert run("export", "inverter", "--out", str(path))[0] == 0
    (power,) = [row for row in csv.DictReader(path.read_text("utf-8").splitlines()) if row["name"] == "power"]
    assert (power["unit"], power["ucum"], power["scale"]) == ("W", "W", "10^power_sf")
    assert "0 differ" in run("compare", "inverter", str(path))[1]
    path.write_text(path.read_text("utf-8").replace("10^power_sf", "0.1"), "utf-8")
    assert "power  scale  10^power_sf  0.1" in run("compare", "inverter", str(path))[1]
