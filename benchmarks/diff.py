"""How long a diff takes: `python benchmarks/diff.py [REGISTERS...]`. The time per register must not grow.

Each run compares two versions of a made-up device with that many registers, of which one in a hundred has changed, one
in a thousand has moved, one in a thousand has another name, and one in a thousand is new.
"""

from __future__ import annotations

import gc
import resource
import sys
import time
from collections import Counter
from dataclasses import replace

from fieldspec.language.changes.table import changes
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Register
from fieldspec.language.reading.project import read

SPEC = """
device: {{id: large, name: Large, vendor: Nobody, manual: {{title: M, file: m.txt, sha256: "{zeros}", lines: 9}}}}
registers:
  - group: all
    rows:
"""
ROW = "      - {{at: {at}, name: value_{at}, type: u16, range: 0..{most}, scale: 0.01, unit: mm, source: L{at}}}\n"


def device(count: int) -> Device:
    """A device with some registers; those that the reader would refuse for their addresses are copied from others."""
    text = SPEC.format(zeros="0" * 64) + "".join(ROW.format(at=at, most=at + 9) for at in range(1, 201))
    model = read({"large/device.yaml": text.encode()}).devices["large"].at("1")[0]
    group = model.groups[0]
    rows = tuple(
        replace(
            group.registers[at % 200], address=at, name=f"value_{at}", value=replace(group.registers[at % 200].value)
        )
        for at in range(count)
    )
    return replace(model, groups=(replace(group, registers=rows),))


def changed(device: Device) -> Device:
    """The same device in its next version. Nothing of it is shared with the first one."""
    group = device.groups[0]
    rows = tuple(row for at, register in enumerate(group.registers) for row in _changed(at, register))
    return replace(device, groups=(replace(group, registers=rows),))


def _changed(at: int, register: Register) -> tuple[Register, ...]:
    register = replace(register, value=replace(register.value))
    if at % 1000 == 1:
        return (replace(register, address=register.address + 1_000_000),)
    if at % 1000 == 2:
        return (replace(register, name=f"{register.name}_renamed"),)
    if at % 1000 == 3:
        return register, replace(register, name=f"{register.name}_more", address=register.address + 2_000_000)
    return (replace(register, access="ro"),) if at % 100 == 4 else (register,)


def main(counts: list[int]) -> None:
    for count in counts:
        old = device(count)
        new = changed(old)
        gc.disable()
        start = time.perf_counter()
        differences = changes(old, new)
        took = time.perf_counter() - start
        gc.enable()
        rules = ", ".join(
            f"{number} {rule}" for rule, number in sorted(Counter(change.rule for change in differences).items())
        )
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
        print(f"{count} registers: {took:.2f} s, {took / count * 1e6:.1f} us each, {memory} MiB: {rules}")


if __name__ == "__main__":
    main([int(text) for text in sys.argv[1:]] or [10_000, 100_000])
