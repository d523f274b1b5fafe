"""Devices without the messages whose lists have elements that differ in size, which no controller reads."""

from __future__ import annotations

from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import LinkLayout


def without_tails(layout: DeviceLayout) -> DeviceLayout:
    """The layout without such messages: other findings are looked for in it."""
    absent = {name for name, message in layout.messages.items() if any(body.has_tails for body in message.bodies)}
    if not absent:
        return layout
    messages = {name: message for name, message in layout.messages.items() if name not in absent}
    links = {
        name: LinkLayout(
            link.link,
            name,
            link.request,
            link.response,
            {other: message for other, message in link.messages.items() if other not in absent},
        )
        for name, link in layout.links.items()
    }
    return replace(layout, messages=messages, links=links)
