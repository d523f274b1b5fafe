"""The first contact with a device: with its factory settings, and with a device that has others."""

from __future__ import annotations

import json
from argparse import Namespace
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.command.live.finding import settings, units
from fieldspec.testing import simulation
from simulators import SPECS, parts_of

FRAME_OF_THE_MANUAL = b":010320000002DA\r\n"
"""A read of 2000H and 2001H by Modbus ASCII; the protocol that 5.8 L1275 of the manual of the TC100 calls initial."""


def live(place: str, *arguments: str) -> int:
    place = place.replace("tcp://", "socket://")
    return main(["live", *arguments, "--port", place, "--specs", SPECS])


def test_a_simulated_device_has_the_protocol_that_the_manual_calls_initial() -> None:
    import serial

    with simulation("tc100", folder=SPECS) as device, serial.Serial(device.place, 19200, timeout=2) as port:
        assert list(device.places) == ["ascii"]
        port.write(FRAME_OF_THE_MANUAL)
        assert port.read_until(b"\n").startswith(b":010304")


def test_live_speaks_the_factory_settings_and_says_which(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("tc100", folder=SPECS) as device:
        assert live(device.place, "tc100", "read", "motion_speed") == 0
    assert capsys.readouterr().err == "tc100: link ascii, unit address 1\n"


def test_a_generated_client_has_the_link_of_the_factory_settings() -> None:
    text = (Path(SPECS).parent / "generated/python/fieldspec_devices/tc100/v2_0_client.py").read_text("utf-8")
    assert "link: _Literal['rtu', 'ascii'] = 'ascii'" in text.replace('"', "'")


def test_where_nothing_answers_live_says_which_other_settings_there_are(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("tc100", ports={"rtu": "pty"}, folder=SPECS) as device:
        code = live(device.place, "tc100", "read", "motion_speed", "--timeout", "0.1", "--retries", "0")
        place = device.place
    assert code == 1
    assert capsys.readouterr().err.splitlines() == [
        "tc100: link ascii, unit address 1",
        "fieldspec: tc100: no answer from unit 1 on ascii",
        "tc100 can also be set to: link rtu; unit address 1..16",
        f"try: fieldspec live tc100 read motion_speed --port {place} --link rtu",
        f"try all settings: fieldspec live tc100 find --port {place}",
    ]


def test_find_says_the_link_and_the_unit_address_that_answer(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("tc100", ports={"rtu": "pty"}, unit_address=3, folder=SPECS) as device:
        requests: list[bytes] = []
        device.simulation.listeners.append(lambda now, link, way, data, text: requests.append(data))
        assert live(device.place, "tc100", "find", "--format", "json", "--timeout", "0.05") == 0
        assert live(device.place, "tc100", "find", "--timeout", "0.05") == 0
    out, err = capsys.readouterr()
    data = json.loads(out[: out.index("]") + 1])
    assert [(row["link"], row["unit"]) for row in data] == [("rtu", 3)]
    assert f"use it: fieldspec live tc100 read --port {device.place} --link rtu --unit 3" in err


def test_find_only_reads() -> None:
    with simulation("tc100", ports={"rtu": "pty"}, unit_address=2, folder=SPECS) as device:
        requests: list[bytes] = []
        device.simulation.listeners.append(
            lambda now, link, way, data, text: requests.append(data) if way == "request" else None
        )
        live(device.place, "tc100", "find", "--link", "rtu", "--timeout", "0.05")
    assert {frame[1] for frame in requests if frame[0] == 2} == {3}


def test_find_says_what_to_check_where_nothing_answers(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("tc100", ports={"rtu": "pty"}, unit_address=3, folder=SPECS) as device:
        assert live(device.place, "tc100", "find", "--unit", "2", "--timeout", "0.05") == 1
    assert "no answer to 2 attempts" in capsys.readouterr().err


def test_find_tries_every_rate_number_of_data_bits_and_parity_of_a_serial_port() -> None:
    layout, _ = parts_of("tc100")
    free = Namespace(port="/dev/ttyUSB0", link=None, baud=None, data_bits=None, parity=None)
    tried = [(own.link.name, own.baud, own.data_bits, own.parity) for own in settings(layout, free)]
    assert tried[0] == ("ascii", 19200, 8, "none")
    assert len(set(tried)) == len(tried) == 5 * 2 * 3 + 5 * 3


UNITS = [
    ({}, None, [3, 1, 2, *range(4, 17)]),
    ({"broadcast": 2}, None, [3, 1, *range(4, 17)]),
    ({"ranges": None}, None, [3, 1, 2, *range(4, 248)]),
    ({}, 7, [7]),
]


@pytest.mark.parametrize(("changes", "requested", "expected"), UNITS)
def test_find_tries_the_usual_unit_address_and_then_all_others_that_the_link_has(
    changes: dict[str, Any], requested: int | None, expected: list[int]
) -> None:
    link = parts_of("tc100")[0].links["rtu"]
    assert link.link.unit_addresses is not None
    changed = replace(link, link=replace(link.link, unit_addresses=replace(link.link.unit_addresses, **changes)))
    assert units(changed, Namespace(unit=requested), 3) == expected


def test_find_tries_all_unit_addresses_of_a_link_that_states_none() -> None:
    link = parts_of("tc100")[0].links["rtu"]
    changed = replace(link, link=replace(link.link, unit_addresses=None))
    assert units(changed, Namespace(unit=None), 3) == [3, 1, 2, *range(4, 248)]
