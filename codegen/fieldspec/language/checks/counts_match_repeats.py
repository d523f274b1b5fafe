"""The number of words or bytes that a request reads or announces equals the number of values that are sent.

Why: the manual prints the limits of a number of words or bytes with the request, and again with the values. If they
differ, a program requests values that no response can carry, or a valid response is rejected.

Example: a read of 1 to 125 words whose response has the values `repeat: 0..125`.

Fix: Correct the range of the number or the repetitions. If the device sends fewer than requested, set
`allow: {counts_match_repeats: <reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.accesses_fit_space import spaces_of_bits
from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device


def counts_match_repeats(device: Device) -> Findings:
    of_bits = spaces_of_bits(device)  # whose unit is wrong, and then all counts are
    for message in device.messages.values():
        access = device.register_access(message)
        if access is None or device.space_name(access.space) in of_bits:
            continue
        if not access.count or (access.space and access.space not in device.spaces):
            continue
        count = message.request.named(access.count)
        values = (message.response if access.operation == "read" else message.request).named(access.values)
        if count is None or count.value is None or count.value.ranges is None or values is None:
            continue
        unit = device.space(access.space).unit
        ranges, repeat = count.value.ranges, values.repeat
        if repeat is not None and (ranges.low, ranges.high) != (repeat.low, repeat.high):
            text = f"{message.name} is for {ranges.text()} {unit}s, but {values.name} has {repeat.text()} elements"
            related_label = label(count.place, range_key(count.place), f"the range of {count.name}")
            help = "correct the range or the repetitions, or allow it with a reason"
            yield finding(values.place, "repeat", text, help, related_label, severity=Severity.WARNING)
