"""What messages carry and `live` does not read by itself, and why."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain.hazards import is_argument, is_query, is_single, reads_state
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout

ADVICE = "it is for the generated client, or for `fieldspec encode` and `fieldspec decode`"
"""Where such a message is sent and read."""


def reason_unread(link: LinkLayout, name: str) -> str:
    """Why a message, or `message.field`, has nothing that is read by name; empty for what the link does not have."""
    own, _, field_name = name.partition(".")
    message = link.exchanged.get(own)
    if message is None:
        return ""
    arguments = [field.name for field in message.request.fields if is_argument(field)]
    if arguments:
        return f"{own} asks with {', '.join(arguments)}, and `live` sends no arguments"
    lists = _lists(message)
    if field_name and field_name not in lists:
        return ""
    if not lists:
        return f"{own} answers with no value"
    return f"{name} is a list or a record" if field_name else f"{own} answers with lists and records only"


def remarks(layout: DeviceLayout, link: LinkLayout, names: Sequence[str]) -> Iterator[str]:
    """The values of messages that are not read with some names, or without names."""
    asking = [
        message
        for message in link.exchanged.values()
        if not any(is_argument(field) for field in message.request.fields)
    ]
    chosen = [message for message in asking if message.name in names or not names]
    unsent = [message for message in chosen if not names and is_query(message) and not reads_state(layout, message)]
    if unsent:
        text = "not asked without their names, because nothing in the spec shows that they only read"
        yield f"{text}: {', '.join(message.name for message in unsent)}"
    lists = [f"{message.name}.{name}" for message in chosen if message not in unsent for name in _lists(message)]
    if lists:
        yield f"lists and records, which are for the generated client: {', '.join(lists)}"


def _lists(message: MessageLayout) -> list[str]:
    """The fields of a response with more than one value."""
    list_fields = (field for field in message.response.fields if field.is_list or field.value is None)
    return [field.name for field in list_fields if not field.field.reserved and not is_single(field)]
