"""Why bytes are not a valid frame: a missing checksum, bytes around the frame, or another version of the device."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator

from fieldspec.codec.explain.readings import ChosenReading, FrameOptions, read_frame
from fieldspec.codec.explain.recognition import Reading, recognised
from fieldspec.codec.explain.row import unwrapped
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.command.console.usage import UsageError
from fieldspec.command.frames.frame_options import frame_options
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import dataclass

_LONGEST = 1024
"""The size up to which bytes are searched for a frame."""


ReadFrame = Callable[[bytes], tuple[ChosenReading, int]]
"""Reads a frame. The number is the line of the request that it answers, 0 where there is none."""


@dataclass(frozen=True, slots=True)
class HintedReading:
    """A reading to explain, the line of its request (0 where there is none), and why the bytes are not a frame."""

    reading: ChosenReading
    asked_in: int
    hints: tuple[str, ...]


class FrameHints:
    """Finds out why bytes are not a valid frame of a device. `arguments` are the arguments of the command."""

    def __init__(self, layout: DeviceLayout, options: FrameOptions, arguments: argparse.Namespace) -> None:
        self.layout, self.options, self.arguments = layout, options, arguments
        self._versions: list[tuple[DeviceLayout, FrameOptions]] | None = None

    def readings(self, frame: bytes, read_frame: ReadFrame) -> list[HintedReading]:
        """The readings that explain the bytes, each with the first reason why they are not a valid frame.

        Valid frames among the bytes are explained instead of the bytes as a whole. `read_frame` reads a frame.
        """
        reading, asked_in = read_frame(frame)
        if not reading.wrong or len(frame) > _LONGEST:
            return [HintedReading(reading, asked_in, ())]
        texts = tuple(self._missing_checksum(frame))
        if texts:
            return [HintedReading(reading, asked_in, texts)]
        inner = [HintedReading(*read_frame(inner_frame), (text,)) for inner_frame, text in self._surrounded(frame)]
        return inner or [HintedReading(reading, asked_in, tuple(self._of_another_version(frame)))]

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

    def _surrounded(self, frame: bytes) -> Iterator[tuple[bytes, str]]:
        """The valid frames among the bytes, each with its position and what is around it."""
        from fieldspec.tools.simulator import codecs

        module = codecs.device_module(self.layout)
        inner_frames: dict[int, tuple[bytes, str]] = {}
        for link, direction in self._places():
            framer = codecs.framer(module, link.name, direction)
            has_evidence = link.frame(direction).checksums or any(link.link.delimiters(direction))
            end = 0
            for inner in [*framer.feed(frame), *framer.idle()] if framer is not None and has_evidence else ():
                start = frame.find(inner, end)
                if inner == frame or start < 0:
                    continue
                end = start + len(inner)
                reading = None if start in inner_frames else self._valid(inner, link, direction)
                if reading is not None:
                    surplus = [f"{start} before" if start else "", f"{len(frame) - end} after"]
                    surplus_text = " and ".join(side for side in surplus if side and not side.startswith("0 "))
                    text = f"bytes {start}..{end - 1} are {_text(reading)}, with {surplus_text} it: {_hex(inner)}"
                    inner_frames[start] = inner, text
        for start in sorted(inner_frames):
            yield inner_frames[start]

    def _of_another_version(self, frame: bytes) -> Iterator[str]:
        """The other versions that read the frame without a fault."""
        if self._versions is None:
            self._versions = list(self._other_versions())
        for layout, options in self._versions:
            if not recognised(layout, frame):
                continue
            reading = read_frame(layout, frame, options)
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
    return read_frame(layout, frame, FrameOptions(((link, direction),), message)).wrong


def _text(reading: Reading) -> str:
    """`a valid read_registers request on rtu`"""
    link, direction, message, error = reading
    return f"a valid {message or 'unknown'} {'exception response' if error else direction} on {link}"


def _hex(frame: bytes) -> str:
    return frame.hex(" ").upper()
