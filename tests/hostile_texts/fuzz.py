"""Builds made-up devices with poison in every text: `make fuzz-texts SECONDS=600`, or this file with SECONDS and SEED.

Each output is taken apart by a parser of its language, and compared with that of the same device with harmless texts of
the same form. Only the texts may differ.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command import pipeline
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets import OUTPUTS
from hostile_texts.filled_specs import layouts, spec
from hostile_texts.poison import harmless
from hostile_texts.structures import ParserError, structures

DEVICES = ("widget", "glider-x", "station", "gizmo", "gadget", "grinder", "hostile", "probe")


def outputs_of(versions: list[DeviceLayout], names: Sequence[str]) -> dict[str, bytes]:
    """The files of some outputs of a device; those of an output that refuses it are left out."""
    return {
        path: content
        for name in names
        if not has_errors(OUTPUTS[name].refusals(versions))
        for path, content in pipeline.output(name, versions).items()
    }


def differences(device: str, seed: int, names: Sequence[str] = tuple(OUTPUTS)) -> Iterator[str]:
    """The files of a device in which poison is more than a text, each with what is wrong."""
    poisoned, right = (
        outputs_of(layouts(spec(device, seed)), names),
        outputs_of(layouts(spec(device, seed, harmless)), names),
    )
    if poisoned.keys() != right.keys():
        yield f"{device}: other files: {sorted(poisoned.keys() ^ right.keys())}"
    expected = dict(structures(right))
    try:
        for path, structure in structures(poisoned):
            if structure != expected.get(path) and not path.endswith("search-index.js"):
                yield f"{path}: {_first_difference(structure, expected.get(path))}"
    except ParserError as error:
        yield str(error)


def _first_difference(structure: object, expected: object) -> str:
    if isinstance(structure, list) and isinstance(expected, list):
        pairs = enumerate(zip(structure, expected, strict=False))
        at = next((at for at, (left, right) in pairs if left != right), min(len(structure), len(expected)))
        return f"{structure[at : at + 4]} and not {expected[at : at + 4]}"
    return "another structure"


def main(seconds: int = 60, seed: int = 1) -> int:
    """Builds devices for some seconds and returns the exit code: 1 if a text is more than a text."""
    end = time.monotonic() + seconds
    count, wrong = 0, 0
    while time.monotonic() < end:
        device = DEVICES[count % len(DEVICES)]
        for difference in differences(device, seed + count):
            wrong += 1
            print(f"seed {seed + count}: {difference}", flush=True)
        count += 1
    print(f"{count} devices, {wrong} files in which a text is more than a text")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*(int(word) for word in sys.argv[1:])))
