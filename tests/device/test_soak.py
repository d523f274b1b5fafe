"""Hours of random requests and faults leave a simulated device whole: no hang, no leak, no answer that is no frame."""

from __future__ import annotations

import os
import random
import tracemalloc
from typing import Any

import pytest

from fieldspec.reference import CodecError
from fieldspec.simulator.faults import KINDS, Fault, Faults
from fieldspec.simulator.line import Line
from simulators import Unit

HOURS = float(os.environ.get("FIELDSPEC_SOAK_HOURS", "0.005"))
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


def random_request(unit: Unit, chance: random.Random, addresses: list[int]) -> bytes:
    """A request with random values, most of them sensible, or random bytes."""
    if chance.random() < 0.02:
        return chance.randbytes(chance.randrange(1, 30))
    messages = [unit.message] if unit.message else list(unit.engine.layout.links[unit.link].messages)
    name = chance.choice(messages)
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
        values[access.start] = chance.choice(addresses)
    values |= {part.name: 1 for part in unit.codec.link.request.header if part.is_argument}
    try:
        return unit.codec.encode("request", name, {**values, **unit.head})
    except (CodecError, TypeError, AttributeError, KeyError):
        return unit.codec.joined_parts("request", chance.randbytes(6))


@pytest.mark.parametrize(("device", "link", "message"), UNITS, ids=[f"{d}-{link}-{m}" for d, link, m in UNITS])
def test_a_device_stands_random_requests_and_faults(device: str, link: str, message: str) -> None:
    unit = Unit(device, link, message)
    chance = random.Random(f"{device} {link} {message}")
    faults = Faults([Fault(kind, probability=0.01, count=0) for kind in STRIKING], seed=5)
    line = Line(unit.server, link, None, faults, lambda *event: None, message)
    addresses = sorted({address for _, address in unit.engine.memory.occupants}) or [0]
    now, requests, answers, whole = 0.0, 0, 0, 0
    sizes = []
    tracemalloc.start()
    while now < HOURS * 3600:
        now += chance.choice((0.02, 0.05, 0.2, 1.0))
        requests += 1
        for sending in line.feed(now, random_request(unit, chance, addresses)):
            answers += bool(sending.data)
            try:
                unit.codec.decode(sending.data, "response", message)
                whole += 1
            except CodecError:
                pass
        if requests % 5 == 0:
            sizes.append(tracemalloc.get_traced_memory()[0])
        for (space, address), word in list(unit.engine.memory.words.items())[:3]:
            assert 0 <= word <= 0xFFFF, (space, address)
    tracemalloc.stop()
    assert requests > HOURS * 3600 / 2
    assert answers > requests * 0.5
    assert whole > answers * 0.8 or link == "serial"
    assert sizes[-1] < 2 * sizes[len(sizes) // 2] + 1_000_000
