"""Recognises what a frame may be: its link, direction and message, by the faults that each reading of it has."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.frame_rows import is_damaged
from fieldspec.codec.explain.row import unwrapped
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout

Reading = tuple[str, str, str, bool]
"""A possible interpretation of a frame: its link, direction and message, and whether it is an exception response."""

_OF_VALUES = ("unknown_value", "wrong_const", "wrong_measure")
# The frame carries no code, so its message is a guess. That is not a fault, but a broken frame needs better evidence.
_GUESSED = "guessed"
# The faults that a reading may have. The readings of the first step that any of them passes are the result.
_FITTING = (frozenset((_GUESSED,)), frozenset((*_OF_VALUES, _GUESSED)))
_CLOSE = (
    *_FITTING,
    frozenset((*_OF_VALUES, "wrong_checksum", _GUESSED)),
    frozenset((*_OF_VALUES, "wrong_checksum", "wrong_length", "incomplete")),
)


def recognised(layout: DeviceLayout, frame: bytes) -> list[Reading]:
    """The readings of a frame that fit, in the order of the spec.

    Their delimiters, length, checksum and length of the body are right. Readings with values that a codec refuses
    are returned only if every reading has some. The message is empty for an exception response to a code that the
    device does not have.
    """
    return _readings(layout, frame, _FITTING)


def closest(layout: DeviceLayout, frame: bytes) -> list[Reading]:
    """The readings of a frame without faults, else those with a wrong checksum, else those with a wrong length too."""
    return _readings(layout, frame, _CLOSE)


def _readings(layout: DeviceLayout, frame: bytes, steps: Sequence[frozenset[str]]) -> list[Reading]:
    reasons_of: dict[Reading, frozenset[str]] = {}
    for link in layout.links.values():
        for direction in ("request", "response"):
            if steps is _FITTING and is_damaged(layout, link.name, direction, frame):
                continue
            names = _of_length(link, direction, frame) if steps is _FITTING else list(link.carried(direction))
            if link.frame(direction).role("code") is not None:
                ambiguous = link.ambiguous_codes(direction).values()
                shared = [message.name for messages in ambiguous for message in messages]
                names = ["", *(name for name in shared if name in names)]
            elif direction == "response" and link.has_uncoded_exceptions:
                names.append("")  # an exception response says what it is, and not which message it answers
            for message in names:
                explanation = explained(layout, link.name, direction, frame, message)
                if message and explanation.error:
                    continue
                reasons = frozenset((*explanation.reasons, _GUESSED) if message else explanation.reasons)
                reasons_of.setdefault((link.name, direction, explanation.message, explanation.error), reasons)
    for accepted in steps:
        fitting = [
            reading
            for reading, reasons in reasons_of.items()
            if reasons.issubset(accepted) and (reading[2] or reading[3])
        ]
        if fitting:
            return fitting
    return []


def _of_length(link: LinkLayout, direction: str, frame: bytes) -> list[str]:
    """The messages whose body can be as long as that of the frame."""
    length = len(unwrapped(link.link, direction, frame).data)
    bounds = sent_lengths(link, direction)
    return [name for name, minimum, maximum in bounds if minimum <= length and (maximum is None or length <= maximum)]


def sent_lengths(link: LinkLayout, direction: str) -> Iterator[tuple[str, int, int | None]]:
    """The messages of a direction, with the least and the most bytes between delimiters; None is unbounded."""
    escape = link.frame(direction).escape
    for name in link.carried(direction):
        minimum, maximum = lengths(link, direction, name)
        if escape is not None:
            minimum, maximum = 0, None if maximum is None else escape.most(maximum)
        yield name, minimum, maximum


def lengths(link: LinkLayout, direction: str, message: str) -> tuple[int, int | None]:
    """The least and the greatest size of a message's frames without delimiters, in bytes; None is unbounded."""
    shape, body = link.frame(direction), link.messages[message].data(direction)
    parts_size = shape.header_size + shape.trailer_size
    return body.least + parts_size, None if body.most is None else body.most + parts_size
