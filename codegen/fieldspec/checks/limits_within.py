"""A limit that is made of others is their sum, and a limit that another one bounds does not exceed it.

Why: a device that takes up to 400 ms to answer, and 280 ms to send, cannot be judged by a timeout of 600 ms. The
manual prints the three numbers on three pages, and nobody adds them up.

Example: `{name: longest_reply, value: 680, unit: ms, within: limits/timeout}` where the timeout is 600 ms.

Cure: Put the number or the reference right; where the manual prints it so, write an erratum.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.limit import Limit


def limits_within(device: Device) -> Iterator[Diagnostic]:
    limits = {limit.place.path: limit for limit in device.limits}
    for limit in device.limits:
        if limit.sum_of:
            yield from _sum(limit, [limits[path] for path in limit.sum_of if path in limits])
        bound = limits.get(limit.within)
        if bound is None or limit.most is None or bound.most is None:
            continue
        there = label(bound.place, "max" if "max" in bound.place else "value", "the bound")
        if limit.unit != bound.unit:
            text = f"{limit.name} is in {limit.unit or 'no unit'}, {bound.name} in {bound.unit or 'no unit'}"
            yield finding("limits_within", limit.place, "unit", text, "give both in one unit", there)
        elif limit.most > bound.most:
            text = f"{limit.name} goes to {limit.most} {limit.unit}, and {bound.name} to {bound.most}".replace(
                "  ", " "
            )
            yield finding("limits_within", limit.place, "within", text, "put one of them right", there)


def _sum(limit: Limit, parts: list[Limit]) -> Iterator[Diagnostic]:
    """Whether the greatest values of the parts add up to that of the limit, in its unit."""
    for part in parts:
        if part.most is None or part.unit != limit.unit:
            text = f"{part.name} has no greatest value in {limit.unit or 'no unit'} that could be added up"
            there = label(part.place, "name", "a part of the sum")
            yield finding("limits_within", limit.place, "sum_of", text, "name limits of the same unit", there)
            return
    total = sum(part.most for part in parts if part.most is not None)
    if limit.most is not None and parts and total != limit.most:
        text = f"the parts of {limit.name} add up to {total}, not to {limit.most}"
        yield finding("limits_within", limit.place, "sum_of", text, "put the sum or the parts right")
