"""A limit with parts is their sum, and a limit with a bound does not exceed it. No limit is its own part or bound.

Why: a timeout of 600 ms is too short for a device that takes up to 400 ms to answer and 280 ms to send. The
manual prints these numbers on different pages, where a wrong sum is not visible.

Example: `{name: delay, max: 400, unit: ms, transmits: response, within: limits/timeout}` where the longest
response has 244 bytes, which take 280 ms at 9600 bit/s, and the timeout is 600 ms.

Fix: Correct the number or the reference, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from decimal import Decimal

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.sizes import RecordSizes, messages_sent, shapes
from fieldspec.language.model.texts import Limit

_SECOND = {"us": 1_000_000, "ms": 1000, "s": 1}
"""How many of a unit of time a second has."""


def limits_within(device: Device) -> Findings:
    limits = {limit.place.path: limit for limit in device.limits}
    for limit in device.limits:
        for key, paths in (("sum_of", limit.sum_of), ("within", (limit.within,))):
            if limit.place.path in paths:
                text = f"{limit.name} names itself under `{key}`"
                yield finding(limit.place, key, text, "name another limit")
        if limit.sum_of:
            yield from _sum(limit, [limits[path] for path in limit.sum_of if path in limits])
        bound = limits.get(limit.within)
        if bound is None or limit.most is None or bound.most is None:
            continue
        related_label = label(bound.place, "max" if "max" in bound.place else "value", "the bound")
        if limit.unit != bound.unit:
            text = f"{limit.name} is in {limit.unit or 'no unit'}, {bound.name} in {bound.unit or 'no unit'}"
            yield finding(limit.place, "unit", text, "state both in the same unit", related_label)
            continue
        transmission, frame = _transmission(device, limit)
        if limit.most + transmission > bound.most:
            text = f"{limit.name} goes to {limit.most + transmission} {limit.unit}{frame}, "
            text += f"and {bound.name} to {bound.most}"
            yield finding(limit.place, "within", text, "correct one of them", related_label)


def _transmission(device: Device, limit: Limit) -> tuple[Decimal, str]:
    """How long the longest frame after a limit takes on the line, in its unit to two places, and what to say of it."""
    scale = _SECOND.get(limit.unit)
    if not limit.transmits or scale is None:
        return Decimal(0), ""
    from fractions import Fraction

    sizes = RecordSizes(device)
    longest, longest_time = 0, Fraction(0)
    for shape in shapes(device, limit.transmits):
        serial = shape.link.serial
        if serial is None or not serial.baud or min(serial.baud) <= 0:
            continue
        bits = (serial.start_bits or 1) + max(serial.data_bits, default=8) + max(serial.stop_bits, default=1)
        bits += 0 if set(serial.parity) <= {"none"} else 1
        for message in messages_sent(device, shape.link, limit.transmits):
            bounds = sizes.bounds(message.request if limit.transmits == "request" else message.response)
            length = shape.length(bounds[1]) if bounds is not None else 0
            time = Fraction(length * bits * scale, min(serial.baud))
            if time > longest_time:
                longest, longest_time = length, time
    return round(
        Decimal(longest_time.numerator) / longest_time.denominator, 2
    ), f" with a {limit.transmits} of {longest} bytes"


def _sum(limit: Limit, parts: list[Limit]) -> Findings:
    """Whether the greatest values of the parts add up to that of the limit, in its unit."""
    for part in parts:
        if part.most is None or part.unit != limit.unit:
            text = f"{part.name} has no maximum in {limit.unit or 'no unit'} to add"
            related_label = label(part.place, "name", "a part of the sum")
            yield finding(limit.place, "sum_of", text, "name limits of the same unit", related_label)
            return
    total = sum(part.most for part in parts if part.most is not None)
    if limit.most is not None and parts and total != limit.most:
        text = f"the parts of {limit.name} add up to {total}, not to {limit.most}"
        yield finding(limit.place, "sum_of", text, "correct the sum or the parts")
