"""The command line: how long short commands take, against an interpreter that does nothing, and against other tools."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

from processes import BIN, FIELDSPEC, PYTHON, compared, in_turns
from rows import ROOT, Row, printed

GROUP = "Command line"
NOTHING = "python -c pass"
ROUNDS = 21
FRAME = "01 03 10 00 00 01 80 CA"
DATABASE = """VERSION ""

BU_: PLC

BO_ 256 Point: 8 PLC
 SG_ position : 0|32@1- (0.01,0) [0|0] "mm" PLC
 SG_ speed : 32|16@1+ (1,0) [0|0] "mm/s" PLC
"""


def rows() -> Iterator[Row]:
    """The rows."""
    specs = ("--specs", str(ROOT / "specs"))
    cantools, peakrdl = f"cantools {version('cantools')}", f"PeakRDL {version('peakrdl')}"
    with tempfile.TemporaryDirectory() as folder:
        database = Path(folder, "point.dbc")
        database.write_text(DATABASE, encoding="utf-8")
        commands = {
            NOTHING: (*PYTHON, "-c", "pass"),
            "fieldspec --help": (*FIELDSPEC, "--help"),
            "fieldspec decode": (*FIELDSPEC, "decode", "tc100", FRAME, *specs),
            "fieldspec decode --no-cache": (*FIELDSPEC, "decode", "tc100", FRAME, "--no-cache", *specs),
            "fieldspec show": (*FIELDSPEC, "show", "tc100", *specs),
            f"{cantools} --help": (*PYTHON, str(BIN / "cantools"), "--help"),
            f"{cantools} dump": (*PYTHON, str(BIN / "cantools"), "dump", str(database)),
            f"{peakrdl} --help": (*PYTHON, str(BIN / "peakrdl"), "--help"),
        }
        took = in_turns(commands, ROUNDS, FIELDSPEC_CACHE=folder)
    yield compared(GROUP, "--help", took, "fieldspec --help", NOTHING, at_most=2.8)
    yield compared(GROUP, "--help", took, "fieldspec --help", f"{cantools} --help")
    yield compared(GROUP, "--help", took, "fieldspec --help", f"{peakrdl} --help")
    yield compared(GROUP, "decode of one frame", took, "fieldspec decode", NOTHING, at_most=3.5)
    yield compared(GROUP, "decode, from the spec itself", took, "fieldspec decode --no-cache", NOTHING)
    yield compared(GROUP, "show", took, "fieldspec show", NOTHING, at_most=4)
    yield compared(GROUP, "show", took, "fieldspec show", f"{cantools} dump")


if __name__ == "__main__":
    printed(rows())
