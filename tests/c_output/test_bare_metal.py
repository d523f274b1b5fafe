"""The C headers without an operating system: small, big-endian and 64-bit machines, and int of 16 bits.

Whatever an emulator can run is run: the self-test that is generated with each header, without any library.
"""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from bounded import HANGING

sys.path.insert(0, str(Path(__file__).parent))

from compilers import STRICT, require_tool
from headers import DEVICES, write_newest

from example_counts import FACTOR
from fieldspec.foundation.names import Name, stem
from layouts import SPECS, TEST_SPECS, layouts

BARE = Path(__file__).parent / "bare"
STEMS = {name: stem(name, layout.device.version) for name, layout in DEVICES.items()}


@dataclass(frozen=True)
class Machine:
    """A machine: how a program for it is compiled, linked and run."""

    compiler: str
    flags: tuple[str, ...]
    linking: tuple[str, ...]
    emulator: tuple[str, ...]


# The emulated machine has a Cortex-M3, set to trap unaligned accesses as a Cortex-M0 does.
BOARD = ("-M", "mps2-an385", "-nographic", "-monitor", "none", "-serial", "none")
BOARD += ("-semihosting-config", "enable=on,target=native")
LINUX = ("-static", "-Wl,-estart")
MACHINES = {
    "Cortex-M0": Machine(
        "arm-none-eabi-gcc",
        ("-Os", "-mcpu=cortex-m0", "-mthumb"),
        (f"-T{BARE / 'cortex_m.ld'}",),
        ("qemu-system-arm", *BOARD, "-kernel"),
    ),
    "big-endian, 32 bits": Machine("m68k-linux-gnu-gcc", ("-Os",), LINUX, ("qemu-m68k",)),
    "int of 16 bits": Machine(
        "m68k-linux-gnu-gcc",
        # The disabled passes fail where int has 16 bits.
        ("-O1", "-fno-ivopts", "-fno-tree-slsr", "-mshort", "-include", str(BARE / "short_int.h")),
        LINUX,
        ("qemu-m68k",),
    ),
    "64 bits": Machine("aarch64-linux-gnu-gcc", ("-O1",), LINUX, ("qemu-aarch64",)),
}


def run(machine: Machine, folder: Path, device: str, *more: str) -> subprocess.CompletedProcess[str]:
    """Compiles the self-test of a device without a library, and runs it."""
    write_newest(device, folder)
    test = f"-DSELFTEST={Name.of(device).snake()}_selftest"
    return run_again(machine, folder, folder / f"{STEMS[device]}_selftest.c", test, *more)


def run_again(machine: Machine, folder: Path, source: Path, *more: str) -> subprocess.CompletedProcess[str]:
    """Compiles a self-test beside its header and runs it."""
    compiler = [require_tool(machine.compiler), "-ffreestanding", *machine.flags, *more]
    objects = []
    for file, standard in ((source, ["-std=c99", *STRICT]), (BARE / "start.c", ["-std=gnu99"])):
        objects.append(str(folder / f"{file.stem}.o"))
        build = subprocess.run(
            [*compiler, *standard, "-c", "-o", objects[-1], str(file)], capture_output=True, text=True, check=False
        )
        assert build.returncode == 0, build.stderr[:4000]
    program = str(folder / "program")
    linked = [*compiler, "-nostdlib", *machine.linking, *objects, "-lgcc", "-o", program]
    subprocess.run(linked, check=True, capture_output=True)
    emulator = [require_tool(machine.emulator[0]), *machine.emulator[1:], program]
    return subprocess.run(emulator, capture_output=True, text=True, check=False, timeout=HANGING)


# Made-up devices have features that real ones lack: floats, swapped words, choices. One machine is enough for them; it
# runs all of them in the nights.
TEST_DEVICES = (
    list(layouts(TEST_SPECS)) if FACTOR > 1 else ["caller", "compass", "gadget", "glider-x", "meter", "widget"]
)
CASES = [(device, machine) for device in layouts(SPECS) for machine in MACHINES]
CASES += [(device, "big-endian, 32 bits") for device in TEST_DEVICES]
CASES += [(device, "int of 16 bits") for device in ("widget", "glider-x", "compass")]


@pytest.mark.proof(2)
@pytest.mark.parametrize(("device", "machine"), CASES)
def test_the_self_test_passes_without_an_operating_system(device: str, machine: str, tmp_path: Path) -> None:
    result = run(MACHINES[machine], tmp_path, device)
    assert (result.returncode, result.stdout + result.stderr) == (0, "")


def test_an_unaligned_access_is_trapped(tmp_path: Path) -> None:
    result = run(MACHINES["Cortex-M0"], tmp_path, "esc11", "-DUNALIGNED_ON_PURPOSE")
    assert result.returncode == 2
    assert "unaligned" in result.stdout + result.stderr


def test_stores_in_the_byte_order_of_the_machine_fail_the_self_test(tmp_path: Path) -> None:
    result = run(MACHINES["big-endian, 32 bits"], tmp_path, "esc11", "-DESC11_STORES_AT_ONCE")
    assert result.returncode == 1
    assert result.stdout.startswith("failed: ")


@pytest.mark.proof(1)
@pytest.mark.parametrize("optimized", ["-O2", "-Os"])
@pytest.mark.parametrize("device", ["ck10", "hiwin-e"])
def test_no_number_needs_a_function_of_the_library(device: str, optimized: str, tmp_path: Path) -> None:
    assert [name for name in called(device, tmp_path, optimized) if "mem" in name] == []


def test_stores_of_whole_numbers_would_call_functions_of_the_library(tmp_path: Path) -> None:
    assert "memcpy" in called("ck10", tmp_path, "-O2", "-DCK10_STORES_AT_ONCE")


def called(device: str, folder: Path, *flags: str) -> list[str]:
    """The external functions that the functions of a header call on a Cortex-M0+."""
    write_newest(device, folder)
    (folder / "all.c").write_text(f'#include "{STEMS[device]}.h"\n', encoding="utf-8")
    machine = ["-std=c99", "-ffreestanding", "-mcpu=cortex-m0plus", "-mthumb", "-fkeep-inline-functions"]
    arguments = [str(folder / "all.c"), "-c", "-o", str(folder / "all.o")]
    subprocess.run([require_tool("arm-none-eabi-gcc"), *machine, *flags, *arguments], check=True)
    tool = [require_tool("arm-none-eabi-nm"), "--undefined-only", "--format=just-symbols", str(folder / "all.o")]
    return subprocess.run(tool, capture_output=True, text=True, check=True).stdout.split()
