"""What is generated for each device, loaded into machines once."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from proving import REASONS, Proof
from st_machine import Machine
from st_syntax import parsed

from fieldspec.backends.st.backend import text
from fieldspec.plc.structured.program import Program, program
from fieldspec.reference import CodecError
from laid_out import MADE_UP, SPECS, newest

REAL = ["ck10", "esc11", "hiwin-e", "tc100"]
MADE = ["gadget", "gizmo", "glider-x", "widget"]
DEVICES = [*((SPECS, device) for device in REAL), *((MADE_UP, device) for device in MADE)]
NAMES = [device for _, device in DEVICES]
ROUNDINGS = ("even", "away", "cut")
"""How controllers make a whole number of a fraction; the functions must not depend on it."""


@cache
def proof(root: Path, device: str, rounding: str = "even") -> Proof:
    """The newest version of a device, ready to run."""
    made = made_of(root, device)
    return Proof(made.declared.world, Machine(parsed(text(made)), rounding))


@cache
def made_of(root: Path, device: str) -> Program:
    """The newest version of a device as a program."""
    return program(newest(root, device))


def reason(error: CodecError) -> str:
    """The status of what the reference refuses."""
    return REASONS.get(error.reason, error.reason)


def held_in(frame: bytes, unit: str, order: str) -> list[int]:
    """Bytes of the wire as the array that a function takes."""
    if unit == "bytes":
        return list(frame)
    return [int.from_bytes(frame[at : at + 2], order) for at in range(0, len(frame), 2)]  # type: ignore[arg-type]


def judged(status: str, error: CodecError, about: object) -> None:
    """The status must say what the reference refuses."""
    assert status == reason(error), (about, error)
