"""All outputs of the real devices: from nothing, where nothing has changed, and where one device has."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from processes import FIELDSPEC, in_turns, limited, run
from rows import ROOT, Row, printed

GROUP = "All outputs of four devices"
ROUNDS = 5


def rows() -> Iterator[Row]:
    """The rows. These times are those of the clock, as people wait for them."""
    with tempfile.TemporaryDirectory() as folder:
        specs, out = Path(folder, "specs"), Path(folder, "out")
        shutil.copytree(ROOT / "specs", specs)
        build = (*FIELDSPEC, "build", "--specs", str(specs), "--out", str(out))
        variables = {"FIELDSPEC_CACHE": str(Path(folder, "cache"))}
        took = in_turns({"all": (*build, "--no-cache"), "none": build}, ROUNDS, **variables)
        files = [path for path in out.rglob("*") if path.is_file()]
        times = {path: path.stat().st_mtime_ns for path in files}
        run(build, **variables)
        rewritten = sum(path.stat().st_mtime_ns != time for path, time in times.items())
        changed = []
        for turn in range(ROUNDS):
            with (specs / "tc100" / "device.yaml").open("a", encoding="utf-8") as file:
                file.write(f"# {turn}\n")
            changed.append(run(build, **variables).clock)
        size = sum(path.stat().st_size for path in files) / 1e6
    everything = f"everything, {len(files)} files of {size:.0f} MB"
    yield limited(GROUP, everything, median(measured.clock for measured in took["all"]) / 1e3, "s", 2)
    work = median(measured.work for measured in took["all"]) / 1e3
    yield Row(GROUP, f"{everything}, work of all processors", "", round(work, 1), 0, "s", 0)
    yield limited(GROUP, "nothing has changed", median(measured.clock for measured in took["none"]), "ms", 250)
    yield limited(
        GROUP,
        "nothing has changed, work of the processor",
        median(measured.work for measured in took["none"]),
        "ms",
        250,
    )
    yield Row(GROUP, "nothing has changed, files rewritten", "none", rewritten, 0, "files", 0, at_most=0)
    yield Row(GROUP, "TC100 has changed", "", round(median(changed), 1), 0, "ms", 0)


if __name__ == "__main__":
    printed(rows())
