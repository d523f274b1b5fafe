"""Why bytes are not a valid frame: a missing checksum, bytes around the frame, or another version of the device."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from fieldspec.codec.explain.readings import ChosenReading, FrameOptions, read
from fieldspec.codec.explain.recognition import Reading, recognised
from fieldspec.codec.explain.row import unwrapped
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.command.console.usage import UsageError
from fieldspec.command.frames.frame_options import frame_options
from fieldspec.command.sources import specs

_LONGEST = 1024
"""The size up to which bytes are searched for a frame."""


class FrameHints:
    """Finds out why bytes are not a valid frame of a device. `arguments` are the arguments of the command."""

    def __init__(self, layout: DeviceLayout, options: FrameOptions, arguments: argparse.Namespace) -> None:
        self.layout, self.options, self.arguments = layout, options, arguments
        self._versions: list[tuple[DeviceLayout, FrameOptions]] | None = None

    def of(self, reading: ChosenReading) -> Iterator[str]:
        """The first reason that explains the bytes of a wrong reading; nothing for a right one."""
        frame = reading.explanation.frame
        if not reading.wrong or len(frame) > _LONGEST:
            return
        for reason in (self._missing_checksum, self._surrounded, self._of_another_version):
            texts = list(reason(frame))
            if texts:
                yield from texts
                return

    def _places(self) -> Iterator[tuple[LinkLayout, str]]:
        for link in self.layout.links.values():
            for direction in ("request", "response"):
                if self.options.goes(link.name, direction):
                    yield link, direction

    def _valid(self, frame: bytes, link: LinkLayout, direction: str) -> Reading | None:
        """The reading of a frame without faults in a direction of a link."""
        readings = recognised(self.layout, frame)
        fitting = (own for own in readings if own[:2] == (link.name, direction) and self.options.allows(own))
        reading = next(fitting, None)
        return None if reading is None or _is_wrong(self.layout, frame, reading) else reading

    def _missing_checksum(self, frame: bytes) -> Iterator[str]:
        """The frames that result if the checksum is added."""
        from fieldspec.codec.reference import codec

        for link, direction in self._places():
            shape = link.frame(direction)
            checks = shape.checksums
            if not checks or shape.escape is not None or len(shape.trailer) != len(checks):
                continue
            data = unwrapped(link.link, direction, frame).data + bytes(sum(check.size for check in checks))
            if len(data) < shape.header_size + shape.trailer_size:
                continue
            own = codec(self.layout).links[link.name]
            parts = own.with_checksum(direction, data)
            completed = own.joined_parts(direction, parts)
            reading = self._valid(completed, link, direction)
            if reading is not None:
                added = parts[-sum(check.size for check in checks) :].hex(" ").upper()
                names = " and ".join(check.name for check in checks)
                yield f"the checksum is missing: with {names} {added}, this is {_text(reading)}: {_hex(completed)}"

    def _surrounded(self, frame: bytes) -> Iterator[str]:
        """The valid frames among the bytes, with their positions."""
        from fieldspec.tools.simulator import codecs

        module = codecs.device_module(self.layout)
        visited = set()
        for link, direction in self._places():
            framer = codecs.framer(module, link.name, direction)
            has_evidence = link.frame(direction).checksums or any(link.link.delimiters(direction))
            for inner in [*framer.feed(frame), *framer.idle()] if framer is not None and has_evidence else ():
                start = frame.find(inner)
                if inner == frame or start < 0 or inner in visited:
                    continue
                reading = self._valid(inner, link, direction)
                if reading is not None:
                    visited.add(inner)
                    end = start + len(inner) - 1
                    surplus = [f"{start} before" if start else "", f"{len(frame) - 1 - end} after"]
                    surplus_text = " and ".join(side for side in surplus if side and not side.startswith("0 "))
                    yield f"bytes {start}..{end} are {_text(reading)}, with {surplus_text} it: {_hex(inner)}"

    def _of_another_version(self, frame: bytes) -> Iterator[str]:
        """The other versions that read the frame without a fault."""
        if self._versions is None:
            self._versions = list(self._other_versions())
        for layout, options in self._versions:
            if not recognised(layout, frame):
                continue
            reading = read(layout, frame, options)
            if not reading.wrong:
                own = reading.explanation
                text = _text((own.link, own.direction, own.message, own.error))
                device = f"{layout.device.id}@{layout.device.version}"
                yield f"version {layout.device.version} reads it as {text}: fieldspec decode {device} {frame.hex()}"

    def _other_versions(self) -> Iterator[tuple[DeviceLayout, FrameOptions]]:
        spec, version = specs.spec_at(self.arguments.specs, self.arguments.device)
        for name in spec.versions():
            if name == version:
                continue
            layout = specs.layout_of(spec, name)
            try:
                yield layout, frame_options(layout, self.arguments)
            except UsageError:
                continue  # this version has no such link or message


def _is_wrong(layout: DeviceLayout, frame: bytes, reading: Reading) -> bool:
    """Whether a value of a frame is wrong."""
    link, direction, message, _ = reading
    return read(layout, frame, FrameOptions(((link, direction),), message)).wrong


def _text(reading: Reading) -> str:
    """`a valid read_registers request on rtu`"""
    link, direction, message, error = reading
    return f"a valid {message or 'unknown'} {'exception response' if error else direction} on {link}"


def _hex(frame: bytes) -> str:
    return frame.hex(" ").upper()
