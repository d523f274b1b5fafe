"""What must be said of a frame beside its bytes: how its reading was found, and which others fit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.commands.given import DIRECTIONS, Given, option_word
from fieldspec.commands.readings import Read
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.explanation import Explanation, Reading, lengths
from fieldspec.model.link import Link

_NAMED = 3


def remarks(layout: DeviceLayout, held: Read, asked_in: int, said: Given) -> Iterator[str]:
    """The remarks on a frame; `asked_in` is the line of the request before it, 0 where there is none."""
    if held.chosen == "closest":
        yield f"this is no good frame of {layout.device.id}; it comes closest to what is explained here"
        yield from _of_other_length(layout, held, said)
    elif asked_in and held.explanation.direction == "response":
        answers = "this answers" if held.chosen == "request" else "this does not answer"
        yield f"{answers} the request in line {asked_in}"
    if held.chosen == "likeliest":
        yield _ambiguous(layout, held)
    yield from held.mismatches


def _coded(layout: DeviceLayout, link: str) -> bool:
    """Whether a frame of a link says itself which message it is."""
    return any(layout.links[link].frame(direction).role("code") is not None for direction in DIRECTIONS)


def _ambiguous(layout: DeviceLayout, held: Read) -> str:
    """Which other readings fit, and which options tell them apart."""
    own = held.explanation
    readings = [_own(own), *held.others]
    if all(not _coded(layout, link) for link, _, _, _ in readings):
        bytes_ = f"{len(own.frame)} bytes"
        names = _listed([_sent(layout.device.links[link], way, name) for link, way, name, _ in readings], "or")
        return f"ambiguous: {bytes_} may be {names}; {_options(layout, own, held.others)}"
    others: dict[tuple[str, str, bool], list[str]] = {}
    for link, direction, message, error in held.others:
        others.setdefault((link, direction, error), []).append(message or "an unknown message")
    listed = " or ".join(_named(layout, own, *key, names) for key, names in others.items())
    explained = _named(layout, own, own.link, own.direction, own.error, [own.message or "an unknown message"])
    return f"ambiguous: explained as {explained}, it may also be {listed}; {_options(layout, own, held.others)}"


def _own(held: Explanation) -> Reading:
    return held.link, held.direction, held.message, held.error


def _options(layout: DeviceLayout, own: Explanation, others: Sequence[Reading]) -> str:
    """The options that tell the readings apart: those of which one is enough, else all that help."""
    words = {layout.device.links[link].message_name for link in (own.link, *(other[0] for other in others))}
    word = f"--{option_word(words.pop())}" if len(words) == 1 else "--message"
    telling = {
        "--link": [link != own.link for link, _, _, _ in others],
        "--direction": [direction != own.direction for _, direction, _, _ in others],
        word: [message != own.message for _, _, message, _ in others],
    }
    if own.direction == "response" and _asks(layout, own.link) and any(telling[word]):
        telling = {"--request": telling[word], **telling}
    enough = [option for option, tells in telling.items() if all(tells)]
    if enough:
        return f"{' or '.join(enough)} tells"
    return f"{' and '.join(option for option, tells in telling.items() if any(tells))} tell"


def _asks(layout: DeviceLayout, link: str) -> bool:
    """Whether the request says which message a response on a link is."""
    return layout.links[link].request.role("code") is not None


def _named(
    layout: DeviceLayout, own: Explanation, link: str, direction: str, error: bool, messages: Sequence[str]
) -> str:
    """`the response to stop on rtu`, or `a response to one of 28 messages: stop, move, homing, ..`"""
    place = "" if link == own.link else f" on {link}"
    names = ", ".join(messages if len(messages) <= _NAMED else [*messages[:_NAMED], ".."])
    name = layout.device.links[link].direction_name(direction)
    if name not in DIRECTIONS and not error:
        return (
            f"{messages[0]} {name}{place}" if len(messages) == 1 else f"one of {len(messages)} {name}{place} ({names})"
        )
    kind = "refusal" if error else direction
    joint = "of" if kind != "response" else "to"
    if len(messages) == 1:
        return f"the {kind} {joint} {messages[0]}{place}"
    return f"a {kind} {joint} one of {len(messages)} messages{place} ({names})"


def _sent(link: Link, direction: str, message: str) -> str:
    """`telegram_3 sent`"""
    return f"{message} {link.direction_name(direction)}"


def _listed(names: Iterable[str], last: str) -> str:
    """`a, b or c`"""
    *rest, end = names
    return f"{', '.join(rest)} {last} {end}" if rest else end


def _of_other_length(layout: DeviceLayout, held: Read, said: Given) -> Iterator[str]:
    """How long the messages are, where the length alone tells which one a frame is, and tells none."""
    own = held.explanation
    link = layout.links[own.link]
    if _coded(layout, own.link) or not {"wrong_length", "incomplete", "unknown_code"} & set(own.reasons):
        return
    names = [said.message] if said.message in link.messages else list(link.messages)
    ways = [direction for direction in DIRECTIONS if said.goes(own.link, direction)]
    sizes = (
        f"{_sent(link.link, direction, name)} has {_bounds(*lengths(link, direction, name))}"
        for name in names
        for direction in ways
    )
    yield f"the frame has {len(own.frame)} bytes; {', '.join(sizes)}"


def _bounds(least: int, most: int | None) -> str:
    if most is None:
        return f"{least} or more"
    return str(least) if most == least else f"{least} to {most}"
