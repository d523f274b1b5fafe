"""Writes docs/plc-sizes.md: code and data of the generated function blocks on a Cortex-M3.

`make plc-sizes`. Needs matiec (see CONTRIBUTING.md), gcc-arm-none-eabi and libnewlib-arm-none-eabi. matiec translates
the output `iec` to C, and gcc compiles it for size; no vendor's compiler takes part.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

from matiec import matiec  # noqa: E402

FLAGS = ("-std=gnu11", "-Os", "-mcpu=cortex-m3", "-mthumb", "-ffunction-sections", "-w")
PAGE = ROOT / "docs" / "plc-sizes.md"
HEAD = """# Sizes of the function blocks

Sizes of the [function blocks](plc-blocks.md) on a small controller, in bytes. For these figures, matiec translated the
output `iec`, and `arm-none-eabi-gcc -Os -mcpu=cortex-m3` compiled the result. `make plc-sizes` writes this page.
The compiler of your PLC gives other figures: use this page to compare blocks, and for the order of magnitude.

*code* is the body of the block. The functions that the blocks call exist once for each device. The line above each
table has the sum of these functions, for a program that uses all of them.

*data* is the memory of one instance. matiec copies each constant and each struct passed to a block, and adds a byte of
flags to each variable. *own data* is the memory without these copies. CODESYS, TwinCAT and TIA Portal pass references
and need no memory for constants, so *own data* is the better estimate for them.
"""


def main() -> None:
    """Writes the page."""
    lines = [HEAD]
    for path in sorted((ROOT / "generated" / "iec").glob("*.st")):
        # What lies beside the blocks of a version, its constants and programs, has none of its own.
        if path.with_stem(f"{path.stem}_constants").exists():
            lines += _section(path)
    PAGE.write_text("\n".join(lines) + "\n", "utf-8")
    print(f"{PAGE.relative_to(ROOT)} is written")


def _section(path: Path) -> Iterator[str]:
    """The table of a device."""
    blocks = re.findall(r"^FUNCTION_BLOCK (\w+)\n(.*?)^END_FUNCTION_BLOCK", path.read_text("utf-8"), re.M | re.S)
    sizes = _sizes(path, {name: _copied(body) for name, body in blocks})
    functions = sum(size for name, size in sizes.items() if name.startswith("F_"))
    yield f"\n## {path.stem}\n\nAll functions: {functions:,} bytes of code.\n"
    yield "| block | code | data | own data |\n|---|---|---|---|"
    for name, _ in blocks:
        upper = name.upper()
        data, own = sizes[f"DATA_{upper}"], sizes[f"OWN_{upper}"]
        yield f"| `{name}` | {sizes[f'{upper}_body__']:,} | {data:,} | {own:,} |"


def _copied(body: str) -> list[str]:
    """The variables that a block is lent, and its constants."""
    sections = re.findall(r"^(?:VAR_IN_OUT|VAR CONSTANT)$(.*?)^END_VAR", body, re.M | re.S)
    return re.findall(r"^\s+(\w+) :", "".join(sections), re.M)


def _sizes(path: Path, blocks: dict[str, list[str]]) -> dict[str, int]:
    """The sizes of all functions, and of the data of all blocks, by their symbols."""
    tool = matiec()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        command = [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", name, str(path)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        lines = ['#include "POUS.h"', "TIME __CURRENT_TIME;", "BOOL __DEBUG;", '#include "POUS.c"']
        for block, copied in blocks.items():
            upper = block.upper()
            less = "".join(f" - sizeof((({upper} *)0)->{variable.upper()})" for variable in copied)
            lines += [f"char DATA_{upper}[sizeof({upper})];", f"char OWN_{upper}[sizeof({upper}){less}];"]
        (folder / "all.c").write_text("\n".join(lines) + "\n", "utf-8")
        target = folder / "all.o"
        include = ["-isystem", str(tool / "lib" / "C"), f"-I{name}"]
        subprocess.run(
            ["arm-none-eabi-gcc", *FLAGS, *include, "-c", str(folder / "all.c"), "-o", str(target)], check=True
        )
        listing = subprocess.run(
            ["arm-none-eabi-nm", "-S", str(target)], check=True, capture_output=True, text=True
        ).stdout
    rows = (line.split() for line in listing.splitlines())
    return {row[3]: int(row[1], 16) for row in rows if len(row) == 4}


if __name__ == "__main__":
    main()
