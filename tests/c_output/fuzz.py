"""Fuzzes the C headers of the devices' newest versions: `make fuzz`, or `python tests/c_output/fuzz.py [SECONDS]`.

All devices are fuzzed at the same time, each for so many seconds. What was found worth trying is kept in `build/fuzz/`
and is tried again the next time; so is an input that breaks something.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from fieldspec.foundation.names import stem
from fieldspec.targets.c.backend import files
from layouts import SPECS, newest

ROOT = Path(__file__).resolve().parent.parent.parent
SECONDS = 60
FLAGS = [
    "-std=c99",
    "-g",
    "-O1",
    "-fsanitize=fuzzer,address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
]


def built(clang: str, folder: Path, source: Path, *more: str) -> Path:
    """Builds the fuzzer of a target; the header is in the same folder."""
    program = folder / source.stem
    subprocess.run([clang, *FLAGS, *more, "-o", str(program), str(source)], check=True)
    return program


def command(program: Path, seconds: int, corpus: Path) -> list[str]:
    """The command that runs a fuzzer for some seconds. The largest frame has some 500 bytes."""
    corpus.mkdir(exist_ok=True)
    artifacts = f"-artifact_prefix={program.parent}/"
    return [str(program), f"-max_total_time={seconds}", "-max_len=600", artifacts, str(corpus)]


def main(seconds: int = SECONDS) -> int:
    """Fuzzes all devices and returns the exit code: 1 if an input breaks something, 2 without clang."""
    clang = shutil.which("clang")
    if clang is None:
        print("clang is not installed; on Debian: apt-get install clang libclang-rt-dev", file=sys.stderr)
        return 2
    running = []
    for path in sorted(SPECS.glob("*/device.yaml")):
        layout = newest(SPECS, path.parent.name)
        folder = ROOT / "build" / "fuzz" / layout.device.id
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files([layout]).items():
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
        source = folder / f"{stem(layout.device.id, layout.device.version)}_fuzz.c"
        try:
            program = built(clang, folder, source)
        except subprocess.CalledProcessError:
            print("clang makes no fuzzer; on Debian: apt-get install libclang-rt-dev", file=sys.stderr)
            return 2
        call = command(program, seconds, folder / "corpus")
        log = folder / "log.txt"
        with log.open("w", encoding="utf-8") as log_file:
            running.append((layout.device.id, log, subprocess.Popen(call, stdout=log_file, stderr=subprocess.STDOUT)))
    broken = 0
    for device, log, process in running:
        code = process.wait()
        last = log.read_text("utf-8", "replace").strip().splitlines()[-1]
        print(f"{device}: {'broken, see ' + str(log) if code else last}")
        broken += code != 0
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
