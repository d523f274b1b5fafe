"""What it costs to include the headers of 10,000 registers: the constants alone, and with the functions."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from importlib.metadata import version as package_version
from pathlib import Path

from c_headers import needed, version
from peers import registers
from processes import BIN, FIELDSPEC, PYTHON, compared, in_turns, run
from rows import Row, printed

GROUP = "Including C headers, 10,000 registers"
ROUNDS = 5
FLAGS = ("-std=c11", "-O2", "-c", "-o", "/dev/null")  # the header of the peer has static_assert of C11


def rows() -> Iterator[Row]:
    """The rows: the time of the compiler for a file that includes a header, and the bytes of the headers."""
    gcc = needed("gcc", "gcc")
    peer = f"PeakRDL {package_version('peakrdl')}, C header"
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        headers = _write_headers(folder, peer)
        commands = {}
        for number, (name, header) in enumerate(headers.items()):
            source = folder / f"including{number}.c"
            source.write_text(f'#include "{header}"\nint nothing;\n', encoding="utf-8")
            commands[name] = (gcc, *FLAGS, str(source))
        took = in_turns(commands, ROUNDS)
        whole, constants = f"{version(gcc)}, with functions", "constants"
        took[whole] = took["functions"]
        yield compared(GROUP, "constants", took, constants, whole, at_most=0.25)
        for name in ("constants", "functions"):
            yield compared(GROUP, f"{name}, beside a peer", took, name, peer)
            ours, its = ((folder / headers[key]).stat().st_size / 1e6 for key in (name, peer))
            yield Row(GROUP, f"{name}, size", peer, round(ours, 2), round(its, 2), "MB", round(ours / its, 3))


def _write_headers(folder: Path, peer: str) -> dict[str, str]:
    """The names of the headers that were written into a folder."""
    for path, text in registers.spec(10_000).items():
        (folder / "specs" / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / "specs" / path).write_text(text, encoding="utf-8")
    rdl = folder / "large.rdl"
    rdl.write_text(registers.systemrdl(10_000), encoding="utf-8")
    specs, out = ("--specs", str(folder / "specs")), ("--out", str(folder))
    run((*FIELDSPEC, "build", "--no-cache", *specs, *out, "--to", "c"), FIELDSPEC_CACHE=str(folder / "cache"))
    run((*PYTHON, str(BIN / "peakrdl"), "c-header", str(rdl), "-o", str(folder / "peer.h")))
    constants = next(folder.rglob("*_constants.h")).relative_to(folder).as_posix()
    return {"constants": constants, "functions": constants.replace("_constants", ""), peer: "peer.h"}


if __name__ == "__main__":
    printed(rows())
