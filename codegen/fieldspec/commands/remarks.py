"""What must be said of a frame beside its bytes: how its reading was found, and which others fit."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.commands.readings import Read
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.explanation import Explanation

_NAMED = 3


def remarks(layout: DeviceLayout, held: Read, asked_in: int) -> Iterator[str]:
    """The remarks on a frame; `asked_in` is the line of the request before it, 0 where there is none."""
    if held.chosen == "closest":
        yield f"this is no good frame of {layout.device.id}; it comes closest to what is explained here"
    elif asked_in and held.explanation.direction == "response":
        answers = "this answers" if held.chosen == "request" else "this does not answer"
        yield f"{answers} the request in line {asked_in}"
    if held.chosen == "likeliest":
        yield _ambiguous(held)
    yield from held.mismatches


def _ambiguous(held: Read) -> str:
    """Which other readings fit, and which options tell them apart."""
    own = held.explanation
    others: dict[tuple[str, str, bool], list[str]] = {}
    for link, direction, message, error in held.others:
        others.setdefault((link, direction, error), []).append(message or "an unknown message")
    listed = " or ".join(_named(own, link, kind, error, names) for (link, kind, error), names in others.items())
    options = []
    if any(link != own.link for link, _, _ in others):
        options.append("--link")
    if any(direction != own.direction for _, direction, _ in others):
        options.append("--direction")
    if any(direction == own.direction for _, direction, _ in others):
        options += ["--request", "--message"] if own.direction == "response" else ["--message"]
    explained = _named(own, own.link, own.direction, own.error, [own.message or "an unknown message"])
    return f"ambiguous: explained as {explained}, it may also be {listed}; {' or '.join(options)} tells"


def _named(own: Explanation, link: str, direction: str, error: bool, messages: list[str]) -> str:
    """`the response to stop on rtu`, or `a response to one of 28 messages: stop, move, homing, ..`"""
    kind = "refusal" if error else direction
    joint = "of" if kind != "response" else "to"
    place = "" if link == own.link else f" on {link}"
    if len(messages) == 1:
        return f"the {kind} {joint} {messages[0]}{place}"
    names = ", ".join(messages if len(messages) <= _NAMED else [*messages[:_NAMED], ".."])
    return f"a {kind} {joint} one of {len(messages)} messages{place} ({names})"
