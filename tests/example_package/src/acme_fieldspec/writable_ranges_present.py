"""Every register of numbers that can be written has a range.

Why: our operator panels limit what people enter, and take the limits from the spec.

Example: `speed` with `access: rw`, and neither `range` nor `unit_range`.

Fix: Look the limits up in the manual, or allow this with a reason where it prints none.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.extension import Device, Diagnostic, finding


def writable_ranges_present(device: Device) -> Iterator[Diagnostic]:
    for register in device.registers():
        value = register.value
        if register.access in ("rw", "wo") and value.ranges is None and not value.enum and value.const is None:
            text = f"{register.name} can be written, and has no range"
            yield finding("writable_ranges_present", register.place, "name", text, "add `range` or `unit_range`")
