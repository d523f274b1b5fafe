"""What is generated for each device, loaded into machines once."""

from __future__ import annotations

import os
import sys
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiled import Compiled
from proving import REASONS, Proof
from st_machine import Machine
from st_syntax import parsed

from fieldspec.codec.reference import CodecError
from fieldspec.targets.controllers.structured.program import Program, program
from fieldspec.targets.iec.backend import source
from fieldspec.targets.iec.backend import text as standard_text
from fieldspec.targets.st.backend import text
from layouts import SPECS, TEST_SPECS, newest
from proofs import share

REAL = ["tc100", "esc11", "hiwin-e", "ck10"]
"""The one with the least to generate is first, which is what a share of a proof has."""
TEST_DEVICES = ["compass", "gadget", "gizmo", "glider-x", "grinder", "meter", "station", "widget"]
DEVICES = [*((SPECS, device) for device in REAL), *((TEST_SPECS, device) for device in TEST_DEVICES)]
NAMES = [device for _, device in DEVICES]
COMPILED = share(NAMES, 6)
WAYS = [
    (root, device, way)
    for root, device in DEVICES
    for way in ("interpreted", "compiled")
    if way == "interpreted" or device in COMPILED
]
"""Every device by both ways: Structured Text by our interpreter, and the standard's dialect by matiec and gcc.

A run that is not a whole proof compiles for a share of the devices.
"""
WAY_NAMES = [f"{device}-{way}" for _, device, way in WAYS]
ROUNDINGS = ("even", "away", "cut")
"""How controllers make a whole number of a fraction; the functions must not depend on it."""
COMPUTING = (*ROUNDINGS, "compiled")
"""The interpreter with each of them, and the compiled code with its own."""


@cache
def proof(root: Path, device: str, rounding: str = "even") -> Proof:
    """The newest version of a device, ready to run."""
    program = program_of(root, device)
    return Proof(program.declared.world, Machine(parsed(text(program)), rounding))


@cache
def compiled_proof(root: Path, device: str, folder: Path) -> Proof:
    """The newest version of a device in the standard's dialect, compiled; programs are kept in a folder."""
    source_text = source(newest(root, device))
    return Proof(source_text.declared.world, Compiled(standard_text(source_text), folder))


def proof_by(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """The device of a test, by the way that its parameter names."""
    root, device, way = request.param
    return proof(root, device) if way == "interpreted" else compiled_proof(root, device, programs(tmp_path_factory))


def computing(root: Path, device: str, way: str, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """A device by one of the ways of computing."""
    if way == "compiled":
        return compiled_proof(root, device, programs(tmp_path_factory))
    return proof(root, device, way)


def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of compiled programs, which all processes of a run have in common."""
    base = tmp_path_factory.getbasetemp()
    return (base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base) / "compiled"


@cache
def program_of(root: Path, device: str) -> Program:
    """The newest version of a device as a program."""
    return program(newest(root, device))


def reason(error: CodecError) -> str:
    """The status of what the reference refuses."""
    return REASONS.get(error.reason, error.reason)


def words_in(frame: bytes, unit: str, order: str) -> list[int]:
    """Bytes of the wire as the array that a function takes."""
    if unit == "bytes":
        return list(frame)
    return [int.from_bytes(frame[at : at + 2], order) for at in range(0, len(frame), 2)]  # type: ignore[arg-type]


def judged(status: str, error: CodecError, about: object) -> None:
    """The status must say what the reference refuses."""
    assert status == reason(error), (status, about, error)
