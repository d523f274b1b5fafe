"""Hours of random requests and faults leave a simulated device whole: no hang, no leak, no wrong value for a client."""

from __future__ import annotations

import gc
import json
import os
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.codec.reference import CodecError
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError, Timing
from fieldspec.tools.live.messages import (
    ParameterAssignment,
    Signal,
    parameter_address,
    parameter_message,
    parameter_request,
    signals,
)
from fieldspec.tools.live.writing import WriteError
from fieldspec.tools.simulator.clock import ManualClock
from fieldspec.tools.simulator.faults import KINDS, Fault, Faults
from simulators import SPECS, Unit
from wires import Wire

HOURS = float(os.environ.get("FIELDSPEC_SOAK_HOURS", "0.01"))
FIGURES = os.environ.get("FIELDSPEC_SOAK_FIGURES", "")
"""A file that gets the figures of each unit as a line of JSON."""

UNITS = [
    ("tc100", "rtu", ""),
    ("tc100@before-2.0", "ascii", ""),
    ("ck10", "rtu", ""),
    ("esc11", "serial", ""),
    ("hiwin-e", "cyclic", "telegram_9"),
    ("hiwin-e", "cyclic", "telegram_111"),
    ("hiwin-e", "parameter_channel", ""),
]
STRIKING = [kind for kind in KINDS if kind not in ("stuck_bit", "out_of_range")]
PAUSES = (0.02, 0.05, 0.2, 1.0)


class Soak:
    """Random requests to one unit: some as noise on its line, the others by a client whose values are compared."""

    def __init__(self, device: str, link: str, message: str) -> None:
        self.unit = Unit(device, link, message)
        self.chance = random.Random(f"{device} {link} {message}")
        self.faults = Faults([Fault(kind, probability=0.01, count=0) for kind in STRIKING], seed=5)
        self.clock = ManualClock()
        self.wire = Wire(self.unit, self.faults, self.clock, message)
        self.client = Client(self.unit.engine.layout, link, self.wire, 1, Timing(0.8, 0.0, 0), self.clock)
        self.parameters: dict[str, list[Signal]] = {}
        self.written: dict[str, list[Signal]] = {}
        for signal in signals(self.unit.engine.layout, self.unit.codec.link):
            for known, operation in ((self.parameters, "read"), (self.written, "write")):
                if signal.numbered is None:
                    continue
                message_layout = parameter_message(self.unit.codec.link, signal.numbered.parameter_set, operation)
                if message_layout is not None and (operation == "read" or signal.index is None):
                    known.setdefault(message_layout.name, []).append(signal)
        self.addresses = sorted({address for _, address in self.unit.engine.memory.occupants}) or [0]
        self.totals: Counter[str] = Counter()
        self.wrong: list[str] = []

    def step(self) -> None:
        """One request."""
        self.clock.sleep(self.chance.choice(PAUSES))
        self.totals["requests"] += 1
        if self.chance.random() < 0.02:
            self._noise()
            return
        try:
            name, values = self._request()
            decoded = self.client.ask(name, values, retries=0)
        except RefusedError as error:
            self.totals["refused"] += 1
            if not self._true(name, "error"):
                self.wrong.append(f"{name} {values}: {error}, and the device has not refused it")
            return
        except (NoAnswerError, CodecError, WriteError) as error:
            self.totals["no answer" if isinstance(error, NoAnswerError) else "not sent"] += 1
            return
        except CarrierError:
            self.totals["connections lost"] += 1
            self.wire.close()
            self.wire.open()
            return
        self.totals["values"] += 1
        if decoded.values != self._true(name, "values") or decoded.head != self._true(name, "head"):
            frames = f"{self.wire.arrived.hex(' ')} arrived instead of {self.wire.true_answer.frame.hex(' ')}"
            self.wrong.append(f"{name} {values}: {decoded.values} instead of {self._true(name, 'values')}; {frames}")

    def _true(self, message: str, attribute: str) -> Any:
        """What the device itself has answered to the last request; None where it has not."""
        frame = self.wire.true_answer.frame
        return getattr(self.unit.codec.decode(frame, "response", message), attribute) if frame else None

    def _noise(self) -> None:
        """Random bytes on the line, whose answers nobody reads."""
        self.totals["noise"] += 1
        self.wire.write(self.chance.randbytes(self.chance.randrange(1, 30)))

    def _request(self) -> tuple[str, dict[str, Any]]:
        """A message with random values, most of them sensible."""
        unit, chance = self.unit, self.chance
        name = chance.choice([unit.message] if unit.message else list(unit.codec.link.carried("response")))
        parameter = self._parameter_request(name) if chance.random() < 0.8 else None
        if parameter is not None:
            return parameter
        message = unit.engine.layout.messages[name]
        access = unit.engine.layout.device.register_access(message.message)
        values: dict[str, Any] = {}
        for field in message.request.fields:
            if field.value is None or field.field.reserved or field.field.measures is not None:
                continue
            low, high = field.value.type.low, field.value.type.high
            ranges = field.value.ranges
            interval = chance.choice(ranges.intervals) if ranges is not None else (low, min(high, 0xFFFF))
            values[field.name] = field.value.const if field.value.const is not None else chance.randint(*interval)
            if field.is_list:
                values[field.name] = [chance.randrange(0x100) for _ in range(field.count or chance.randrange(1, 4))]
        if access is not None:
            values[access.start] = chance.choice(self.addresses)
        return name, values

    def _parameter_request(self, name: str) -> tuple[str, dict[str, Any]] | None:
        """A message that reads or writes one parameter, with one of those that it can; None for other messages."""
        reads, writes = self.parameters.get(name, []), self.written.get(name, [])
        if reads:
            return name, parameter_address(self.unit.engine.layout.messages[name], self.chance.choice(reads))
        if writes:
            signal = self.chance.choice(writes)
            interval = self.chance.choice(signal.value.ranges.intervals) if signal.value.ranges is not None else (0, 1)
            message, values, _ = parameter_request(
                self.client, ParameterAssignment(signal, self.chance.randint(*interval), (), ())
            )
            return message, values
        return None


