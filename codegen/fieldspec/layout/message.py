"""The data of a message in both directions."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.layout.record import RecordLayout
from fieldspec.model.message import Message


@dataclass(frozen=True, slots=True)
class MessageLayout:
    """The data of a message's request and response."""

    message: Message
    name: str
    request: RecordLayout
    response: RecordLayout

    def data(self, direction: str) -> RecordLayout:
        """The data in one direction."""
        return self.request if direction == "request" else self.response
