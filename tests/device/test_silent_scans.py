"""Scans of devices that are silent at addresses that they do not have."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import simulation
from fieldspec.tools.live import scanning
from fieldspec.tools.live.client import NoAnswerError
from fieldspec.tools.live.scanning import ScannedItem, ScanSpace, scan
from layouts import TEST_SPECS, newest

FOLDER = str(TEST_SPECS)


class Device:
    """A silent device with some addresses, and a line that loses the first requests for one of them."""

    def __init__(self, addresses: set[int], lost: dict[tuple[int, int], int]) -> None:
        self.addresses, self.lost = addresses, lost
        self.requests: list[tuple[int, int]] = []

    def counts(self, client: Any, space: ScanSpace, part: range, retries: int | None) -> dict[int, tuple[int, ...]]:
        """The counts of all addresses of a part. Raises NoAnswerError."""
        place = part.start, len(part)
        for _ in range(1 if retries == 0 else 3):
            self.requests.append(place)
            self.lost[place] = self.lost.get(place, 0) - 1
            if self.lost[place] < 0 and self.addresses.issuperset(part):
                return dict.fromkeys(part, (0,))
        raise NoAnswerError("no answer")


def scanned(device: Device, known: range, monkeypatch: pytest.MonkeyPatch) -> set[int]:
    """The addresses that answer to a scan of 0 to 63 with a spec that knows some."""
    monkeypatch.setattr(scanning, "_counts", device.counts)
    monkeypatch.setattr(scanning, "known_bases", lambda client, layout: {})
    monkeypatch.setattr(scanning, "at_bases", lambda layout, bases: layout)
    monkeypatch.setattr(scanning, "scanned_items", lambda *_: [ScannedItem("own", known, True, False)])
    client: Any = type("Client", (), {"layout": newest(TEST_SPECS, "ladder")})()
    return set(scan(client, ScanSpace("", 64, 32), [range(64)]).words)


def test_addresses_that_the_spec_lacks_are_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    device = Device({0, 1, 2, 3, 40}, {})
    assert scanned(device, range(4), monkeypatch) == {0, 1, 2, 3, 40}
    assert [device.requests.count((address, 1)) for address in (10, 39, 63)] == [1, 1, 1]
    assert device.requests.count((0, 4)) == 1


def test_they_are_asked_again_if_the_line_loses_a_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    device = Device({0, 1, 2, 3, 40}, {(40, 1): 1, (3, 1): 1})
    assert scanned(device, range(4), monkeypatch) == {0, 1, 2, 3, 40}


def test_a_scan_of_registers_as_characters_asks_for_no_address_twice(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("ladder", ports={"area": "tcp://127.0.0.1:0"}, unit_address=3, folder=FOLDER) as device:
        more = ["--link", "area", "--port", device.place, "--unit", "3", "--specs", FOLDER, "--timeout", "0.05"]
        assert main(["scan", "ladder", "0..0x1F", "--trace", *more]) == 0
    lines = [line for line in capsys.readouterr().err.splitlines() if line.startswith("request")]
    assert len(lines) < 70
    assert len([line for line in lines if "52 52 30 30 32 30 30 30 30 31" in line]) == 1
