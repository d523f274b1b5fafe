"""Whether the compiler makes some outputs as they are recorded: `python recorded_outputs.py OUTPUT...`.

The exit code is 1 where one differs. The outputs of the devices are compared byte by byte with `generated/`, those of
the made-up devices, which use every feature of the language, by the digests in `tests/recorded/`. It compares outputs,
not hashes of the compiler, so that a changed compiler with the same outputs passes.
"""

from __future__ import annotations

import hashlib
import sys
from itertools import chain
from pathlib import Path

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
    specs, generated = ROOT / "specs", ROOT / "generated"
    files = {path.relative_to(specs).as_posix(): path.read_bytes() for path in sorted(specs.rglob("*.yaml"))}
    project = pipeline.load(files)
    if pipeline.checked(project):
        return 1
    devices = [pipeline.layouts(spec) for spec in project.devices.values()]
    for name in names:
        for contents in chain([pipeline.shared(name)], (pipeline.output(name, versions) for versions in devices)):
            for path, content in contents.items():
                # A build adds links to pages about the manual to the indexes of the documentation.
                is_index = name == "docs" and path.endswith(("index.html", "README.md"))
                # Of older versions, what tests them is not kept.
                is_left_out = path.endswith(OUTPUTS[name].test_endings) and not (generated / path).exists()
                if not is_left_out and (generated / path).read_bytes() != content and not is_index:
                    return 1
    return int(any(digests(name) != digests_path(name).read_text("utf-8") for name in names))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
