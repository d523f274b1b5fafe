"""Devices of messages alone: what simulators recognise and say, and what `live` reads, leaves out and prints."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts, load
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.testing import simulation
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from fieldspec.tools.simulator.simulation import usual_place

SPEC = """
device:
  id: sounder
  name: Sounder
  vendor: Nobody
  manual: {title: The manual of a sounder, file: sounder.txt, sha256: "%s", lines: 99}
links:
  - name: text
    transmission: binary
    byte_order: big
    end: "0A"
    source: 1 L1
    request: [{name: body, role: body}]
    response: [{name: body, role: body}]
  - name: line
    transmission: binary
    byte_order: big
    source: 1 L2
    request: &line
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *line
messages:
  - name: identify
    source: 2 L1
    links: [text]
    request: [{name: head, type: u16, const: 0x493F}]
    response: [{name: key, type: bytes, length: 2}]
  - name: hush
    source: 2 L2
    links: [text]
    request: [{name: head, type: u16, const: 0x4821}]
    response: [{name: seconds, type: u8}]
  - {name: ping, code: 1, links: [line], source: 2 L3, request: [], response: [{name: seconds, type: u8, unit: s}]}
  - name: read_depth
    code: 2
    links: [line]
    source: 2 L4
    request: []
    response: [{name: depth, type: u16, roles: actual_position, unit: mm}, {name: echoes, type: u8, count: 2}]
  - {name: stop, code: 3, links: [line], roles: stop, source: 2 L5, request: [], response: [{name: depth, type: u16, roles: actual_position}]}
  - {name: tune, code: 4, links: [line], source: 2 L6, request: [{name: gain, type: u8}], response: [{name: gain, type: u8}]}
  - {name: list_echoes, code: 5, links: [line], source: 2 L7, request: [], response: [{name: echoes, type: u8, repeat: 0..4}]}
"""  # noqa: E501
TEXT = SPEC.replace("%s", "1" * 64)


class Device(NamedTuple):
    """A simulated device: the folder of its spec, and its place by link."""

    folder: str
    places: dict[str, str]

    def live(self, link: str, *arguments: str) -> int:
        """The exit code of `live` on a link."""
        more = ["--link", link, "--port", self.places[link], "--specs", self.folder, "--timeout", "0.5"]
        return main(["live", "sounder", *arguments, *more])


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return layouts(load({"sounder/device.yaml": TEXT.encode()}).devices["sounder"])[0]


@pytest.fixture(scope="module")
def device(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Device]:
    folder: Path = tmp_path_factory.mktemp("specs")
    (folder / "sounder").mkdir()
    (folder / "sounder" / "device.yaml").write_text(TEXT, encoding="utf-8")
    places = {"text": "tcp://127.0.0.1:0", "line": "tcp://127.0.0.1:0"}
    with simulation("sounder", ports=places, folder=str(folder)) as running:
        yield Device(str(folder), dict(running.places))


def test_a_link_with_a_delimiter_is_served_as_a_stream(layout: DeviceLayout) -> None:
    assert usual_place(layout.links["text"]).startswith("tcp://")


def test_a_request_without_a_code_is_the_only_message_that_its_bytes_fit(layout: DeviceLayout) -> None:
    server, reasons = Server(Engine(layout, Behaviour(()))), []
    server.complain = reasons.append
    assert server.answer("text", b"I?\n").frame == b"\0\0\n"
    assert server.answer("text", b"??\n").frame == b""
    assert [reason.split("; ")[0] for reason in reasons] == [
        "text: refused, unknown_code: its bytes fit no message, or several"
    ]


def test_a_refusal_by_a_fault_is_told_where_the_device_cannot_answer_it(layout: DeviceLayout) -> None:
    server, reasons = Server(Engine(layout, Behaviour(()))), []
    server.complain = reasons.append
    assert server.answer("line", b"\x01\x01", forced="busy").frame == b""
    assert reasons == ["line: refused, busy: by a fault; the device is silent, as no `refuse` says what it answers"]


def test_without_names_only_what_the_spec_shows_to_read_is_asked(
    device: Device, capsys: pytest.CaptureFixture[str]
) -> None:
    assert device.live("line", "read", "--trace") == 0
    output = capsys.readouterr()
    assert [line.split()[0] for line in output.out.splitlines()[1:]] == ["read_depth.depth"]
    assert [line for line in output.err.splitlines() if line.startswith("request")] == ["request 02 02"]
    assert "only read: ping, stop" in output.err
    assert "lists and records, which are for the generated client: read_depth.echoes, list_echoes.echoes" in output.err


def test_bytes_are_printed_as_hexadecimal_numbers(device: Device, capsys: pytest.CaptureFixture[str]) -> None:
    assert device.live("text", "read", "identify") == 0
    assert capsys.readouterr().out.splitlines()[1].split() == ["identify.key", "00", "00"]


@pytest.mark.parametrize(
    ("link", "name", "expected"),
    [
        ("line", "tune", "tune asks with gain, and `live` sends no arguments"),
        ("line", "list_echoes", "list_echoes answers with lists and records only"),
        ("line", "read_depth.echoes", "read_depth.echoes is a list or a record"),
        ("line", "nonsense", "there is no value nonsense"),
        ("text", "", "name what to read; not asked without their names"),
    ],
)
def test_what_is_not_read_is_named_with_the_reason(
    device: Device, capsys: pytest.CaptureFixture[str], link: str, name: str, expected: str
) -> None:
    assert device.live(link, "read", *name.split()) == 2
    assert expected in capsys.readouterr().err


def test_a_device_without_cyclic_messages_has_none_to_choose(
    device: Device, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["simulate", "sounder", "--message", "identify", "--specs", device.folder]) == 2
    assert "sounder exchanges nothing cyclically" in capsys.readouterr().err
