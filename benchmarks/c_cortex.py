"""The C header on Cortex-M4 and M0+: instructions of the functions, which have no loops, and calls for single values.

`python benchmarks/c_cortex.py`. Needs gcc-arm-none-eabi. The goals are those of the best form by hand: loads that the
compiler joins, stores at once where the machine may; on a Cortex-M0+ bytes one by one, for it cannot do otherwise.
"""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from c_headers import Subject, instructions, needed, newest, subjects, version, write_headers
from rows import Row, printed

GROUP = "C, Cortex-M"
PACKAGE = "gcc-arm-none-eabi"
BEST = {"point": (64, 67)}
"""Of reading and of writing the point record; other records are telegrams."""
TELEGRAM = (31, 31)
FORM = """
void {p}_read(const uint8_t *in, {p} *out) {{ {p}_unpack(in, out); }}
void {p}_write(const {p} *in, uint8_t *out) {{ {p}_pack(in, out); }}
"""


def compiled(folder: Path, subjects: list[Subject], machine: str) -> Path:
    """An object with a function for each direction of each record."""
    headers = "".join(f'#include "{header}"\n' for header in dict.fromkeys(subject.header for subject in subjects))
    (folder / "cortex.c").write_text(
        headers + "".join(FORM.format(p=subject.prefix) for subject in subjects), encoding="utf-8"
    )
    target = folder / f"{machine}.o"
    flags = ["-std=c99", "-O2", "-ffreestanding", "-mthumb", f"-mcpu={machine}"]
    gcc = needed("arm-none-eabi-gcc", PACKAGE)
    subprocess.run([gcc, *flags, "-c", "-o", str(target), str(folder / "cortex.c")], check=True)
    return target


def rows() -> Iterator[Row]:
    """The rows."""
    gcc, objdump = needed("arm-none-eabi-gcc", PACKAGE), needed("arm-none-eabi-objdump", PACKAGE)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        devices = newest()
        all_subjects = subjects(devices, write_headers(folder, devices))
        large, _ = instructions(objdump, compiled(folder, all_subjects, "cortex-m4"))
        small, calls = instructions(objdump, compiled(folder, all_subjects, "cortex-m0plus"))
    by = f"the best form by hand; {version(gcc)} -O2"
    for subject in all_subjects:
        for way, best in zip(("read", "write"), BEST.get(subject.name, TELEGRAM), strict=True):
            name = f"{subject.prefix}_{way}"
            ours = large[name]
            yield Row(
                GROUP, f"{subject.name}, {way}, Cortex-M4", by, ours, best, "instructions", round(ours / best, 3), 1.1
            )
            ours = small[name]
            yield Row(
                GROUP, f"{subject.name}, {way}, Cortex-M0+", by, ours, best, "instructions", round(ours / best, 3)
            )
            memory = float(calls[name])
            label = f"{subject.name}, {way}, Cortex-M0+, calls of memory functions"
            yield Row(GROUP, label, "none", memory, 0, "calls", memory, 0)


def main() -> None:
    """Prints the rows."""
    printed(rows())


if __name__ == "__main__":
    main()
