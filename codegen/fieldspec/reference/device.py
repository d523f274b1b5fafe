"""The codec of a whole device."""

from __future__ import annotations

import construct

from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.reference.frames import FrameCodec
from fieldspec.reference.records import record_struct


@dataclass(frozen=True, slots=True)
class DeviceCodec:
    """A device's records and message data as construct Structs, and its links as frame codecs.

    The data of a message are under `<message>_request` and `<message>_response`.
    """

    layout: DeviceLayout
    records: dict[str, construct.Struct]
    links: dict[str, FrameCodec]


def codec(layout: DeviceLayout) -> DeviceCodec:
    """The codec of a layout."""
    records = {name: record_struct(record) for name, record in layout.records.items()}
    for message in layout.messages.values():
        for data in (message.request, message.response):
            records[data.name] = record_struct(data)
    return DeviceCodec(layout, records, {name: FrameCodec(layout, link) for name, link in layout.links.items()})
