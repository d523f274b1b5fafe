"""Simulated devices for tests, in memory and on carriers."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import codec
from fieldspec.codec.reference.frames import Decoded
from fieldspec.command.sources import specs
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Answer, Server

SPECS = str(Path(__file__).parent.parent / "specs")


@cache
def parts_of(device: str, folder: str = SPECS) -> tuple[DeviceLayout, Behaviour]:
    """The layout and the behaviour of `DEVICE` or `DEVICE@VERSION`."""
    spec, version = specs.spec_at(folder, device)
    return specs.layout_of(spec, version), behaviour_of(spec.tree_at(version))


class Unit:
    """A simulated device in memory, with its own time, spoken to in values instead of bytes."""

    def __init__(self, device: str, link: str, message: str = "", unit_address: int = 1, folder: str = SPECS) -> None:
        layout, behaviour = parts_of(device, folder)
        self.engine = Engine(layout, behaviour, message)
        self.server = Server(self.engine, unit_address)
        self.link, self.message = link, message
        self.codec = codec(layout).links[link]
        addressed = layout.links[link].request.role("unit_address")
        self.head = {addressed.name: unit_address} if addressed is not None else {}
        self.now = 0.0

    def wait(self, seconds: float) -> None:
        """Lets time pass."""
        self.now += seconds
        self.engine.advance(self.now)

    def answer(self, message: str, forced: str = "", /, **values: Any) -> Answer:
        """The answer to a request; `forced` is a reason to refuse it."""
        self.engine.advance(self.now)
        frame = self.codec.encode("request", message, {**self.head, **values})
        return self.server.answer(self.link, frame, self.message, forced)

    def answer_to(self, frame: bytes) -> Answer:
        """The answer to a frame."""
        return self.server.answer(self.link, frame, self.message)

    def ask(self, message: str, /, **values: Any) -> Any:
        """The values in the response to a request."""
        answer = self.answer(message, **values)
        assert answer.frame, answer.text
        return self.codec.decode(answer.frame, "response", message).values

    def read(self, address: int, count: int = 1) -> list[int]:
        """The words of registers."""
        words: list[int] = self.ask("read_registers", address=address, word_count=count)["values"]
        return words

    def write(self, address: int, *words: int) -> None:
        """Writes registers."""
        self.ask("write_registers", address=address, values=list(words))

    def exception(self, message: str, /, **values: Any) -> int:
        """The number in the exception response to a request."""
        return exception_number(self.codec.decode(self.answer(message, **values).frame, "response", message))


def exception_number(decoded: Decoded) -> int:
    """The number of the exception in a response."""
    assert decoded.error, decoded
    return next(value for name, value in decoded.values.items() if name in ("exception_code", "error_number"))
