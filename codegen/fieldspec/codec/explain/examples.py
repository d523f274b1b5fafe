"""The examples of a device: their explanations, and how the manual prints them."""

from __future__ import annotations

from collections import deque

from fieldspec.codec.explain.explanation import Explanation, explained
from fieldspec.codec.explain.frame_rows import explained_after
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.observation import is_same_layout, observed_layout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Erratum, Example

_MOST_LAYOUTS = 64


@dataclass(frozen=True, slots=True)
class _Explained:
    """The explanations of examples by id, and a layout whose device knows what they have read."""

    layout: DeviceLayout
    explanations: dict[str, Explanation]


_EXPLAINED: ByIdentity[DeviceLayout, _Explained] = ByIdentity(_MOST_LAYOUTS)
"""By layout. Several outputs ask for each explanation, and the next build asks again."""
_LAST: deque[_Explained] = deque(maxlen=_MOST_LAYOUTS)


def explained_example(layout: DeviceLayout, example: Example) -> Explanation:
    """The explanation of an example's frame, computed once for layouts in which it reads the same."""
    explained_layout = _EXPLAINED.get_or_compute(layout, _explained)
    explanations = explained_layout.explanations
    if example.id not in explanations:
        explanations[example.id] = explained_anew(explained_layout.layout, example)
    return explanations[example.id]


def _explained(layout: DeviceLayout) -> _Explained:
    """The explanations for a layout, with the explanations of an earlier layout in which they have read the same."""
    earlier = next((last for last in reversed(_LAST) if is_same_layout(last.layout, layout)), None)
    result = _Explained(observed_layout(layout), {**earlier.explanations} if earlier is not None else {})
    if earlier is not None:
        is_same_layout(earlier.layout, result.layout)  # reads what the explanations have read
    _EXPLAINED[result.layout] = result  # for the request of a response
    _LAST.append(result)
    return result


def explained_anew(layout: DeviceLayout, example: Example) -> Explanation:
    """The same, computed again, with the rows of its registers."""
    explanation = _explanation(layout, example)
    assert explanation.registers is not None  # which read the layout when they are first asked for
    return explanation


def _explanation(layout: DeviceLayout, example: Example) -> Explanation:
    frame = example.link, example.direction, example.frame, example.message
    request = layout.device.examples.get(example.reply_to)
    if request is None:
        return explained(layout, *frame)
    as_request = example.link, "request", example.message, ""
    if (request.link, request.direction, request.message, request.reply_to) != as_request:
        return explained(layout, *frame, request.frame)
    is_response = example.direction == "response"
    return explained_after(layout, *frame, explained_example(layout, request) if is_response else None)


@dataclass(frozen=True, slots=True)
class Printed:
    """An example as the manual prints it.

    `frame` are its bytes as hexadecimal digits. It is empty if the frame is computed or the manual prints dots for
    parts of it. If only the row of characters is misprinted, the digits are the bytes of that row. `characters` is the
    row of characters, empty if the manual has none. `verdict` is `ok`, `misprint`, or `open` if the manual does not
    decide which bytes are right. `errata` are all errata of the example.
    """

    frame: str
    characters: str
    verdict: str
    errata: tuple[Erratum, ...]


def printed(device: Device, example: Example) -> Printed:
    """The printed form of an example: the misprint of its errata, or else the example itself."""
    errata = tuple(erratum for erratum in device.errata if erratum.fact == example.place.path)
    frames = [erratum for erratum in errata if "frame" in erratum.printed]
    rows = [erratum for erratum in errata if "characters" in erratum.printed]
    characters = _with_controls(rows[0].printed["characters"]) if rows else example.characters
    if example.origin == "computed" or example.elided:
        frame = ""
    elif frames:
        frame = "".join(str(frames[0].printed["frame"]).split()).upper()
    else:
        frame = (characters.encode("latin-1", "replace") if rows else example.frame).hex().upper()
    verdict = "misprint" if frames or rows else "ok"
    if any(erratum.confidence == "open" for erratum in (*frames, *rows)):
        verdict = "open"
    return Printed(frame, characters, verdict, errata)


_BY_BYTES: ByIdentity[Device, dict[bytes, list[Example]]] = ByIdentity(limit=8)


def examples_of_bytes(device: Device, frame: bytes) -> list[Example]:
    """The examples that are a frame, and those that the manual misprints as it, in the order of the spec."""
    return _BY_BYTES.get_or_compute(device, _by_bytes).get(frame, [])


def _by_bytes(device: Device) -> dict[bytes, list[Example]]:
    result: dict[bytes, list[Example]] = {}
    for example in device.examples.values():
        digits = printed(device, example).frame
        for frame in {example.frame, bytes.fromhex(digits)}:
            result.setdefault(frame, []).append(example)
    return result


def _with_controls(characters: object) -> str:
    """The characters of an erratum, whose control characters are written as `\\r` and `\\n`."""
    return str(characters).replace("\\r", "\r").replace("\\n", "\n")
