"""The C headers, read by compilers with all their warnings, for several machines and standards, and by cppcheck."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import STRICT, require_tool
from headers import DEVICES, write_newest

from fieldspec.foundation.names import stem
from proofs import IS_WHOLE

# Padding depends on the machine; the other warning says that the linker of a machine may lack a library.
EVERYTHING = ["-Weverything", "-Wno-padded", "-Wno-unknown-warning-option", "-Wno-avr-rtlib-linking-quirks"]
FREESTANDING = "-ffreestanding"
MACHINES = {
    "this machine": [],
    "Cortex-M0": ["--target=thumbv6m-none-eabi", FREESTANDING],
    "PowerPC, big-endian": ["--target=powerpc-none-eabi", FREESTANDING],
    "AVR, int of 16 bits": ["--target=avr", FREESTANDING],
    "MSP430, int of 16 bits": ["--target=msp430-none-elf", FREESTANDING],
}
# The oldest and the newest; with C++11 the self-tests are compiled and run.
STANDARDS = {"c++98": "g++", "c++20": "clang++"}

# A header is a library: programs use its structs. Variables stand where functions begin.
UNMINDED = ["unusedStructMember", "variableScope"]


@pytest.fixture(params=sorted(DEVICES))
def source(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """The self-test of a device, beside its header."""
    layout = DEVICES[request.param]
    write_newest(request.param, tmp_path)
    return tmp_path / f"{stem(layout.device.id, layout.device.version)}_selftest.c"


def complaints(command: list[str]) -> str:
    """The beginning of the messages of a tool."""
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    return (result.stdout + result.stderr)[:4000] or (
        "" if result.returncode == 0 else f"exit code {result.returncode}"
    )


@pytest.mark.proof(31)
@pytest.mark.parametrize("machine", MACHINES)
def test_clang_gives_no_warning(source: Path, machine: str) -> None:
    command = [require_tool("clang"), "-std=c99", *EVERYTHING, *MACHINES[machine], "-fsyntax-only", str(source)]
    assert complaints(command) == ""


@pytest.mark.proof(13)
@pytest.mark.parametrize("standard", STANDARDS)
def test_every_standard_of_cpp_accepts_the_header(source: Path, standard: str) -> None:
    command = [
        require_tool(STANDARDS[standard]),
        f"-std={standard}",
        "-x",
        "c++",
        *STRICT,
        "-fsyntax-only",
        str(source),
    ]
    assert complaints(command) == ""


@pytest.mark.proof
@pytest.mark.parametrize("source", sorted(DEVICES) if IS_WHOLE else ["turret", "widget"], indirect=True)
def test_cppcheck_finds_nothing(source: Path) -> None:
    header = str(source).replace("_selftest.c", ".h")
    command = [
        require_tool(str(Path(sys.executable).with_name("cppcheck"))),
        "--enable=warning,style,performance,portability",
    ]
    command += ["--inconclusive", "--std=c99", "--language=c", "--quiet", "--error-exitcode=1"]
    assert complaints([*command, *(f"--suppress={name}" for name in UNMINDED), header]) == ""


def test_cppcheck_finds_a_read_past_the_end(tmp_path: Path) -> None:
    (tmp_path / "wrong.h").write_text(
        "static int last(void) { int all[2] = {1, 2}; return all[2]; }\n", encoding="utf-8"
    )
    tool = require_tool(str(Path(sys.executable).with_name("cppcheck")))
    assert "arrayIndexOutOfBounds" in complaints([tool, "--language=c", "--quiet", str(tmp_path / "wrong.h")])
