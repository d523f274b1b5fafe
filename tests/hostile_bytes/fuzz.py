"""Fuzzes the generated Python, guided by coverage: `make fuzz-bytes`, or `python fuzz.py SECONDS [DEVICE]`.

It needs atheris, which `requirements/fuzz.txt` has. Without a device, all are fuzzed, each for so many seconds in a
process of its own. The first two bytes of an input choose the target; the rest is for it. An exception other than
`CodecError`, an input that takes ten seconds, and more than a gigabyte of memory end the run with the exit code 1; the
input stays in `build/fuzz/`, is tried again the next time, and should become a test.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from targets import DEVICES, ROOT, module, seeds, targets

FOLDER = ROOT / "build" / "fuzz"
PROCESSES = 2


def corpus(device: str) -> Path:
    """The folder with the inputs of a device, to which the vectors are added."""
    folder = FOLDER / f"{device}-python"
    folder.mkdir(parents=True, exist_ok=True)
    numbers = {name: number for number, (name, _) in enumerate(targets(device))}
    for number, (name, data) in enumerate(seeds(device)):
        if name in numbers:
            (folder / f"seed-{number:04}").write_bytes(numbers[name].to_bytes(2, "big") + data)
    return folder


def fuzz(device: str, seconds: int) -> None:
    """Fuzzes one device and ends the process."""
    import atheris

    folder = corpus(device)
    with atheris.instrument_imports(include=["fieldspec_devices"]):
        for name in [name for name in sys.modules if name.startswith("fieldspec_devices")]:
            del sys.modules[name]
        module(device)
    known = [target for _, target in targets(device)]

    def judge(data: bytes) -> None:
        known[int.from_bytes(data[:2], "big") % len(known)](data[2:])

    limits = [f"-max_total_time={seconds}", "-timeout=10", "-rss_limit_mb=1024", "-max_len=1100", "-seed=1"]
    atheris.Setup([sys.argv[0], *limits, f"-artifact_prefix={FOLDER}/{device}-", str(folder)], judge)
    atheris.Fuzz()


def main(seconds: int) -> int:
    """Fuzzes all devices, some at the same time, and returns the exit code."""
    waiting, running, broken = list(DEVICES), [], 0
    while waiting or running:
        while waiting and len(running) < PROCESSES:
            device = waiting.pop(0)
            call = [sys.executable, __file__, str(seconds), device]
            log = FOLDER / f"{device}-python.log"
            log.parent.mkdir(parents=True, exist_ok=True)
            with log.open("wb") as file:
                running.append((device, log, subprocess.Popen(call, stdout=file, stderr=subprocess.STDOUT)))
        device, log, process = running.pop(0)
        code = process.wait()
        done = re.findall(r"^Done \d+ runs.*", log.read_text("utf-8", "replace"), re.MULTILINE)
        print(f"{device}: {done[-1] if done and not code else f'broken, see {log}'}", flush=True)
        broken += bool(code) or not done
    return 1 if broken else 0


if __name__ == "__main__":
    if len(sys.argv) > 2:
        fuzz(sys.argv[2], int(sys.argv[1]))
    sys.exit(main(int(sys.argv[1])))
