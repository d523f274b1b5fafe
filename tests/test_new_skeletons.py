"""A new device of each kind of frame is built and simulated at once, and each kind has a frame that is right."""

from __future__ import annotations

from pathlib import Path

import pytest
from crccheck.crc import CrcModbus, CrcX25

from fieldspec.cli import main
from fieldspec.command.verbs.new import SHAPES
from simulators import Unit, parts_of


def summed(text: str, mask: int = 0) -> str:
    """Bytes with the low byte of their sum, combined with a mask."""
    return f"{text} {sum(bytes.fromhex(text)) & 0xFF ^ mask:02X}"


def with_crc(text: str, crc: int) -> str:
    """Bytes with a CRC of two bytes, the low one first."""
    return f"{text} {crc.to_bytes(2, 'little').hex(' ').upper()}"


REQUESTS = {
    "modbus": with_crc("01 03 00 00 00 01", CrcModbus.calc(bytes.fromhex("010300000001"))),
    "packet": summed("04 01 53"),
    "text": b"W\r\n".hex(" ").upper(),
    "escapes": f"7E {with_crc('01 11', CrcX25.calc(bytes.fromhex('0111')))} 7E",
    "status": summed("01 10"),
    "bytes": f"FF FF {summed('01 04 02 2B 01', 0xFF)}",
    "can": "00 00 03 01 02 00 00 00 E8 03",
    "telegram": "00 01 20 00",
}
"""The first request of each kind, by algorithms that are not fieldspec's; identifiers on CAN are 0x6 * 128 + 1."""


@pytest.fixture(params=["modbus", *SHAPES])
def kind(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A kind of frame, with a new device of it in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FIELDSPEC_SPECS", raising=False)
    assert main(["new", "device", f"my-{request.param}", "--protocol", request.param]) == 0
    return str(request.param)


@pytest.mark.proof(4)
def test_a_new_device_is_built(kind: str) -> None:
    assert main(["build", f"my-{kind}"]) == 0
    assert Path(f"generated/python/fieldspec_devices/my_{kind}").is_dir()


def test_the_first_frame_of_a_new_device_is_right_and_its_simulator_answers_it(kind: str) -> None:
    folder = str(Path("specs").absolute())
    example = next(iter(parts_of(f"my-{kind}", folder)[0].device.examples.values()))
    assert example.frame.hex(" ").upper() == REQUESTS[kind]
    unit = Unit(f"my-{kind}", example.link, example.message, folder=folder)
    answer = unit.answer_to(example.frame)
    assert not unit.codec.decode(answer.frame, "response", example.message).error
