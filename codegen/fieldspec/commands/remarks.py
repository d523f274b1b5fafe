"""What must be said of a frame beside its bytes: how its reading was found, and which others fit."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.commands.readings import Read
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.explanation import Explanation, Reading

_NAMED = 6


def remarks(layout: DeviceLayout, held: Read, asked_in: int) -> Iterator[str]:
    """The remarks on a frame; `asked_in` is the line of the request that it may answer."""
    if held.chosen == "closest":
        yield f"this is no good frame of {layout.device.id}; it comes closest to what is explained here"
    if held.chosen == "request" and asked_in:
        yield f"this answers the request in line {asked_in}"
    if held.chosen == "likeliest":
        yield _ambiguous(held)
    yield from held.mismatches


def _ambiguous(held: Read) -> str:
    """Which other readings fit, and which options tell them apart."""
    own = held.explanation
    names = [_named(reading, own) for reading in held.others]
    listed = names if len(names) <= _NAMED else [*names[:_NAMED], f"{len(names) - _NAMED} more"]
    others = " or ".join(", ".join(listed).rsplit(", ", 1))
    options = []
    if any(link != own.link for link, _, _, _ in held.others):
        options.append("--link")
    if any(direction != own.direction for _, direction, _, _ in held.others):
        options.append("--direction")
    if any(direction == own.direction and message != own.message for _, direction, message, _ in held.others):
        options += ["--request", "--message"] if own.direction == "response" else ["--message"]
    explained = _named((own.link, own.direction, own.message, own.error), own)
    return f"ambiguous: explained as {explained}; it may also be {others} (say which with {' or '.join(options)})"


def _named(reading: Reading, own: Explanation) -> str:
    link, direction, message, error = reading
    name = f"{message or 'unknown'} {'refusal' if error else direction}"
    return name if link == own.link else f"{name} on {link}"
