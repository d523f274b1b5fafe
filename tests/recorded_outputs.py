"""Whether the compiler makes some outputs as they are recorded: `python recorded_outputs.py OUTPUT...`.

The exit code is 1 where one differs. It compares bytes, not hashes of the compiler, so that a changed compiler with the
same outputs passes.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fieldspec import pipeline

ROOT = Path(__file__).resolve().parent.parent


def main(names: list[str]) -> int:
    """Checks the specs and builds the outputs with these names. Returns the exit code."""
    specs, generated = ROOT / "specs", ROOT / "generated"
    files = {path.relative_to(specs).as_posix(): path.read_bytes() for path in sorted(specs.rglob("*.yaml"))}
    project = pipeline.load(files)
    if pipeline.checked(project):
        return 1
    for spec in project.devices.values():
        versions = pipeline.layouts(spec)
        for name in names:
            for path, content in pipeline.output(name, versions).items():
                # A build adds links to pages about the manual to the indexes of the documentation.
                is_index = name == "docs" and path.endswith(("index.html", "README.md"))
                recorded = generated / path
                if not recorded.is_file() or (recorded.read_bytes() != content and not is_index):
                    return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
