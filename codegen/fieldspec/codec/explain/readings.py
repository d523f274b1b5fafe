"""Chooses what a frame is, its link, direction and message, and says how certain that is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.examples import examples_of_bytes
from fieldspec.codec.explain.explanation import Explanation, explained
from fieldspec.codec.explain.frame_sizes import bounds_text, size_text
from fieldspec.codec.explain.option_names import option_text
from fieldspec.codec.explain.recognition import Reading, closest, lengths, recognised
from fieldspec.codec.explain.values import fault_of
from fieldspec.codec.layout.bits import packed_size
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.link import Link

DIRECTIONS = ("request", "response")


@dataclass(frozen=True, slots=True)
class FrameOptions:
    """The options of the user about frames. `places` are links and directions; an empty option leaves all open."""

    places: tuple[tuple[str, str], ...] = ()
    message: str = ""

    def allows(self, reading: Reading) -> bool:
        """Whether a reading agrees with the options."""
        link, direction, message, _ = reading
        return self.goes(link, direction) and (not self.message or self.message == message)

    def goes(self, link: str, direction: str) -> bool:
        """Whether the options allow a direction on a link."""
        return not self.places or (link, direction) in self.places

    @property
    def directions(self) -> frozenset[str]:
        """The directions that the options allow."""
        return frozenset(direction for _, direction in self.places) if self.places else frozenset(DIRECTIONS)


@dataclass(frozen=True, slots=True)
class OpenRequest:
    """The request that the next response answers. `sure` if the user has named it."""

    request: Explanation
    sure: bool


@dataclass(frozen=True, slots=True)
class ChosenReading:
    """The explanation of a frame under the chosen reading.

    `readings` are all readings that fit, none if the frame is wrong under all of them. `chosen` says why this reading
    is explained: it is the `only` one that fits; the `request` before it or a `mark` in the log decided between
    several; nothing did, and it is the `likeliest`; none fits, and it is the `closest`.
    `mismatches` say where a response does not fit its request.
    """

    explanation: Explanation
    readings: tuple[Reading, ...]
    chosen: str
    mismatches: tuple[str, ...] = ()

    @property
    def wrong(self) -> bool:
        """Whether a codec refuses the frame, or a response does not fit its request."""
        return bool(self.explanation.reasons or self.mismatches) or not self.readings

    @property
    def alternatives(self) -> tuple[Reading, ...]:
        """The other readings that fit."""
        own = reading_of(self.explanation)
        return tuple(reading for reading in self.readings if reading != own)


def read_frame(
    layout: DeviceLayout, frame: bytes, options: FrameOptions, mark: str = "", open_request: OpenRequest | None = None
) -> ChosenReading:
    """The explanation of a frame. `mark` is the direction that a log tells, which may be wrong."""
    answer = (
        _answer(layout, frame, open_request) if open_request is not None and "response" in options.directions else None
    )
    if (
        open_request is not None
        and answer is not None
        and (open_request.sure or (mark != "request" and not answer.wrong))
    ):
        return answer
    examples = _examples(layout, frame)
    readings = (_named_by_example(reading, examples) for reading in recognised(layout, frame))
    named_readings = (_named_by_option(layout, frame, reading, options) for reading in readings)
    fitting = [reading for reading in named_readings if options.allows(reading)]
    if not fitting:
        closest_reading = _closest(layout, frame, options, mark)
        # What a log marks as a response, and what is near a request only, is a wrong answer to the request before it.
        is_answer = mark == "response" and closest_reading.explanation.direction != mark
        return answer if answer is not None and is_answer else closest_reading
    fitting = sorted(fitting, key=lambda reading: _doubts(layout, reading, mark, examples))
    marked = [reading for reading in fitting if reading[1] == mark]
    chosen = "only" if len(fitting) == 1 else "mark" if len(marked) == 1 else "likeliest"
    mismatches = _unrepeated(answer, fitting[0]) if answer is not None and chosen != "likeliest" else ()
    return ChosenReading(_explained(layout, frame, fitting[0]), tuple(fitting), chosen, mismatches)


def _unrepeated(answer: ChosenReading, reading: Reading) -> tuple[str, ...]:
    """The parts of the request before it that a response does not repeat, unless the response clearly answers another
    request.
    """
    if answer.explanation.reasons or reading_of(answer.explanation) != reading:
        return ()
    only = all(sentences.NOT_REPEATED in text for text in answer.mismatches)
    return answer.mismatches if only else ()


def _examples(layout: DeviceLayout, frame: bytes) -> list[Reading]:
    """The readings of the examples that have exactly these bytes."""
    return [
        (example.link, example.direction, example.message, example.exception_response)
        for example in examples_of_bytes(layout.device, frame)
        if example.frame == frame
    ]


def _named_by_example(reading: Reading, examples: Sequence[Reading]) -> Reading:
    """A reading, with the message of an example where it is an exception response to one of several messages."""
    link, direction, message, error = reading
    if message or not error:
        return reading
    return next((other for other in examples if other[:2] == (link, direction) and other[3]), reading)


def _named_by_option(layout: DeviceLayout, frame: bytes, reading: Reading, options: FrameOptions) -> Reading:
    """A reading, with the message of the options if it is an exception response that does not say what it answers."""
    link, direction, message, error = reading
    if message or not error or not options.message:
        return reading
    option_reading = reading_of(explained(layout, link, direction, frame, options.message))
    return option_reading if option_reading[2] == options.message and option_reading[3] else reading


def reading_of(explanation: Explanation) -> Reading:
    """The reading of an explanation."""
    return explanation.link, explanation.direction, explanation.message, explanation.error


def _explained(layout: DeviceLayout, frame: bytes, reading: Reading) -> Explanation:
    link, direction, message, _ = reading
    return explained(layout, link, direction, frame, message)


def _doubts(
    layout: DeviceLayout, reading: Reading, mark: str, examples: Sequence[Reading]
) -> tuple[bool, bool, bool, bool]:
    """The doubts about a reading, the gravest first.

    These are the mark in the log, that no example is such a frame, that the message is a guess, and that its length may
    be any.
    """
    link, direction, message, error = reading
    guessed = not error and layout.links[link].is_guessed(direction, message)
    loose = guessed and bool(message) and layout.messages[message].data(direction).size is None
    return bool(mark) and direction != mark, reading not in examples, guessed, loose


def _closest(layout: DeviceLayout, frame: bytes, options: FrameOptions, mark: str) -> ChosenReading:
    """The reading with the fewest faults."""
    named_readings = (_named_by_option(layout, frame, reading, options) for reading in closest(layout, frame))
    candidates = [reading for reading in named_readings if options.allows(reading)]
    if not candidates:
        places = [
            (link, direction) for link in layout.links for direction in DIRECTIONS if options.goes(link, direction)
        ]
        carrying = [
            (link, direction) for link, direction in places if options.message in layout.links[link].carried(direction)
        ]
        # Nobody sends a request on a link whose messages come from the device alone.
        sending = carrying or [(link, direction) for link, direction in places if layout.links[link].carried(direction)]
        candidates = [(link, direction, options.message, False) for link, direction in sending or places]

    examples = _examples(layout, frame)
    reading = min(candidates, key=lambda own: _faults(layout, frame, own, _doubts(layout, own, mark, examples)))
    return ChosenReading(_explained(layout, frame, reading), (), "closest")


def _faults(layout: DeviceLayout, frame: bytes, reading: Reading, doubts: tuple[object, ...]) -> tuple[object, ...]:
    """What makes a reading of a wrong frame less close than others."""
    reasons = _explained(layout, frame, reading).reasons
    return sum(reason in ("wrong_mark", "not_hex") for reason in reasons), doubts, len(reasons)


def _answer(layout: DeviceLayout, frame: bytes, open_request: OpenRequest) -> ChosenReading:
    """The explanation of a frame as the response to a request."""
    request = open_request.request
    response = explained(layout, request.link, "response", frame, request.message, request.frame)
    mismatches = tuple(_mismatches(layout, request, response))
    return ChosenReading(
        response,
        () if response.reasons else (reading_of(response),),
        "closest" if response.reasons else "request",
        mismatches,
    )


def _mismatches(layout: DeviceLayout, request: Explanation, response: Explanation) -> Iterator[str]:
    """The places where a response does not fit its request."""
    for role in ("unit_address", "code"):
        ours = layout.links[request.link].request.role(role)
        theirs = layout.links[request.link].response.role(role)
        expected = request.values.get(ours.name) if ours else None
        actual = response.values.get(theirs.name) if theirs else None
        if role == "code" and _has_code_of_its_own(layout, response):
            continue  # it marks the exception responses to all requests
        announced = layout.messages.get(request.message)
        if role == "code" and announced is not None and announced.message.has_response_code:
            expected = announced.message.code_of("response")
            assert expected is not None
            if theirs and isinstance(actual, int) and actual != expected:
                yield sentences.ANOTHER_CODE.format(
                    name=theirs.name,
                    actual=theirs.number_text(actual),
                    expected=theirs.number_text(expected),
                    message=request.message,
                )
            continue
        if ours and isinstance(expected, int) and isinstance(actual, int) and actual != expected:
            yield sentences.ANOTHER_NUMBER.format(name=ours.name, actual=actual, expected=expected)
    for row in response.rows:
        if row.verdict.startswith("wrong") and not row.reason:
            yield sentences.PART_NOT_REPEATED.format(path=row.path, fault=fault_of(row.verdict))
    message = layout.messages.get(response.message)
    access = message.message.single_access if message and not response.error else None
    if access is not None and access.operation == "read":
        unit = layout.device.space(access.space).unit
        expected = request.values.get(access.count) if access.count else None if unit == BIT else 1
        actual = response.values.get(access.values)
        if isinstance(expected, int) and isinstance(actual, list):
            size = packed_size(expected) if unit == BIT else expected
            if len(actual) != size:
                sentence = sentences.ASKED_BITS if unit == BIT else sentences.ASKED_VALUES
                yield sentence.format(expected=expected, unit=unit, size=size, actual=len(actual))


def _has_code_of_its_own(layout: DeviceLayout, response: Explanation) -> bool:
    """Whether a response is an exception response whose code is not that of its request."""
    refusal = layout.links[response.link].link.exception_response
    return response.error and refusal is not None and refusal.code is not None


_NAMED = 3


def remarks_on(layout: DeviceLayout, chosen: ChosenReading, asked_in: int, options: FrameOptions) -> Iterator[str]:
    """The remarks on a frame. `asked_in` is the line of the request before it, 0 if there is none."""
    if chosen.chosen == "closest":
        yield sentences.CLOSEST.format(device=layout.device.id)
        yield from _of_other_length(layout, chosen, options)
    elif asked_in and chosen.explanation.direction == "response" and not _is_unrequested(layout, chosen):
        answers = sentences.ANSWERS if chosen.chosen == "request" else sentences.DOES_NOT_ANSWER
        yield answers.format(line=asked_in)
    if chosen.chosen == "likeliest":
        yield _ambiguous(layout, chosen)
    yield from chosen.mismatches


def _is_unrequested(layout: DeviceLayout, chosen: ChosenReading) -> bool:
    """Whether a frame is one that the device sends of its own accord, so that it answers nothing."""
    announced = layout.messages.get(chosen.explanation.message)
    return announced is not None and not announced.message.is_requested


def _coded(layout: DeviceLayout, link: str) -> bool:
    """Whether frames of a link carry the code of their message."""
    return any(layout.links[link].frame(direction).role("code") is not None for direction in DIRECTIONS)


def _ambiguous(layout: DeviceLayout, chosen: ChosenReading) -> str:
    """The remark that other readings fit, and which options tell them apart."""
    own = chosen.explanation
    readings = [reading_of(own), *chosen.alternatives]
    options = _options(layout, own, chosen.alternatives)
    if all(not _coded(layout, link) for link, _, _, _ in readings):
        texts = [_message_text(layout.links[link].link, direction, name) for link, direction, name, _ in readings]
        names = _enumeration(texts, "or")
        return sentences.AMBIGUOUS_SIZE.format(count=len(own.frame), names=names, options=options)
    names_of: dict[tuple[str, str, bool], list[str]] = {}
    for link, direction, message, error in chosen.alternatives:
        names_of.setdefault((link, direction, error), []).append(message or sentences.UNKNOWN_MESSAGE)
    alternatives_text = " or ".join(
        _readings_text(layout, own, link, direction, error, names)
        for (link, direction, error), names in names_of.items()
    )
    own_names = [own.message or sentences.UNKNOWN_MESSAGE]
    explained = _readings_text(layout, own, own.link, own.direction, own.error, own_names)
    return sentences.AMBIGUOUS.format(explained=explained, others=alternatives_text, options=options)


def _options(layout: DeviceLayout, own: Explanation, alternatives: Sequence[Reading]) -> str:
    """The options that tell the readings apart: those that are each enough, else all that help."""
    links = (own.link, *(link for link, _, _, _ in alternatives))
    words = list(dict.fromkeys(layout.links[link].link.message_name for link in links))
    by_message = [message != own.message for _, _, message, _ in alternatives]
    telling = {
        "request": by_message if own.direction == "response" and _asks(layout, own.link) else [False],
        "link": [link != own.link for link, _, _, _ in alternatives],
        "direction": [direction != own.direction for _, direction, _, _ in alternatives],
        words[0] if len(words) == 1 else "message": by_message,
    }
    enough = [option_text(option) for option, tells in telling.items() if all(tells)]
    if enough:
        return sentences.OPTION_TELLS.format(options=" or ".join(enough))
    helpful = [option_text(option) for option, tells in telling.items() if any(tells)]
    return sentences.OPTIONS_TELL.format(options=" and ".join(helpful))


def _asks(layout: DeviceLayout, link: str) -> bool:
    """Whether the request identifies the message of a response on a link."""
    return layout.links[link].request.role("code") is not None


def _readings_text(
    layout: DeviceLayout, own: Explanation, link: str, direction: str, error: bool, messages: Sequence[str]
) -> str:
    """Readings in words: `the response to stop on rtu`, `a response to one of 28 messages (stop, move, homing, ..)`."""
    is_single = len(messages) == 1
    name = layout.links[link].link.direction_name(direction)
    sentence = sentences.READING if is_single else sentences.READINGS
    if name not in DIRECTIONS and not error:
        sentence = sentences.NAMED_MESSAGE if is_single else sentences.NAMED_MESSAGES
    kind = "exception response" if error else direction
    joint = "of" if kind != "response" else "to"
    if kind == "response" and all(not layout.messages[message].message.is_requested for message in messages):
        kind, joint = "frame", "of"  # it answers nothing
    return sentence.format(
        message=messages[0],
        count=len(messages),
        names=", ".join(messages if len(messages) <= _NAMED else [*messages[:_NAMED], ".."]),
        direction=name,
        place="" if link == own.link else sentences.ON_LINK.format(link=link),
        kind=kind,
        joint=joint,
    )


def _message_text(link: Link, direction: str, message: str) -> str:
    """A message with its direction, as remarks name it: `telegram_3 sent`"""
    return sentences.NAMED_MESSAGE.format(message=message, direction=link.direction_name(direction), place="")


def _enumeration(names: Sequence[str], last: str) -> str:
    """`a, b or c`"""
    return f"{', '.join(names[:-1])} {last} {names[-1]}" if len(names) > 1 else names[0]


def _of_other_length(layout: DeviceLayout, chosen: ChosenReading, options: FrameOptions) -> Iterator[str]:
    """The lengths of the messages, if only the length could identify the message, and it matches none."""
    own = chosen.explanation
    link = layout.links[own.link]
    is_of_length = any(reason in ("wrong_length", "incomplete", "unknown_code") for reason in own.reasons)
    if _coded(layout, own.link) or not is_of_length:
        return
    known = {direction: link.carried(direction) for direction in DIRECTIONS}
    names = list(dict.fromkeys((*known["request"], *known["response"])))
    ways = [direction for direction in DIRECTIONS if options.goes(own.link, direction)]
    escape = link.link.escape if link.link.is_can else None
    identifier = 0 if escape is None else escape.fields_size
    sizes = [
        sentences.SIZE_OF_MESSAGE.format(
            message=_message_text(link.link, direction, name),
            size=bounds_text(*lengths(link, direction, name), identifier),
        )
        for name in ([options.message] if options.message in names else names)
        for direction in ways
        if name in known[direction]
    ]
    if sizes:
        yield sentences.SIZES.format(own=size_text(link, own), others=", ".join(sizes))
