"""How much room the C headers take: all of their functions at once, and the texts of codes.

`python benchmarks/c_size.py` prints rows; `--write` puts the table into docs/checked.md. It needs gcc and
gcc-arm-none-eabi.
A program has only the functions that it calls, so the numbers are the most that there can be.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from c_headers import needed, newest, version, write_headers
from rows import Row, printed

GROUP = "C, size"
MACHINES = {
    "Cortex-M0, -Os": ("arm-none-eabi-gcc", ["-Os", "-mcpu=cortex-m0", "-mthumb"]),
    "Cortex-M4, -Os": ("arm-none-eabi-gcc", ["-Os", "-mcpu=cortex-m4", "-mthumb"]),
    "Cortex-M4, -O2": ("arm-none-eabi-gcc", ["-O2", "-mcpu=cortex-m4", "-mthumb"]),
    "x86-64, -O2": ("gcc", ["-O2"]),
}
PACKAGES = {"arm-none-eabi-gcc": "gcc-arm-none-eabi", "gcc": "gcc"}
DOCUMENT = Path(__file__).resolve().parent.parent / "docs" / "checked.md"
BEGIN, END = "<!-- sizes -->\n", "<!-- end of sizes -->\n"


def size(folder: Path, header: str, machine: str, *more: str) -> int:
    """The bytes of code and of constants that all functions of a header have; none has variables."""
    compiler, flags = MACHINES[machine]
    source, target = folder / "size.c", str(folder / "size.o")
    source.write_text(f'#include "{header}"\n', encoding="utf-8")
    tool = needed(compiler, PACKAGES[compiler])
    options = ["-std=c99", "-ffreestanding", "-fkeep-inline-functions", "-fno-asynchronous-unwind-tables"]
    subprocess.run([tool, *options, *flags, *more, "-c", "-o", target, str(source)], check=True)
    sizes = subprocess.run(
        [tool.removesuffix("gcc") + "size", "--format=sysv", target], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    sizes_of = {line.split()[0]: int(line.split()[1]) for line in sizes if line.startswith(".")}
    assert not any(
        number for name, number in sizes_of.items() if name.startswith((".data", ".bss")) and ".rel" not in name
    )
    return sum(number for name, number in sizes_of.items() if name.startswith((".text", ".rodata", ".data.rel.ro")))


def measured() -> Iterator[tuple[str, str, int, int]]:
    """Of each device and machine the bytes of all functions, and those that the texts add."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        devices = newest()
        for device, header in write_headers(folder, devices).items():
            name = f"{devices[device].device.name} {devices[device].device.version}"
            texts = f"-D{device.replace('-', '_').upper()}_WITH_TEXTS"
            for machine in MACHINES:
                code = size(folder, header, machine)
                yield name, machine, code, size(folder, header, machine, texts) - code


def rows() -> Iterator[Row]:
    """The rows."""
    for device, machine, code, texts in measured():
        by = version(needed(MACHINES[machine][0], PACKAGES[MACHINES[machine][0]]))
        yield Row(GROUP, f"{device}, all functions, {machine}", by, code, 0, "bytes", 0)
        yield Row(GROUP, f"{device}, texts of codes, {machine}", by, texts, 0, "bytes", 0)


def table() -> str:
    """The table of the documentation."""
    cells: dict[str, dict[str, tuple[int, int]]] = {}
    for device, machine, code, texts in measured():
        cells.setdefault(device, {})[machine] = (code, texts)
    compilers = " and ".join(sorted({version(needed(tool, PACKAGES[tool])) for tool, _ in MACHINES.values()}))
    lines = [f"With {compilers}, in bytes:", "", f"| device | {' | '.join(MACHINES)} | texts of codes, Cortex-M0 |"]
    lines.append("|---" * (len(MACHINES) + 2) + "|")
    for device, sizes in cells.items():
        numbers = [f"{sizes[machine][0]:,}" for machine in MACHINES] + [f"{sizes['Cortex-M0, -Os'][1]:,}"]
        lines.append(f"| {device} | {' | '.join(numbers)} |")
    return "\n".join(lines) + "\n"


def main(arguments: Sequence[str] = ()) -> None:
    """Prints the rows, or writes the table."""
    if list(arguments) != ["--write"]:
        printed(rows())
        return
    text = DOCUMENT.read_text("utf-8")
    before, rest = text.split(BEGIN)
    DOCUMENT.write_text(before + BEGIN + table() + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
