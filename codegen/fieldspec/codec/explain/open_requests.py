"""The requests of a log that may still be answered."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.explain.explained_frame import Explanation
from fieldspec.codec.explain.readings import ChosenReading, OpenRequest
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.repeated_parts import repeated_parts

_MOST_OPEN = 64
"""The requests without an answer that are remembered."""


class OpenRequests:
    """Reads each frame of a log as the answer to a request before it, if it is one.

    `asked` is the request that the user names for all responses. `open` are the requests that may still be answered,
    each with its line, the newest last: one for each of the values that responses repeat. `read` reads a frame as the
    answer to a request.
    """

    def __init__(
        self,
        layout: DeviceLayout,
        named_request: OpenRequest | None,
        read: Callable[[bytes, OpenRequest | None], ChosenReading],
    ) -> None:
        self.layout, self.asked, self.read = layout, named_request, read
        self.open: list[tuple[OpenRequest, int]] = []
        self.repeated = {name: repeated_parts(link) for name, link in layout.links.items()}

    def reading(self, frame: bytes) -> tuple[ChosenReading, int]:
        """The reading of a frame, and the line of the request before it that counts; 0 where there is none."""
        if self.asked is not None or not self.open:
            return self.read(frame, self.asked), 0
        nearest = None
        for open_request, line in self.open[::-1]:
            own = self.read(frame, open_request), line
            if own[0].chosen == "request":
                return own
            if nearest is None or (own[0].mismatches and not nearest[0].mismatches):
                nearest = own
        assert nearest is not None
        return nearest

    def remember(self, reading: ChosenReading, line: int) -> None:
        """Keeps the requests that may still be answered after a frame of a line."""
        if self.asked is None:
            self._close(reading.explanation)
            request = self._request(reading)
            self.open = [*self.open[1 - _MOST_OPEN :], (request, line)] if request is not None else self.open

    def _close(self, frame: Explanation) -> None:
        """Closes the requests that a frame answers, or leaves without an answer."""
        message = self.layout.messages.get(frame.message)
        if message is not None and not message.message.is_requested:
            return  # the device sends it of its own accord
        own = self._numbers(frame)
        self.open = [
            other
            for other in self.open
            if None not in own and other[0].request.link == frame.link and self._numbers(other[0].request) != own
        ]

    def _numbers(self, frame: Explanation) -> list[object]:
        """What responses repeat of their requests, in a request or in a response; None where a frame lacks it."""
        pairs = self.repeated[frame.link]
        return [
            frame.values.get((request_part if frame.direction == "request" else answer).name)
            for request_part, answer in pairs
        ]

    def _request(self, reading: ChosenReading) -> OpenRequest | None:
        """The frame as the request that the next response answers; None for messages without a response."""
        request = reading.explanation
        is_unknown = len(request.reasons) == 1 and request.reasons[0] == "unknown_code"
        if request.direction != "request" or (reading.wrong and not is_unknown):
            return None
        link = self.layout.links[request.link]
        if request.message in link.messages and request.message not in link.carried("response"):
            return None
        if reading.chosen == "likeliest" and link.response.role("code") is None and link.request.role("code") is None:
            return None  # nothing shows that it is a request
        unit_address, addresses = link.request.role("unit_address"), link.link.unit_addresses
        if unit_address and addresses and request.values.get(unit_address.name) == addresses.broadcast:
            return None
        return OpenRequest(request, False)
