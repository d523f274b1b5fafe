"""A simulated device tells the version that it is simulated in, by the value that a program detects it by."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from fieldspec.codec.layout.detection import version_detection
from fieldspec.foundation.runtime._firmware import module_name, version_in
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.reported_version import reported_version
from layouts import layout_at

SPEC = """
device:
  id: mill
  name: Mill
  vendor: Test
  manual: {title: m, file: m.txt, sha256: "%s", lines: 900}
versions:
  - line: firmware
    builds: true
    detected_by: {fact: FACT, KEYS}
    members: [MEMBERS]
links:
  - name: bus
    source: 1 L1
    transmission: binary
    byte_order: big
    request: &parts [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: *parts
    silence: {characters: 4, source: 1 L1}
    serial: {baud: [9600], data_bits: [8], parity: [none], stop_bits: [1], source: 1 L1}
registers:
  - {group: all, source: L1, rows: [{name: firmware, at: 1, TYPE, access: ro}]}
messages:
  - {name: identify, code: 1, source: 1 L1, request: [], response: [{name: firmware, TYPE}]}
""" % ("1" * 64)

FORMS = [
    ("type: u16", "form: decimal, places: 2", ("0.07", "2.1", "2.80", "12.12")),
    ("type: u16", "form: hexadecimal, places: 2", ("before-2.80", "2.80", "12.12")),
    ("type: u16", "form: bytes", ("2.1", "12.12")),
    ("type: u16", "form: decimal", ("7", "12")),
    ("type: u16", "doc: Each has a number.", ("a=[7]", "b=[3, 4]")),
    ("type: text, length: 12", "doc: A text.", ("before-2.1", "2.1", "12.12")),
]


def spec_of(fact: str, kind: str, keys: str, versions: Sequence[str]) -> DeviceSpec:
    """A device whose version is in a value; a version may have the values that tell it after a mark."""
    members = []
    for version in versions:
        name, mark, values = version.partition("=")
        values_text = f", detected_as: {values}" if mark else ""
        members.append(f'{{id: "{name}", source: L1{values_text}}}')
    text = SPEC.replace("FACT", fact).replace("KEYS", keys).replace("MEMBERS", ", ".join(members))
    return read({"mill/device.yaml": text.replace("TYPE", kind).encode()}).devices["mill"]


@pytest.mark.parametrize("fact", ["registers/firmware", "messages/identify/response/firmware"])
@pytest.mark.parametrize(("kind", "keys", "versions"), FORMS)
def test_the_value_that_is_read_tells_the_version(fact: str, kind: str, keys: str, versions: Sequence[str]) -> None:
    spec = spec_of(fact, kind, keys, versions)
    names = [version.partition("=")[0] for version in versions]
    for version in names:
        layout = layout_at(spec, version)
        engine = Engine(layout, behaviour_of(spec.tree_at(version)))
        raw = engine.cells.of(fact)[0].read()
        value = raw.decode("ascii") if isinstance(raw, bytes) else raw
        how = version_detection(layout.device)
        assert how is not None
        assert isinstance(value, int | str)
        read_version = version_in(((),), value, how.form, how.places, dict(how.named))
        assert module_name((tuple((name, name) for name in names),), read_version, False) == version


def test_a_default_of_another_version_gives_way() -> None:
    spec = spec_of("registers/firmware", "type: u16, default: 5", "form: decimal, places: 2", ("1.00", "1.20"))
    layout, behaviour = layout_at(spec, "1.20"), behaviour_of(spec.tree_at("1.20"))
    reported = reported_version(layout, behaviour)
    assert reported is not None
    assert reported.text == "registers/firmware is 120, which identifies the version 1.20"


def test_a_number_whose_form_is_not_known_stays_as_it_is() -> None:
    spec = spec_of("registers/firmware", "type: u16", "doc: No form is printed.", ("1.00", "1.20"))
    layout = layout_at(spec, "1.20")
    assert reported_version(layout, behaviour_of(spec.tree_at("1.20"))) is None
