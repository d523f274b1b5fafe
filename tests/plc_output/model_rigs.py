"""Compiled blocks with a model of a manual on the other side, recorded scan by scan for the monitors."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from benches import Bench, block_names
from model_values import fitting, kinds, position_of, speed_of, value_of

from device_models.ck10 import Ck10
from device_models.draws import Draws
from device_models.esc11 import Esc11
from device_models.frames import Exchange, Line
from device_models.history import History, Scan
from device_models.hiwin import RECEIVED, HiwinE
from device_models.tc100 import Tc100
from fieldspec.targets.controllers.routines.blocks.ports import ABANDONED, ANSWERED, ASKED, FRAMES, FREE
from layouts import SPECS

MODELS = {"tc100": Tc100, "ck10": Ck10, "esc11": Esc11}
TIMEOUT = 0.6
"""Seconds until a transport gives up [esc11 7.3 L247]; the manuals of the others print none."""
NO_ANSWER = 2
PATIENCE = {"esc11": 12000}
"""Milliseconds in which all blocks of a device have exchanged what they need, where that takes long."""
SIGNED = {"int": "h", "dint": "i", "sint": "b", "word": "H", "uint": "H", "dword": "I", "udint": "I"}


@cache
def bench(device: str, telegram: int, folder: Path, twice: bool) -> Bench:
    """The blocks of a device that move it, in one program; `twice` with two instances of a move and of a stop."""
    names = kinds(block_names(SPECS, device), telegram)
    more = [f"{name} 2" for name, kind in names.items() if kind in ("absolute", "stop") and twice]
    return Bench(SPECS, device, [*names, *more], folder, ordered=True)


class ModelRig:
    """Blocks of one device against its model.

    `record` has all scans so far. A test sets inputs, lets scans pass, and disturbs the model and the line; `disturbed`
    notes what it has done to them, so that no monitor takes that for a mistake of a block.
    """

    def __init__(self, device: str, folder: Path, draws: Draws, telegram: int = 0, twice: bool = False) -> None:
        self.name, self.draws = device, draws
        self.bench = bench(device, telegram, folder, twice)
        self.kinds = kinds(self.bench.blocks, telegram)
        self.names = list(self.kinds)
        self.record: list[Scan] = []
        self.seen = 0
        self.disturbed: list[str] = ["restart"]
        self.invalid: set[str] = set()
        self.clear = True
        self.asked: list[str] = []
        self.fates: list[str] = []
        self.word: int | None = None
        self._inputs: dict[tuple[str, str], Any] = {}
        self.model: Any = HiwinE(draws, telegram) if telegram else MODELS[device](draws)
        self.bench.now.clear()
        self.bench.restart()
        for (block, name), of in self.bench.inputs.items():
            value = fitting(device, self.kinds[block], name, of, draws.dice)
            if value is not None:
                self.set(block, **{name: value})

    def set(self, block: str, **inputs: Any) -> None:
        """Sets inputs of a block."""
        self.bench.set(block, **inputs)
        self._inputs = {}

    def block(self, kind: str) -> str:
        """The block of a kind."""
        return next(name for name, of in self.kinds.items() if of == kind)

    def start(self, block: str, level: bool = True, **inputs: Any) -> None:
        """Sets the input that makes a block work; a jog of two directions goes forward."""
        name = next(name for name in ("Execute", "JogForward", "Enable") if (block, name) in self.bench.inputs)
        self.set(block, **{name: level}, **inputs)

    def restart(self) -> None:
        """The controller is switched off and on."""
        self.bench.restart()
        self._inputs = {}
        self.disturbed.append("restart")
        self.forget()

    def disturb(self, about: str) -> None:
        """Notes that something happens to the device from outside."""
        self.disturbed.append(about)

    def run(self, scans: int, milliseconds: int = 10) -> ModelRig:
        """Lets some scans pass."""
        for _ in range(scans):
            self.scan(milliseconds)
        return self

    def scan(self, milliseconds: int = 10, order: Sequence[str] | None = None) -> None:
        """One scan, and what the device does until the next one."""
        self.bench.scan(milliseconds, order)
        self.asked, self.fates = [], []
        self.serve(milliseconds / 1000)
        self.model.pass_time(milliseconds / 1000)
        if not self._inputs:
            self._inputs = dict(self.bench.now)
        events = self.model.events
        self.record.append(
            Scan(
                milliseconds,
                self._inputs,
                self.bench.out,
                None if order is None else frozenset(order),
                self.asked,
                self.fates,
                tuple(events[self.seen :]),
                self.model.state,
                self.disturbed,
                frozenset(self.invalid),
                self.clear and not any(fate != "good" for fate in self.fates),
                self.word,
            )
        )
        self.seen = len(events)
        self.disturbed = []

    def serve(self, seconds: float) -> None:
        """What happens on the line after a scan."""
        raise NotImplementedError

    def forget(self) -> None:
        """What was on its way is forgotten."""

    @property
    def history(self) -> History:
        """What was recorded, for the monitors."""
        return History(
            self.record,
            self.kinds,
            lambda block, inputs: value_of(self.name, block, self.kinds[block], inputs),
            lambda block, outputs: position_of(self.name, block, outputs),
            patience=PATIENCE.get(self.name, 5000),
            speed_of=lambda block, inputs: speed_of(self.name, self.kinds[block], block, inputs),
        )

    def ended(self, block: str) -> str:
        """How a block has ended, with the number of its error; "Busy" before that."""
        out = self.bench.out
        ending = [name for name in ("Done", "CommandAborted", "Error", "Busy") if out.get((block, name))]
        return f"Error {out[block, 'ErrorID']}" if "Error" in ending else ending[0] if ending else ""

    def finish(self, block: str, milliseconds: int = 10, limit: float = 70.0, **inputs: Any) -> str:
        """Starts a block by an edge, waits for its end, and withdraws its input."""
        self.start(block, False, **inputs)
        self.run(2, milliseconds)
        self.start(block)
        self.run(1, milliseconds)
        passed = 0.0
        while self.ended(block) == "Busy" and passed < limit:
            self.run(1, milliseconds)
            passed += milliseconds / 1000
        result = self.ended(block)
        self.start(block, False)
        self.run(2, milliseconds)
        return result


class FrameRig(ModelRig):
    """A device on a line with frames."""

    def __init__(self, device: str, folder: Path, draws: Draws, twice: bool = False) -> None:
        super().__init__(device, folder, draws, twice=twice)
        self.connect()
        for (block, name), of in self.bench.inputs.items():
            if of != "bool" and ("tation" in name or "ddress" in name):
                self.set(block, **{name: self.model.STATION})
            if name == "Retries":
                self.set(block, Retries=2)

    def connect(self) -> None:
        """Puts the model at the other end of the line."""
        model, draws = self.model, self.draws
        self.line = Line(draws, model.answer, model.foreign, model.alike, model.latency, TIMEOUT)
        self.exchange: Exchange | None = None
        self.number = 0
        self.variable = next(name for name in self.bench.ports if name.lower().endswith("frames"))
        members = ("state", "error", "request", "answered", "send", "received", "frame", "urgent")
        self._names = {name: self.bench.port(FRAMES, name) for name in members}

    def forget(self) -> None:
        self.exchange = None

    def serve(self, seconds: float) -> None:
        port, names = self.bench.ports[self.variable], self._names
        state = port[names["state"]]
        port[names["urgent"]] = max(0, port[names["urgent"]] - 1)
        if self.exchange is not None:
            self.exchange.remaining -= seconds
            if self.exchange.remaining > 0:
                return
            answer = self.exchange.answer
            self.fates.append(self.exchange.fate)
            self.exchange = None
            port[names["answered"]] = self.number
            port[names["error"]] = NO_ANSWER if answer is None else 0
            if answer is not None:
                port[names["frame"]][: len(answer)] = list(answer)
                port[names["received"]] = len(answer)
            port[names["state"]] = FREE if state == ABANDONED else ANSWERED
        elif state == ABANDONED:
            port[names["state"]] = FREE
        elif state == ASKED:
            self.number = port[names["request"]]
            frame = bytes(port[names["frame"]][: port[names["send"]]])
            self.asked.append(self.model.meaning(frame))
            self.exchange = self.line.send(frame)


class TelegramRig(ModelRig):
    """A drive with a telegram. While `lost` is set, no response comes; `unheard` says that nothing goes out either."""

    def __init__(self, folder: Path, draws: Draws, telegram: int, twice: bool = False) -> None:
        super().__init__("hiwin-e", folder, draws, telegram, twice)
        self.connect(telegram)

    def connect(self, telegram: int) -> None:
        """Puts the model at the other end of the telegram."""
        key = f"axis of telegram_{telegram}"
        names = {name: self.bench.port(key, name) for name in ("valid", "request", "response")}
        self.variable = next(name for name, port in self.bench.ports.items() if names["request"] in port)
        self.valid = names["valid"]
        port = self.bench.ports[self.variable]
        unit = self.bench.program.unit
        kind = self.bench._kinds[self.variable]
        members = {name: of for name, of, _ in unit.structs[kind]}
        self.request, self.response = names["request"], names["response"]
        self.sent = [(name, SIGNED[of]) for name, of, _ in unit.structs[members[self.request]]]
        self.received = [(name, SIGNED[of]) for name, of, _ in unit.structs[members[self.response]]]
        assert list(port[self.request]) == [name for name, _ in self.sent]
        self.lost = self.unheard = False
        self.before = self.speed = 0
        self._form = ">" + "".join(form for _, form in self.sent)
        self._answer = ">" + "".join(form for _, form in self.received)

    def forget(self) -> None:
        self.before = self.speed = 0

    def serve(self, seconds: float) -> None:
        port = self.bench.ports[self.variable]
        request = struct.pack(self._form, *(port[self.request][name] for name, _ in self.sent))
        size = struct.calcsize(RECEIVED[self.model.telegram])
        values = struct.unpack(RECEIVED[self.model.telegram], request.ljust(size, b"\0")[:size])
        self.word = values[0]
        if not self.unheard:
            self.asked += self.model.meaning(values, self.before)
            self.before = values[0]
            self.model.obey(values)
        if self.model.telegram in (3, 102):
            self.asked += [f"speed {values[1]}"] + ["stop"] * bool(self.speed and not values[1])
            self.speed = values[1]
        self.fates.append("lost answer" if self.lost else "good")
        port[self.valid] = not self.lost
        if not self.lost:
            answer = self.model.response()
            got = struct.unpack(self._answer, answer[: struct.calcsize(self._answer)])
            port[self.response].update(zip((name for name, _ in self.received), got, strict=True))


def rig(name: str, folder: Path, draws: Draws, twice: bool = False) -> Any:
    """The rig of a device, or of a drive with a telegram: "hiwin-e 111"."""
    device, _, telegram = name.partition(" ")
    return TelegramRig(folder, draws, int(telegram), twice) if telegram else FrameRig(device, folder, draws, twice)


NAMES = ("tc100", "ck10", "esc11", "hiwin-e 9", "hiwin-e 111", "hiwin-e 3", "hiwin-e 102")
