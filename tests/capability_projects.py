"""The specs in which changes of keys are tried: made-up devices, cases that pass, and some real devices."""

from __future__ import annotations

import re
from pathlib import Path

from layouts import SPECS, TEST_SPECS

CASES = Path(__file__).with_name("cases")
AUDITED = Path(__file__).with_name("audit") / "right"
CAPABILITY_DEVICES = Path(__file__).with_name("capability_devices")
KEYS = CAPABILITY_DEVICES / "keys"
"""A device with the keys of values at every place that has them, which is quick to build."""
OTHERS = ("drive", "rules", "statements")
"""Devices that state links on CAN buses, all actions of rules, and what no simulator does, in their own files."""
MANUALS = {
    "audit/right": AUDITED.parent / "pump.txt",
    "keys": KEYS.with_name("keys.txt"),
    "statements": KEYS.with_name("statements.txt"),
}
"""The texts of the manuals of projects, which audits compare with their specs."""
LAST = ("station", "wattmeter", "beacon", "glider-x", "widget")
"""The made-up devices that take the longest to build, tried after all others."""


def _files(folder: Path, root: Path) -> dict[str, bytes]:
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*.yaml"))}


def _without_bus(text: str) -> str:
    """The spec of the counter without its CAN bus, for the outputs that have no functions for CAN frames."""
    blocks = re.split(r"(?m)^(?=  - name: |\S)", text)
    return "".join(block for block in blocks if "\n    can: " not in block and "\n    links: [bus]" not in block)


def _projects() -> dict[str, dict[str, bytes]]:
    """The files of made-up devices, of cases that pass and of some real devices, the quickest to build first."""
    shared = _files(SPECS / "protocols", SPECS) | _files(TEST_SPECS / "protocols", TEST_SPECS)
    devices = {path.parent.name: _files(path.parent, TEST_SPECS) for path in TEST_SPECS.glob("*/device.yaml")}
    cases = {}
    for folder in sorted(CASES.glob("*/passing*")):
        flat = {f"gadget/{path.name}": path.read_bytes() for path in sorted(folder.glob("*.yaml"))}
        cases[folder.relative_to(CASES).as_posix()] = flat or _files(folder, folder)
    order = sorted(devices, key=lambda name: (LAST.index(name) + 1 if name in LAST else 0, name))
    early = {name: devices[name] for name in order if name not in LAST}
    late = {name: devices[name] for name in order if name in LAST}
    late |= {name: _files(SPECS / name, SPECS) for name in ("esc11", "ck10", "tc100")}
    early |= {"audit/right": _files(AUDITED / "pump", AUDITED), "keys": _files(KEYS, CAPABILITY_DEVICES)}
    early |= {name: _files(CAPABILITY_DEVICES / name, CAPABILITY_DEVICES) for name in OTHERS}
    counter = early["counter"]["counter/device.yaml"].decode("utf-8")
    early["counter-serial"] = {"counter/device.yaml": _without_bus(counter).encode("utf-8")}
    return {
        name: shared | files if any(b"\nuses:" in data for data in files.values()) else files
        for name, files in (early | cases | late).items()
    }


PROJECTS = _projects()
