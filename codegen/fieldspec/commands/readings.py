"""Which link, direction and message a frame has, and how sure that is."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass
from fieldspec.commands.given import DIRECTIONS, Given
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.explanation import Explanation, Reading, closest, explained, recognised


@dataclass(frozen=True, slots=True)
class Asked:
    """The request that the next response answers. `sure` says that the user has named it."""

    request: Explanation
    sure: bool


@dataclass(frozen=True, slots=True)
class Read:
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


def read(layout: DeviceLayout, frame: bytes, given: Given, mark: str = "", asked: Asked | None = None) -> Read:
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
    return Read(_explained(layout, frame, fitting[0]), tuple(fitting), chosen)


def _examples(layout: DeviceLayout, frame: bytes) -> frozenset[Reading]:
    """The readings of the examples of the spec that have exactly these bytes."""
    return frozenset(
        (example.link, example.direction, example.message, example.error)
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


def _closest(layout: DeviceLayout, frame: bytes, given: Given, mark: str) -> Read:
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

    return Read(_explained(layout, frame, min(near, key=faults)), (), "closest")


def _answer(layout: DeviceLayout, frame: bytes, asked: Asked) -> Read:
    """A frame as the response to a request."""
    request = asked.request
    held = explained(layout, request.link, "response", frame, request.message, request.frame)
    mismatches = tuple(_mismatches(layout, request, held))
    return Read(held, () if held.reasons else (_reading(held),), "closest" if held.reasons else "request", mismatches)


def _mismatches(layout: DeviceLayout, request: Explanation, response: Explanation) -> Iterator[str]:
    """Where a response does not fit its request."""
    for role in ("station", "code"):
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
