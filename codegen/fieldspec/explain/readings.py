"""The link, direction and message of a frame, how certain they are, and remarks about them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.classes import dataclass
from fieldspec.explain.explanation import Explanation, Reading, closest, explained, lengths, recognised
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.link import Link

DIRECTIONS = ("request", "response")


@dataclass(frozen=True, slots=True)
class FrameOptions:
    """What the user says of frames; empty where he leaves it to us. `places` are the links and directions."""

    places: tuple[tuple[str, str], ...] = ()
    message: str = ""

    def allows(self, reading: Reading) -> bool:
        """Whether a reading is one of those that the user means."""
        link, direction, message, _ = reading
        return self.goes(link, direction) and (not self.message or self.message == message)

    def goes(self, link: str, direction: str) -> bool:
        """Whether a frame may go this way on a link."""
        return not self.places or (link, direction) in self.places

    @property
    def directions(self) -> frozenset[str]:
        """The directions that are meant."""
        return frozenset(direction for _, direction in self.places) if self.places else frozenset(DIRECTIONS)


def option_word(name: str) -> str:
    """A word of the device as an option has it."""
    return name.replace("_", "-")


@dataclass(frozen=True, slots=True)
class OpenRequest:
    """The request that the next response answers. `sure` says that the user has named it."""

    request: Explanation
    sure: bool


@dataclass(frozen=True, slots=True)
class ChosenReading:
    """A frame's explanation under one reading.

    `readings` are all that fit; none where the frame is wrong under every one of them. `chosen` says how the one
    was found that is explained: `only` one fits; the `request` before it or a `mark` in the log chose among
    several, or nothing but likelihood did (`likeliest`); none fits, and this is the `closest`.
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
    def others(self) -> tuple[Reading, ...]:
        """The other readings that fit as well."""
        own = _reading(self.explanation)
        return tuple(reading for reading in self.readings if reading != own)


def read(
    layout: DeviceLayout, frame: bytes, given: FrameOptions, mark: str = "", asked: OpenRequest | None = None
) -> ChosenReading:
    """The explanation of a frame. `mark` is the direction that a log says, which need not be true."""
    if asked is not None and "response" in given.directions:
        answer = _answer(layout, frame, asked)
        if asked.sure or (mark != "request" and not answer.wrong):
            return answer
    fitting = [reading for reading in recognised(layout, frame) if given.allows(reading)]
    if not fitting:
        return _closest(layout, frame, given, mark)
    examples = _examples(layout, frame)
    fitting.sort(key=lambda reading: _doubts(layout, reading, mark, examples))
    marked = [reading for reading in fitting if reading[1] == mark]
    chosen = "only" if len(fitting) == 1 else "mark" if len(marked) == 1 else "likeliest"
    return ChosenReading(_explained(layout, frame, fitting[0]), tuple(fitting), chosen)


def _examples(layout: DeviceLayout, frame: bytes) -> frozenset[Reading]:
    """The readings of the examples of the spec that have exactly these bytes."""
    return frozenset(
        (example.link, example.direction, example.message, example.exception_response)
        for example in layout.device.examples.values()
        if example.frame == frame
    )


def _reading(held: Explanation) -> Reading:
    return held.link, held.direction, held.message, held.error


def _explained(layout: DeviceLayout, frame: bytes, reading: Reading) -> Explanation:
    link, direction, message, error = reading
    return explained(layout, link, direction, frame, "" if error else message)


def _doubts(
    layout: DeviceLayout, reading: Reading, mark: str, examples: frozenset[Reading]
) -> tuple[bool, bool, bool, bool]:
    """What speaks against a reading, the worst first: the mark, that no example of the spec has it, a message that is
    guessed, and that any length fits.
    """
    link, direction, message, _ = reading
    guessed = layout.links[link].frame(direction).role("code") is None
    loose = guessed and bool(message) and layout.messages[message].data(direction).size is None
    return bool(mark) and direction != mark, reading not in examples, guessed, loose


