"""`fieldspec build --watch`: how long after a save the findings are printed, and the outputs written."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from processes import FIELDSPEC, limited
from rows import ROOT, Row, printed

GROUP = "build --watch"
DEVICES = ("tc100", "ck10", "esc11", "hiwin-e")
ROUNDS = 5


def rows() -> Iterator[Row]:
    """The rows: for each device, a comment is added to its spec; once, something wrong."""
    with tempfile.TemporaryDirectory() as folder:
        specs = Path(folder, "specs")
        shutil.copytree(ROOT / "specs", specs)
        command = (*FIELDSPEC, "build", "--watch", "--specs", str(specs), "--out", str(Path(folder, "out")))
        environment = {**os.environ, "FIELDSPEC_CACHE": str(Path(folder, "cache"))}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        try:
            _wait(process)
            time.sleep(2)  # what it does while it waits
            for device in DEVICES:
                path = specs / device / "device.yaml"
                text = path.read_text("utf-8")
                saved = [_saved(process, path, f"{text}# {turn}\n") for turn in range(ROUNDS)]
                broken = [_saved(process, path, f"{text}wrong{turn}: 1\n") for turn in range(ROUNDS)]
                _saved(process, path, text)
                yield limited(GROUP, f"{device}: findings after a save", median(broken), "ms", 300)
                yield limited(GROUP, f"{device}: all outputs after a save", median(saved), "ms", 300)
        finally:
            process.kill()
            process.wait()


def _saved(process: subprocess.Popen[str], path: Path, text: str) -> float:
    """Milliseconds from a save to the end of what it leads to."""
    beside = path.with_name(".beside")
    beside.write_text(text, encoding="utf-8")
    start = time.perf_counter()
    os.replace(beside, path)
    _wait(process)
    return (time.perf_counter() - start) * 1e3


def _wait(process: subprocess.Popen[str]) -> None:
    assert process.stdout is not None
    while "waiting for a spec" not in process.stdout.readline():
        assert process.poll() is None, "it has ended"


if __name__ == "__main__":
    printed(rows())
