"""Layouts whose devices know what has been read of them."""

from __future__ import annotations

from fieldspec.codec.layout.device import LAYOUT_ATTRIBUTES, DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import attributes, replace
from fieldspec.foundation.observation import is_same, observed, read_attributes
from fieldspec.language.model.device import Device, Version, VersionLine
from fieldspec.language.model.fact import Fact, Place
from fieldspec.language.model.link import Link


def observed_layout(layout: DeviceLayout) -> DeviceLayout:
    """A layout whose device, with its versions and its links, knows what is read of it."""
    device = observed(layout.device, (VersionLine, Version, Link, Place))
    links = {name: _with_link(link, device.links[name]) for name, link in layout.links.items()}
    return replace(layout, device=device, links=links)


def _with_link(layout: LinkLayout, link: Link) -> LinkLayout:
    """The layout of an observed link. The attributes that a link has and other facts lack count as read."""
    for name in {*attributes(Link)}.difference(attributes(Fact)):
        getattr(link, name)
    # The layout of remote requests has other parts than its link states.
    parts = {name: getattr(layout.link, name) for name in ("request", "response", "escape")}
    return replace(layout, link=replace(link, **parts))


def read_of_layout(layout: DeviceLayout) -> dict[str, object]:
    """The attributes of the device of an observed layout on which a result depends that has read the layout."""
    return {name: getattr(layout.device, name) for name in LAYOUT_ATTRIBUTES} | read_attributes(layout.device)


def is_same_device(attributes: dict[str, object], device: Device) -> bool:
    """Whether a device has the same attributes, in all that was read of them."""
    return all(is_same(value, getattr(device, name)) for name, value in attributes.items())


def is_same_layout(earlier: DeviceLayout, layout: DeviceLayout) -> bool:
    """Whether a result that has read an observed layout would read the same of another layout."""
    return earlier.identity == layout.identity and is_same_device(read_of_layout(earlier), layout.device)