def _closest(layout: DeviceLayout, frame: bytes, given: FrameOptions, mark: str) -> ChosenReading:
    """The reading of which the least is wrong."""
    near = [reading for reading in closest(layout, frame) if given.allows(reading)]
    if not near:
        places = ((link, direction) for link in layout.links for direction in DIRECTIONS)
        near = [(*place, given.message, False) for place in places if given.goes(*place)]

    examples = _examples(layout, frame)

    def faults(reading: Reading) -> tuple[object, ...]:
        held = _explained(layout, frame, reading)
        marks = sum(reason in ("wrong_mark", "not_hex") for reason in held.reasons)
        return marks, _doubts(layout, reading, mark, examples), len(held.reasons)

    return ChosenReading(_explained(layout, frame, min(near, key=faults)), (), "closest")


def _answer(layout: DeviceLayout, frame: bytes, asked: OpenRequest) -> ChosenReading:
    """A frame as the response to a request."""
    request = asked.request
    held = explained(layout, request.link, "response", frame, request.message, request.frame)
    mismatches = tuple(_mismatches(layout, request, held))
    return ChosenReading(
        held, () if held.reasons else (_reading(held),), "closest" if held.reasons else "request", mismatches
    )


def _mismatches(layout: DeviceLayout, request: Explanation, response: Explanation) -> Iterator[str]:
    """Where a response does not fit its request."""
    for role in ("unit_address", "code"):
        ours = layout.links[request.link].request.role(role)
        theirs = layout.links[request.link].response.role(role)
        want = request.values.get(ours.name) if ours else None
        have = response.values.get(theirs.name) if theirs else None
        if ours and isinstance(want, int) and isinstance(have, int) and have != want:
            yield f"{ours.name} is {have}, and {want} in the request"
    for row in response.rows:
        if row.verdict.startswith("wrong") and not row.reason:
            yield f"{row.path} does not repeat the request: {row.verdict.removeprefix('wrong: ')}"
    laid = layout.messages.get(response.message)
    accesses = layout.device.register_access(laid.message) if laid and not response.error else None
    if accesses is not None and accesses.operation == "read":
        want = request.values.get(accesses.count) if accesses.count else 1
        have = response.values.get(accesses.values)
        words = len(have) if isinstance(have, list) else None
        if isinstance(want, int) and words is not None and words != want:
            yield f"the request asks for {want} words, and the response has {words}"


_NAMED = 3


def remarks(layout: DeviceLayout, held: ChosenReading, asked_in: int, said: FrameOptions) -> Iterator[str]:
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


def _ambiguous(layout: DeviceLayout, held: ChosenReading) -> str:
    """Which other readings fit, and which options tell them apart."""
    own = held.explanation
    readings = [_reading_of(own), *held.others]
    if all(not _coded(layout, link) for link, _, _, _ in readings):
        bytes_ = f"{len(own.frame)} bytes"
        names = _alternatives([_sent(layout.device.links[link], way, name) for link, way, name, _ in readings], "or")
        return f"ambiguous: {bytes_} may be {names}; {_options(layout, own, held.others)}"
    others: dict[tuple[str, str, bool], list[str]] = {}
    for link, direction, message, error in held.others:
        others.setdefault((link, direction, error), []).append(message or "an unknown message")
    listed = " or ".join(_named(layout, own, *key, names) for key, names in others.items())
    explained = _named(layout, own, own.link, own.direction, own.error, [own.message or "an unknown message"])
    return f"ambiguous: explained as {explained}, it may also be {listed}; {_options(layout, own, held.others)}"


def _reading_of(held: Explanation) -> Reading:
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


def _alternatives(names: Iterable[str], last: str) -> str:
    """`a, b or c`"""
    *rest, end = names
    return f"{', '.join(rest)} {last} {end}" if rest else end


def _of_other_length(layout: DeviceLayout, held: ChosenReading, said: FrameOptions) -> Iterator[str]:
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
