"""Whether the compiler makes some outputs as they are recorded: `python recorded_outputs.py OUTPUT...`.

The exit code is 1 where one differs. The outputs of the devices that are in `generated/` are compared byte by byte,
those of the made-up devices, which use every feature of the language, by the digests in `tests/recorded/`. It compares
outputs, not hashes of the compiler, so that a changed compiler with the same outputs passes.
"""

from __future__ import annotations

import hashlib
import json
import sys
from pathlib import Path

from fieldspec import cli
from fieldspec.command import pipeline
from fieldspec.language.diagnostics import Severity
from fieldspec.targets import OUTPUTS
from layouts import TEST_SPECS, layouts

ROOT = Path(__file__).resolve().parent.parent
RECORDED = Path(__file__).resolve().parent / "recorded"


def digests(name: str) -> str:
    """An output of all made-up devices: a line for each, with its id and the digest of its files.

    Devices whose frames have digits are left out where the output cannot be made of them.
    """
    lines = []
    for device, versions in sorted(layouts(TEST_SPECS).items()):
        refused = {finding.code for finding in OUTPUTS[name].refusals(versions) if finding.severity is Severity.ERROR}
        if refused & {"plc_numbers_binary", "output_numbers_binary"}:
            continue
        digest = hashlib.sha256()
        for path, content in sorted(pipeline.output(name, versions).items()):
            digest.update(b"%s %d\n%s" % (path.encode(), len(content), content))
        lines.append(f"{device} {digest.hexdigest()}\n")
    return "".join(lines)


def digests_path(name: str) -> Path:
    """The file with the recorded digests of an output."""
    return RECORDED / f"{name}.txt"


def main(names: list[str]) -> int:
    """Checks the specs and builds the outputs with these names. Returns the exit code."""
    generated = ROOT / "generated"
    recorded = {
        path.partition("/")[0] for path in json.loads((generated / "manifest.json").read_text("utf-8"))["files"]
    }
    to = ",".join(name for name in names if name in recorded) or "vectors"
    places = ("--specs", str(ROOT / "specs"), "--out", str(generated))
    code = cli.main(["build", "--check", "--no-cache", "--to", to, *places])
    return code or int(any(digests(name) != digests_path(name).read_text("utf-8") for name in names))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
