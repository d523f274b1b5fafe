"""The generated decoders and framers take any bytes: a fixed share of what `make fuzz-bytes` tries."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from bounded import HANGING

sys.path.insert(0, str(Path(__file__).parent))

import noise
from targets import DEVICES, GENERATED, codec_error, seeds, targets

from external_tools import require_tool

INPUTS = 4000
TRUST = GENERATED.parent / "docs" / "trust.md"
STRONG = ("ck10", "tc100")
"""The devices whose frames all have a checksum of 16 bits, or one of eight over characters."""
PEAKS = """
import json, sys, noise
print(json.dumps({outcome.name: outcome.peak for outcome in noise.noise(sys.argv[1], 60_000)}))
"""


def damaged(chance: random.Random, frame: bytes) -> bytes:
    """A frame with some bytes changed, removed or added."""
    data = bytearray(frame)
    for _ in range(chance.randint(1, 4)):
        place = chance.randrange(len(data) + 1)
        data[place : place + chance.randrange(3)] = chance.randbytes(chance.randrange(3))
    return bytes(data)


@pytest.mark.proof(2)
@pytest.mark.parametrize("device", DEVICES)
def test_damaged_frames_give_values_or_the_documented_error(device: str) -> None:
    chance = random.Random(device)
    known = dict(targets(device))
    frames = list(seeds(device))
    for number in range(INPUTS):
        name, frame = chance.choice(frames)
        if number % 4 == 0:
            name = chance.choice(list(known))
        known[name](damaged(chance, frame))


@pytest.mark.parametrize("device", DEVICES)
def test_every_example_frame_belongs_to_a_target(device: str) -> None:
    known = dict(targets(device))
    assert len(known) > 100
    assert {name for name, _ in seeds(device)} <= known.keys()


@pytest.mark.parametrize("device", STRONG)
def test_a_decoder_that_raises_something_else_is_noticed(device: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(codec_error(), "__init__", lambda *_, **__: 1 / 0)
    name, frame = next(iter(seeds(device)))
    with pytest.raises(ZeroDivisionError):
        dict(targets(device))[name](frame[:-1])


@pytest.mark.parametrize("device", STRONG)
def test_no_inverted_bit_gives_other_values(device: str) -> None:
    for result in noise.flips(device):
        assert result.flips > 200
        assert result.unnoticed == result.same


def test_the_documentation_counts_what_checksums_cannot_notice() -> None:
    page = TRUST.read_text("utf-8")
    rows = [result.row() for device in DEVICES for result in noise.flips(device)]
    missing = [row for row in rows if row not in page]
    assert missing == []


@pytest.mark.proof(2)
@pytest.mark.parametrize("device", DEVICES)
def test_a_frame_behind_a_damaged_one_and_silence_is_returned(device: str) -> None:
    framed = noise.framed_flips(device)
    assert framed.tried > 1000
    assert framed.lost == 0
    if device in STRONG:
        assert framed.delayed == 0


@pytest.mark.proof(2)
@pytest.mark.parametrize("device", DEVICES)
def test_random_bytes_take_no_more_memory_than_a_frame_and_a_piece(device: str) -> None:
    # A process of its own: what other threads of the tests allocate counts too.
    call = [sys.executable, "-c", PEAKS, device]
    run = subprocess.run(call, capture_output=True, text=True, check=True, cwd=Path(__file__).parent, timeout=HANGING)
    peaks: dict[str, int] = json.loads(run.stdout)
    assert peaks
    assert [name for name, peak in peaks.items() if peak >= 8 * noise.PIECE] == []


@pytest.mark.proof(2)
@pytest.mark.parametrize("device", DEVICES)
def test_javascript_gives_values_or_the_documented_error(device: str) -> None:
    script = Path(__file__).with_name("noise.mjs")
    call = [require_tool("node"), "--expose-gc", str(script), str(GENERATED), device, "40000"]
    run = subprocess.run(call, capture_output=True, text=True, check=False, timeout=HANGING)
    assert run.returncode == 0, run.stdout + run.stderr
    outcome: dict[str, Any] = json.loads(run.stdout)
    assert outcome["refused"] < outcome["inputs"]
    assert outcome["targets"] > 100
