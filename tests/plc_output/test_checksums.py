"""The generated functions for the checksums of links build and judge frames as the reference does."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from comparisons import compare_requests, compare_responses
from compiled import Compiled
from proving import Proof
from st_machine import Machine
from st_syntax import parsed

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE
from fieldspec.targets.controllers.structured.program import program
from fieldspec.targets.iec.backend import source
from fieldspec.targets.iec.backend import text as standard_text
from fieldspec.targets.st.backend import text
from random_devices.agreement import layouts_of

DERIVED = (
    "{width: 8, method: xor}",
    "{width: 8, method: xor, initial: 0x5A, complement: ones}",
    "{width: 8, method: xor, complement: twos}",
    "{width: 8, method: sum, complement: ones}",
    "{width: 8, method: sum, initial: 0xFE, complement: twos}",
    "{width: 16, polynomial: 0x1021, initial: 0x1234, reflect_in: true, reflect_out: true, final_xor: 0xFF}",
    "{width: 8, polynomial: 0x9B, initial: 0xA5, final_xor: 0x0F}",
)
"""Checksums without a public name."""


def named() -> list[str]:
    """The CRCs of the catalogue with 8 and 16 bits that take and give the bits in one order."""
    names = [line.split()[0] for line in CRC_CATALOGUE.splitlines()]
    known = {name: checksum_named(name) for name in names}
    return [name for name, crc in known.items() if crc.width in (8, 16) and crc.reflect_in == crc.reflect_out]


def layout_of(checksums: list[str]) -> DeviceLayout:
    """A device with a link for each checksum, whose frames begin with a byte that is not covered."""
    parts = "{name: head, type: u8}, {name: code, role: code, type: u8}, {name: body, role: body}"
    links = "".join(
        f"  - {{name: link_{number}, source: 1 L1, byte_order: big, request: &parts_{number} [{parts}, {{name: check, "
        f"role: checksum, {checksum}, covers: {{from: code}}}}], response: *parts_{number}}}\n"
        for number, checksum in enumerate(checksums)
    )
    manual = "{title: T, file: t.txt, sha256: '" + "0" * 64 + "', lines: 9}"
    spec = (
        f"device: {{id: chance, name: C, vendor: N, manual: {manual}}}\nlinks:\n{links}messages:\n"
        "  - {name: move, code: 7, source: 1 L1, request: [{name: data, type: u8, repeat: 0..9}],"
        " response: [{name: state, type: u32}]}\n"
    )
    (layout,) = layouts_of(spec)
    return layout


def judge(prover: Proof) -> None:
    dice = random.Random(1)
    compare_requests(prover, dice, 8)
    refusals = compare_responses(prover, dice, 24)
    assert "wrong_checksum" in refusals


NAMED = [f"algorithm: {name}" for name in named()]
ALL = NAMED + [f"algorithm: {parameters}" for parameters in DERIVED]


@pytest.mark.parametrize("start", range(0, len(ALL), 20))
def test_functions_compute_checksums_as_the_reference_does(start: int) -> None:
    own = program(layout_of(ALL[start : start + 20]))
    judge(Proof(own.declared.world, Machine(parsed(text(own)))))


def test_compiled_functions_compute_checksums_as_the_reference_does(tmp_path: Path) -> None:
    own = source(layout_of(ALL[::7]))
    judge(Proof(own.declared.world, Compiled(standard_text(own), tmp_path)))
