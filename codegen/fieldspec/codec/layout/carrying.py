"""Which messages go over a link, for outputs with an object for each link."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout


def carries(link: LinkLayout, message: MessageLayout) -> bool:
    """Whether a message is sent on a link: one with a code where frames have one, one without where they have none.

    A message that names its links is sent on them with its code left out where they have none.
    """
    coded = link.request.role("code") is not None
    if message.name not in link.messages:
        return False
    return (message.message.code is not None) == coded or (bool(message.message.links) and not coded)


def carries_words(link: LinkLayout, message: MessageLayout) -> bool:
    """Whether a message accesses registers over a link: a response has what it reads, a request what it writes."""
    access = message.message.single_access
    direction = "response" if access is not None and access.operation == "read" else "request"
    return access is not None and carries(link, message) and message.name in link.carried(direction)
