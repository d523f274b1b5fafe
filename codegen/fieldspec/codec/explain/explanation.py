"""Explains every byte of a frame, also of one that is wrong.

explanation = explained(layout, "line", "request", frame)
[(row.offset, row.path, row.number, row.verdict) for row in explanation.rows]
# [(0, 'address', 1, ''), (1, 'command', 6, ''), (2, 'size', 300, ''), (4, 'sum', 55, 'right')]
"""

from __future__ import annotations

from fieldspec.codec.explain.explained_frame import Explanation
from fieldspec.codec.explain.frame_rows import explained_after
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.values import Meaning
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.caches import ByIdentity

__all__ = ["Explanation", "ExplanationRow", "Meaning", "explained", "explained_after"]


def explained(
    layout: DeviceLayout, link: str, direction: str, frame: bytes, message: str = "", request: bytes = b""
) -> Explanation:
    """The explanation of a whole frame. `direction` is `request` or `response`.

    `message` names the message of a frame that carries no code. `request` is the frame that a response answers: it
    identifies the message and the registers of the response, if the response does not. Raises KeyError for a link that
    the device does not have, and nothing for any bytes.
    """
    remembered = _EXPLAINED.get_or_compute(layout, lambda _: {})
    key = link, direction, frame, message, request
    explanation = remembered.get(key)
    if explanation is None:
        is_answer = request and direction == "response"
        of_request = explained(layout, link, "request", request, message) if is_answer else None
        explanation = explained_after(layout, link, direction, frame, message, of_request)
        if len(frame) + len(request) <= _LONGEST_REMEMBERED:
            if len(remembered) >= _MOST_REMEMBERED:
                del remembered[next(iter(remembered))]
            remembered[key] = explanation
    return explanation


_LONGEST_REMEMBERED = 300
_MOST_REMEMBERED = 256
_EXPLAINED: ByIdentity[DeviceLayout, dict[tuple[str, str, bytes, str, bytes], Explanation]] = ByIdentity(limit=8)
"""The newest explanations: a frame is read in several ways, then one of them again, and logs repeat their requests."""
