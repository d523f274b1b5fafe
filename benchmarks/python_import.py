"""How long a generated module of 100 records takes to import, as a whole process."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from rows import Row, printed

from fieldspec.pipeline import layouts, load, outputs

GROUP = "Python, import"
RECORDS = 100
FIELDS = 21
ROUNDS = 41
HEAD = f"""
device: {{id: large, name: Large, vendor: Nobody, manual: {{title: M, file: m.txt, sha256: "{"0" * 64}", lines: 9}}}}
records:
"""


def spec() -> bytes:
    """A device with 100 records of 21 fields."""
    rows = [
        f"  - {{name: record_{record}, source: 1 L1, fields: ["
        + ", ".join(f"{{name: value_{at}, type: {'u16' if at % 3 else 'i32'}, source: 1 L1}}" for at in range(FIELDS))
        + "]}"
        for record in range(RECORDS)
    ]
    return (HEAD + "\n".join(rows) + "\n").encode()


def took(command: str, folder: str) -> float:
    """Milliseconds that a process takes from its start to its end."""
    environment = {**os.environ, "PYTHONPATH": folder, "PYTHONDONTWRITEBYTECODE": ""}
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", command], env=environment, check=True)
    return (time.perf_counter() - start) * 1e3


def rows() -> Iterator[Row]:
    """The row: what the import adds to a process that does nothing."""
    project = load({"large/device.yaml": spec()})
    assert not project.found, project.found[0].message
    with tempfile.TemporaryDirectory() as folder:
        for path, text in outputs([layouts(project.devices["large"])], ["python"]).items():
            place = Path(folder, path).relative_to(Path(folder, "python"))
            (Path(folder) / place.parent).mkdir(parents=True, exist_ok=True)
            (Path(folder) / place).write_bytes(text.encode() if isinstance(text, str) else text)
        module = next(path.stem for path in Path(folder, "fieldspec_devices", "large").iterdir() if path.stem[0] != "_")
        command = f"import fieldspec_devices.large.{module}"
        took(command, folder)
        pairs = [(took(command, folder), took("pass", folder)) for _ in range(ROUNDS)]
    added = median(ours - theirs for ours, theirs in pairs)
    name = f"{RECORDS} records of {FIELDS} fields, added to python -c pass"
    yield Row(GROUP, name, "the goal of 4 ms", added, 4, "ms",
              added / 4, at_most=1)  # fmt: skip


if __name__ == "__main__":
    printed(rows())
