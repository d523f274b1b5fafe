"""Finds matiec, the compiler of IEC 61131-3 that Beremiz and OpenPLC use, and builds it where it is an archive.

matiec is licensed by the GPL. It is a tool of the tests alone: nothing of it is copied into the project or shipped.
The variable `MATIEC` names either the archive of its source or a folder in which `iec2c` and `lib` lie.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import tarfile
from functools import cache
from pathlib import Path

from external_tools import require_tool, without

VARIABLE = "MATIEC"
STEPS = (["autoreconf", "-i"], ["./configure"], ["make", "-j4", "CXXFLAGS=-O1 -g0"])
"""The compiler translates in two fifths of the time that it takes where it is built without `-O1`, its default."""


@cache
def matiec() -> Path:
    """The folder with `iec2c` and `lib`. If it is missing, the test is skipped, or fails in CI."""
    text = os.environ.get(VARIABLE, "")
    place = Path(text)
    if not text or not place.exists():
        missing = f"{VARIABLE} is {text}, which is not there" if text else f"{VARIABLE} is not set"
        without("matiec", f"no matiec: {missing}; CONTRIBUTING.md says how to get it and what to set")
    return place if place.is_dir() else _built(place)


def _built(archive: Path) -> Path:
    """The compiler, built once for each archive in the user's cache."""
    digest = hashlib.sha256(archive.read_bytes() + repr(STEPS).encode()).hexdigest()[:16]
    caches = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "fieldspec-tests"
    caches.mkdir(parents=True, exist_ok=True)
    folder = caches / f"matiec-{digest}"
    with (caches / f"matiec-{digest}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "iec2c").exists():
            for name in ("autoreconf", "bison", "flex", "make", "g++"):
                require_tool(name)
            shutil.rmtree(folder, ignore_errors=True)
            with tarfile.open(archive) as tar_file:
                tar_file.extractall(folder, filter="data") if hasattr(tarfile, "data_filter") else tar_file.extractall(
                    folder
                )
            (source,) = {path.parent for path in folder.glob("**/configure.ac")}
            for step in STEPS:
                ran = subprocess.run(step, cwd=source, capture_output=True, text=True, check=False)
                assert ran.returncode == 0, (step, ran.stderr[-3000:])
            if source != folder:
                for name in ("iec2c", "lib"):
                    (source / name).rename(folder / name)
    return folder