def undetected(soak: Soak) -> int:
    """How many damaged frames a checksum of one byte may let pass: one in 256. No other link lets one pass."""
    sizes = [part.size for part in soak.unit.codec.link.response.checksums]
    damaged = sum(soak.faults.struck.get(kind, 0) for kind in ("garbage", "inserted_word", "truncated"))
    return damaged // 256 if sizes == [1] else 0


def allocated_blocks() -> int:
    """The blocks of memory in use, without garbage that has not been collected yet."""
    gc.collect()
    return sys.getallocatedblocks()


@pytest.mark.proof(4)
@pytest.mark.parametrize(("device", "link", "message"), UNITS, ids=[f"{d}-{link}-{m}" for d, link, m in UNITS])
def test_a_device_stands_random_requests_and_faults(device: str, link: str, message: str) -> None:
    soak = Soak(device, link, message)
    halfway = 0
    longest, begun = 0.0, time.process_time()
    while soak.clock.now() < HOURS * 3600:
        before = time.process_time()
        soak.step()
        longest = max(longest, time.process_time() - before)
        if not halfway and soak.clock.now() > HOURS * 1800:
            halfway = allocated_blocks()
        assert len(soak.wrong) < 20, soak.wrong
        for (space, address), word in list(soak.unit.engine.memory.words.items())[:3]:
            assert 0 <= word <= 0xFFFF, (space, address)
    totals, wrong = soak.totals, soak.wrong
    growth = allocated_blocks() - halfway
    if FIGURES:
        row = {
            "device": device,
            "link": link,
            "message": message,
            "hours": HOURS,
            **totals,
            "wrong": wrong,
            "faults": soak.faults.struck,
            "growth": growth,
            "longest": longest,
            "seconds": time.process_time() - begun,
        }
        with Path(FIGURES).open("a", encoding="utf-8") as file:
            file.write(json.dumps(row) + "\n")
    assert len(wrong) <= undetected(soak), wrong
    assert totals["requests"] > HOURS * 3600 / 3
    assert totals["values"] > totals["requests"] * 0.15
    assert growth < 1_000


def test_a_device_that_is_served_frees_what_requests_leave(monkeypatch: pytest.MonkeyPatch) -> None:
    is_freed: list[bool] = []

    def commands() -> Iterator[str]:
        is_freed.append(gc.isenabled())
        yield from ()

    monkeypatch.setattr(sys, "stdin", commands())
    assert main(["simulate", "tc100", "--port", "rtu=tcp://127.0.0.1:0", "--control", "--specs", SPECS]) == 0
    assert is_freed == [True]
