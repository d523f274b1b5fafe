"""Scenes: what a request over the line shows of a simulated device, as steps in a file.

A step has one of these keys: `write`, words by address, where a scalar is one word; `read`, the words that an address
must have; `ask`, a message, `with` its values, `forced` to be refused for a reason, whose response has the values of
`answer`, the bytes of `frame`, or the number of `exception`; `exchange`, values of the cyclic message in use, whose
response has the values of `answer` and the `bits`; `frame`, the bytes of a request, with those of the `answer`; `link`,
on which the steps that follow are; `timing`, the seconds of times of the line; `wait`, seconds; `set`, signals that
come from outside; `power`, off and on.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from fieldspec.codec.reference import codec
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.line import timing
from fieldspec.tools.simulator.server import Server
from simulators import Unit, exception_number, parts_of

Scene = dict[str, Any]
FOLDER = Path(__file__).parent / "device" / "scenes"


def scenes(device: str) -> list[Scene]:
    """The scenes of a device."""
    read_scenes: list[Scene] = yaml.safe_load((FOLDER / f"{device}.yaml").read_text("utf-8"))
    return read_scenes


class Stage:
    """A simulated device on which a scene is played, without some parts of its behaviour."""

    def __init__(self, device: str, scene: Scene, without: str = "") -> None:
        layout, behaviour = parts_of(scene.get("device", device))
        link, message = scene.get("link", next(iter(layout.links))), scene.get("message", "")
        self.unit = Unit(scene.get("device", device), link, message, scene.get("unit", 1))
        if without:
            other_parts = (part for part in behaviour.parts if without not in (part.name, part.get("from")))
            behaviour = Behaviour(tuple(other_parts))
            self.unit.engine = Engine(layout, behaviour, message)
            self.unit.server = Server(self.unit.engine, scene.get("unit", 1))
        self._link({"link": link}, "")

    def play(self, scene: Scene) -> None:
        """Plays all steps. Raises AssertionError where the device answers otherwise."""
        for number, step in enumerate(scene["steps"], 1):
            kind = next(iter(step))
            getattr(self, f"_{kind}")(step, f"step {number}, {kind}")

    def _link(self, step: Scene, place: str) -> None:
        unit, layout = self.unit, self.unit.engine.layout
        unit.link, unit.codec = step["link"], codec(layout).links[step["link"]]
        header = layout.links[unit.link].request.header
        known = {"unit_address": unit.server.unit_address, "request_reference": 9}
        unit.head = {part.name: known[name] for part in header for name in (part.role, part.name) if name in known}

    def _write(self, step: Scene, place: str) -> None:
        for address, words in step["write"].items():
            self.unit.write(address, *(words if isinstance(words, list) else [words]))

    def _read(self, step: Scene, place: str) -> None:
        for address, words in step["read"].items():
            expected = words if isinstance(words, list) else [words]
            assert self.unit.read(address, len(expected)) == expected, f"{place} {address:04X}h"

    def _ask(self, step: Scene, place: str) -> None:
        message, values = step["ask"], step.get("with", {})
        answer = self.unit.answer(message, step.get("forced", ""), **values)
        assert answer.frame, (place, answer.text)
        if "exception" in step:
            number = exception_number(self.unit.codec.decode(answer.frame, "response", message))
            assert number == step["exception"], place
            return
        if "frame" in step:
            assert answer.frame == bytes.fromhex(step["frame"]), (place, answer.frame.hex(" "))
            return
        decoded = self.unit.codec.decode(answer.frame, "response", message).values
        self._compare(step, decoded, place)

    def _exchange(self, step: Scene, place: str) -> None:
        record = self.unit.engine.layout.messages[self.unit.message].request
        zero = {field.name: 0 for field in record.fields if not field.field.reserved}
        self._compare(step, self.unit.ask(self.unit.message, **{**zero, **step["exchange"]}), place)

    def _compare(self, step: Scene, decoded: Scene, place: str) -> None:
        for name, value in step.get("answer", {}).items():
            assert decoded[name] == value, f"{place}: {name} is {decoded[name]}"
        for name, bits in step.get("bits", {}).items():
            levels = {bit: decoded[name] >> bit & 1 for bit in bits}
            assert levels == bits, f"{place}: {name} is {decoded[name]:016b}"

    def _frame(self, step: Scene, place: str) -> None:
        self.unit.engine.advance(self.unit.now)
        answer = self.unit.answer_to(bytes.fromhex(step["frame"]))
        assert answer.frame == bytes.fromhex(step["answer"]), (place, answer.frame.hex(" "))

    def _timing(self, step: Scene, place: str) -> None:
        assert {name: timing(self.unit.server, name) for name in step["timing"]} == step["timing"], place

    def _wait(self, step: Scene, place: str) -> None:
        self.unit.wait(step["wait"])

    def _set(self, step: Scene, place: str) -> None:
        engine = self.unit.engine
        for name, value in step["set"].items():
            for cell in engine.cells.of(name):
                cell.write(engine.raw(cell, value))
        engine.follow()
        engine.refresh()

    def _power(self, step: Scene, place: str) -> None:
        self.unit.engine.power_on()
        self.unit.engine.refresh()
