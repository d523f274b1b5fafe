"""A hundred thousand lines of nonsense are refused in seconds, with a number of findings that a person can read."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from bounded import HANGING, limits
from proofs import IS_WHOLE
from spec_files import DEVICE

LINES = 100_000 if IS_WHOLE else 30_000
SECONDS = 60
"""Far above the ten seconds of a processor that it takes; far below the time of a loop within a loop."""

MOST = 1500
CHANCE = random.Random(1)
TEXT = [chr(code) for code in range(32, 1200)]
WORDS = ["foo", "bar:", "- x", "{", "}", '"q', "*a", "&b", "[1", "device:", "registers:", "rows:", "at: 1"]


def rows(row: Callable[[int], str]) -> bytes:
    """A device with a group of as many registers."""
    lines = [f"    - {{at: {number % 65536}, name: r{number}, {row(number)}}}" for number in range(LINES)]
    return (DEVICE + "registers:\n  - group: a\n    rows:\n" + "\n".join(lines) + "\n").encode()


NONSENSE = {
    "words": lambda: "\n".join(" ".join(CHANCE.choices(WORDS, k=6)) for _ in range(LINES)).encode(),
    "random bytes": lambda: b"\n".join(CHANCE.randbytes(40) for _ in range(LINES)),
    "random text": lambda: "\n".join("".join(CHANCE.choices(TEXT, k=40)) for _ in range(LINES)).encode(),
    "one long text": lambda: b"lorem ipsum\n" * LINES,
    "unknown keys": lambda: "".join(f"key{number}: {number}\n" for number in range(LINES)).encode(),
    "one key": lambda: b"registers: []\n" * LINES,
    "open brackets": lambda: b"[\n" * LINES,
    "documents": lambda: b"---\n" * LINES,
    "tabs": lambda: b"\ta: b\n" * LINES,
    "rows with a wrong key each": lambda: rows(lambda number: f"type: u16, source: L{number % 900 + 1}, acess: rw"),
    "rows without a type": lambda: rows(lambda number: "access: ro"),
}


def bounded_run(command: list[str]) -> subprocess.CompletedProcess[str]:
    """Runs a command in bounded time of a processor."""
    return subprocess.run(
        command, preexec_fn=limits(SECONDS), capture_output=True, text=True, encoding="utf-8", timeout=HANGING
    )


@pytest.mark.proof
@pytest.mark.parametrize("make", NONSENSE.values(), ids=NONSENSE)
def test_nonsense_is_refused_in_seconds(make: Callable[[], bytes], tmp_path: Path) -> None:
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_bytes(make())
    check = [sys.executable, "-m", "fieldspec", "check", "--format", "json", "--specs", str(tmp_path)]
    ran = bounded_run(check)
    assert (ran.returncode, ran.stderr) == (1, "")
    assert 1 <= len(json.loads(ran.stdout)) <= MOST
    assert len(ran.stdout) < 2_000_000


@pytest.mark.proof
def test_a_device_with_a_register_at_every_address_is_read(tmp_path: Path) -> None:
    row = (
        "    - {at: %d, name: r%d, doc: Value %d of all., type: u16, access: rw, range: 0..9, default: 0, source: 1 L1}"
    )
    every = "\n".join(row % (at, at, at) + " # as the manual has it" for at in range(0x10000 if IS_WHOLE else 0x4000))
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_text(f"{DEVICE}registers:\n  - group: a\n    rows:\n{every}\n", "utf-8")
    check = [sys.executable, "-m", "fieldspec", "check", "--specs", str(tmp_path)]
    ran = bounded_run(check)
    assert (ran.returncode, ran.stderr) == (0, "")
