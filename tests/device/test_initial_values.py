"""What a simulated device answers with where nothing says what its values are."""

from __future__ import annotations

import re

import pytest

from fieldspec.command.verbs.simulate import report_silence
from fieldspec.tools.simulator.control import CommandError, carried_out
from fieldspec.tools.simulator.faults import Fault, FaultError
from fieldspec.tools.simulator.simulation import Simulation
from simulators import Unit, parts_of

SPEC = """
device:
  id: trail
  name: Trail
  vendor: Test
  manual: {title: m, file: m.txt, sha256: "%s", lines: 900}
links:
  - name: bus
    source: 1 L1
    transmission: binary
    byte_order: little
    unit_addresses: {range: 1..9, source: 1 L1}
    request: &parts
      - {name: header, type: u16, const: 0x55AA}
      - {name: id, role: unit_address, type: u8}
      - {name: length, role: length, type: u16, measures: {from: instruction, to: crc}}
      - {name: instruction, role: code, type: u8}
      - {name: body, role: body}
      - {name: pad, type: u8, reserved: true}
      - {name: mid, type: u8, const: 7}
      - {name: crc, role: checksum, algorithm: crc16_modbus, covers: {from: id}}
      - {name: stop, type: u8, const: 0x0A}
      - {name: gap, type: u16, reserved: true}
    response: *parts
enums:
  - {name: item, source: 1 L1, members: [{value: 1, name: total}, {value: 2, name: label}, {value: 3, name: number}]}
  - {name: model, source: 1 L1, members: [{value: 3, name: big, unavailable: true}, {value: 4, name: small}]}
records:
  - {name: part, source: 1 L2, fields: [{name: kind, type: u8, enum: model}, {name: weight, type: u16}]}
messages:
  - name: ping
    code: 1
    source: 2 L20
    request: []
    response:
      - {name: model, type: u8, enum: model}
      - {name: others, type: u8, enum: model, count: 2}
      - {name: speed, type: u8, range: 5..9}
      - {name: speeds, type: u8, range: 5..9, count: 2}
      - {name: first, record: part}
      - {name: parts, record: part, count: 2}
      - {name: spare_count, type: u8, measures: {items: spares}}
      - {name: spares, record: part, repeat: 1..3}
  - name: read
    code: 2
    source: 2 L30
    request: [{name: item, type: u8, enum: item}]
    response:
      - {name: item, type: u8, enum: item, same_as: item}
      - name: value
        choice:
          by: item
          cases:
            - {name: energy, when: [total], type: bytes, length: 4}
            - {name: label, when: [label], type: text, length: 3}
            - {name: number, when: [number], type: u16, range: 3..9}
  - name: write
    code: 3
    source: 2 L31
    request: [{name: size, type: u8, measures: {bytes: data}}, {name: data, type: text, varies: true, length: 5}]
    response: []
""" % ("1" * 64)
ANSWER = {
    "model": 4,
    "others": [4, 4],
    "speed": 5,
    "speeds": [5, 5],
    "first": {"kind": 4, "weight": 0},
    "parts": [{"kind": 4, "weight": 0}, {"kind": 4, "weight": 0}],
    "spare_count": 1,
    "spares": [{"kind": 4, "weight": 0}],
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A folder with the spec of a device without behaviour, whose frames have parts around the checksum."""
    root = tmp_path_factory.mktemp("specs")
    (root / "trail").mkdir()
    (root / "trail" / "device.yaml").write_text(SPEC, "utf-8")
    return str(root)


def unit_of(folder: str) -> Unit:
    return Unit("trail", "bus", unit_address=3, folder=folder)


def test_every_field_of_a_response_has_a_value_that_it_can_have(folder: str) -> None:
    assert unit_of(folder).ask("ping") == ANSWER


def test_what_no_response_can_say_is_reported_once(folder: str, capsys: pytest.CaptureFixture[str]) -> None:
    unit = unit_of(folder)
    report_silence(unit.server)
    unit.engine.memory.fields["messages/ping/response/model"] = 9
    assert [unit.answer("ping").frame for _ in range(2)] == [b"", b""]
    (line,) = capsys.readouterr().err.splitlines()
    assert (
        line == "fieldspec: bus: no response of ping can say this: unknown_value: model is 9, which model does not list"
    )


@pytest.mark.parametrize(("item", "value"), [(1, bytes(4)), (2, ""), (3, 3)])
def test_a_choice_has_a_value_of_the_case_that_the_request_chooses(folder: str, item: int, value: object) -> None:
    assert unit_of(folder).ask("read", item=item) == {"item": item, "value": value}


def test_a_request_that_measures_more_than_it_has_is_refused_in_words(folder: str) -> None:
    unit = unit_of(folder)
    frame = bytearray(unit.codec.encode("request", "write", {**unit.head, "data": "abc"}))
    place = frame.index(b"abc") - 1
    frame[place] = 4
    answer = unit.answer_to(unit.codec.with_checksum("request", bytes(frame)))
    assert "size says more bytes of data than there are" in answer.text


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("model", "did you mean messages/ping/response/model?"),
        ("messages/ping/response/modell", "did you mean messages/ping/response/model"),
        ("xyz", "`fieldspec facts` lists the paths"),
    ],
)
def test_an_unknown_signal_gets_the_path_that_it_means(folder: str, name: str, hint: str) -> None:
    layout, behaviour = parts_of("trail", folder)
    simulation = Simulation(layout, behaviour)
    with pytest.raises(CommandError, match=re.escape(hint)):
        carried_out(simulation, {"set": {name: 1}})
    with pytest.raises(FaultError, match=re.escape(hint)):
        simulation.add_fault(Fault("stuck_bit", signal=name))
