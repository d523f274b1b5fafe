"""The data of messages."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.record import Message


@dataclass(frozen=True, slots=True)
class MessageLayout:
    """The data of a message's request and response."""

    message: Message
    name: str
    request: RecordLayout
    response: RecordLayout

    def data(self, direction: str) -> RecordLayout:
        """The data in one direction, `request` or `response`."""
        return self.request if direction == "request" else self.response

    @property
    def bodies(self) -> tuple[RecordLayout, ...]:
        """The data that frames carry: of the request, of the response, or of both, as `Message.directions` says."""
        return tuple(map(self.data, self.message.directions))
