"""The codec of a whole device."""

from __future__ import annotations

import construct

from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.reference.frames import FrameCodec
from fieldspec.reference.records import record_struct


@dataclass(frozen=True, slots=True)
class DeviceCodec:
    """A device's links as frame codecs."""

    layout: DeviceLayout
    links: dict[str, FrameCodec]

    @property
    def records(self) -> dict[str, construct.Struct]:
        """The records and the data of messages as construct Structs; those are under `<message>_request` and so on."""
        messages = self.layout.messages.values()
        data = (one for message in messages for one in (message.request, message.response))
        return {record.name: record_struct(record) for record in (*self.layout.records.values(), *data)}


def codec(layout: DeviceLayout) -> DeviceCodec:
    """The codec of a layout."""
    return DeviceCodec(layout, {name: FrameCodec(layout, link) for name, link in layout.links.items()})
