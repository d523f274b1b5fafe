"""What takes bytes in the generated Python: decoders of frames, data, registers and parameters, and framers.

It needs nothing but the committed outputs, so that it runs in an environment that has only the fuzzer.
"""

from __future__ import annotations

import importlib
import inspect
import json
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent.parent
GENERATED = ROOT / "generated"
DEVICES = ("ck10", "esc11", "hiwin-e", "tc100")
DIRECTIONS = ("request", "response")

Target = Callable[[bytes], None]


def vectors(device: str) -> list[dict[str, Any]]:
    """The example frames of a device."""
    entries: list[dict[str, Any]] = json.loads((GENERATED / "vectors" / f"{device}.json").read_text("utf-8"))["vectors"]
    return entries


def module(device: str) -> Any:
    """The generated module of its newest version."""
    package = str(GENERATED / "python")
    if package not in sys.path:
        sys.path.insert(0, package)
    name = f"fieldspec_devices.{device.replace('-', '_')}"
    stems = [path.stem for path in (GENERATED / "python" / name.replace(".", "/")).glob("v*.py")]
    # Beside the module of a version is that of its client.
    versions = [stem for stem in stems if stem[1:].replace("_", "").isdigit()]
    return importlib.import_module(f"{name}.{max(versions, key=_order)}")


def _order(version: str) -> list[int]:
    return [int(part) for part in version[1:].split("_")]


def codec_error() -> type[Exception]:
    """The one exception that bytes may cause."""
    error: type[Exception] = importlib.import_module("fieldspec_devices").CodecError
    return error


def links(device: str) -> dict[str, Any]:
    """Its links by the names of the spec."""
    generated = module(device)
    return {name: getattr(generated, name) for name in sorted({str(vector["link"]) for vector in vectors(device)})}


def golden(device: str, link: str, direction: str) -> list[bytes]:
    """The right frames of a link in a direction, each once."""
    frames = [
        bytes.fromhex(vector["right"])
        for vector in vectors(device)
        if (vector["link"], vector["direction"]) == (link, direction) and not vector["refused"]
    ]
    return list(dict.fromkeys(frames))


def framers(device: str) -> Iterator[tuple[str, str, Callable[[], Any]]]:
    """The framers of its links: the link, the direction, and what makes a new one. Some links need none."""
    for name, link in links(device).items():
        for direction in DIRECTIONS:
            make = getattr(link, f"{direction}_framer", None)
            if make is not None:
                yield name, direction, make


def targets(device: str) -> list[tuple[str, Target]]:
    """Everything of a device that takes bytes, by name, always in the same order."""
    generated = module(device)
    error = codec_error()
    by_name = {_name(device, vector): vector for vector in vectors(device) if not vector["refused"]}
    result = [(name, _frame(device, vector, error)) for name, vector in by_name.items()]
    for link, direction, make in framers(device):
        result.append((f"{link} {direction} framer", _stream(make)))
    for name in generated.__all__:
        codec = getattr(generated, name)
        if hasattr(codec, "decode"):
            result.append((name, _data(codec, error)))
        elif type(codec).__name__.endswith("Set"):
            result += [(f"{name} {parameter!r}", _data(parameter, error)) for parameter in codec]
    return result


def seeds(device: str) -> Iterator[tuple[str, bytes]]:
    """Inputs to begin with: the name of a target, and its bytes."""
    for vector in vectors(device):
        frame = bytes.fromhex(vector["right"])
        yield _name(device, vector), frame
        if hasattr(links(device)[vector["link"]], "request_framer"):
            yield f"{vector['link']} {vector['direction']} framer", frame


def named(link: Any, direction: str) -> bool:
    """Whether a frame is decoded only as that of a message, because no part of it tells which one it is."""
    decode = getattr(link, f"decode_{direction}")
    return len(inspect.signature(decode).parameters) > 1 and not decode.__func__.__defaults__


def _name(device: str, vector: Mapping[str, Any]) -> str:
    """The name of the target that decodes a frame."""
    link, direction = vector["link"], vector["direction"]
    return f"{link} {direction}" + (f" {vector['message']}" if named(links(device)[link], direction) else "")


def _frame(device: str, vector: Mapping[str, Any], error: type[Exception]) -> Target:
    """Decodes a frame; what comes out can be printed and encoded, or is refused with the same exception."""
    link, direction = vector["link"], vector["direction"]
    decode = getattr(links(device)[link], f"decode_{direction}")
    arguments = (vector["message"],) if named(links(device)[link], direction) else ()

    def target(data: bytes) -> None:
        try:
            decoded = decode(data, *arguments)
        except error:
            return
        repr(decoded)
        if hasattr(decoded, "message"):
            _encoded(decoded.message, error)

    return target


def _data(codec: Any, error: type[Exception]) -> Target:
    def target(data: bytes) -> None:
        try:
            value = codec.decode(data)
        except error:
            return
        repr(value)
        try:
            codec.encode(value)
        except error:
            return

    return target


def _encoded(message: Any, error: type[Exception]) -> None:
    try:
        message.encode()
    except error:
        return


def _stream(make: Callable[[], Any]) -> Target:
    """Feeds bytes in pieces: no byte is lost or comes twice, and no more than a frame is waiting."""

    def target(data: bytes) -> None:
        framer = make()
        size = data[0] % 32 + 1 if data else 1
        length = 0
        for start in range(0, len(data), size):
            length += sum(map(len, framer.feed(data[start : start + size])))
            if len(framer._buffer) > framer.longest:
                raise AssertionError("more bytes are waiting than a frame has")
        length += sum(map(len, framer.idle()))
        # Frames with delimiters may pause, so silence leaves their bytes.
        if length + framer.dropped + len(framer._buffer) != len(data):
            raise AssertionError("bytes are lost")

    return target
