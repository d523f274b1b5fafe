"""The generated JavaScript in Node, beside what is written by hand and the JavaScript of Kaitai Struct."""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rows import ROOT, Row, printed

GROUP = "JavaScript"
TOOLS = Path(__file__).resolve().parent / "tools"
PEERS = Path(__file__).resolve().parent / "peers"
GOALS: dict[str, dict[str, Any]] = {
    "decode telegram 111, nine fields read": {"at_most": 1.1},
    "decode telegram 111, nine fields read from bytes": {"at_most": 1.1},
    "decode telegram 111, value kept": {"at_most": 1.1},
    "encode telegram 111, all values checked": {"at_most": 1.3},
    "write telegram 111 into bytes, all values checked": {"at_most": 1.3},
    "decode a point": {"at_least": 10},
    "decode a frame": {},
}


def rows() -> Iterator[Row]:
    """The rows."""
    with tempfile.TemporaryDirectory(dir=TOOLS) as folder:
        files = [_compiled(name, Path(folder)) for name in ("point", "request")]
        command = ["node", str(TOOLS / "javascript.cjs"), str(ROOT / "generated" / "js"), *map(str, files)]
        run = subprocess.run(command, cwd=TOOLS, capture_output=True, text=True, check=True)
    for line in run.stdout.splitlines():
        name, peer, ours, theirs, ratio = json.loads(line)
        goal = GOALS[name]
        figure = 1 / ratio if "at_least" in goal else ratio
        yield Row(GROUP, name, peer, round(ours, 1), round(theirs, 1), "ns", round(figure, 3), **goal)


def _compiled(name: str, folder: Path) -> Path:
    """The JavaScript of a .ksy file, in a folder from which it finds its runtime."""
    command = ["node", str(TOOLS / "kaitai.js"), str(PEERS / f"{name}.ksy"), "--javascript"]
    text = subprocess.run(command, cwd=TOOLS, capture_output=True, text=True, check=True).stdout
    file = folder / f"{name}.cjs"
    file.write_text(text, "utf-8")
    return file


if __name__ == "__main__":
    printed(rows())
