"""The generated functions for groups of single bits are run, on random bits, and find and put each bit in its place."""

from __future__ import annotations

import random
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import proof_by
from proving import Proof
from test_execution_registers import READ, WRITABLE, member, ordered, registers, spans

from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.registers import RegisterGroup
from layouts import TEST_SPECS

WAYS = [(TEST_SPECS, "station", way) for way in ("interpreted", "compiled")]


@pytest.fixture(params=WAYS, ids=["interpreted", "compiled"], scope="module")
def prover(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """What is generated for the device with coils and discrete inputs."""
    return proof_by(request, tmp_path_factory)


def bit_groups(prover: Proof) -> list[RegisterGroup]:
    """The groups in spaces of bits."""
    device = prover.world.layout.device
    return [group for group in device.groups if device.space(group.space).unit == "bit"]


def addresses(register: RegisterLayout) -> list[int]:
    """The address of each of its elements."""
    return [register.address + number * register.stride for number in range(register.count)]


def packed(bits: dict[int, int], first: int, size: int) -> list[int]:
    """Bits by address as bytes, the first one in the lowest bit."""
    number = sum(bit << (at - first) for at, bit in bits.items())
    return list(number.to_bytes(size, "little"))


def test_each_bit_is_put_into_its_member(prover: Proof) -> None:
    dice, size = random.Random(1), prover.world.bits.high + 1
    for group in bit_groups(prover):
        own = registers(prover, group, READ)
        for address, count in spans(own, 8 * size):
            bits = {address + place: dice.randrange(2) for place in range(max(0, count))}
            copy = prover.machine.fresh(prover.world.names.structs[group.name].lower())
            value: dict[str, Any] = {"aBits": packed(bits, address, size), "stData": copy}
            status, _ = prover.run(ordered(prover, "unpack", group.name), uiAddress=address, iCount=count, **value)
            there = {register.name: [bits.get(at) for at in addresses(register)] for register in own}
            known = any(bit is not None for each in there.values() for bit in each)
            assert status == ("ok" if known else "not_covered"), (group.name, address, count)
            for register in own:
                actual = copy[member(prover, group, register)]
                elements = list(actual) if register.count > 1 else [actual]
                assert [bool(bit) for bit in there[register.name]] == elements, (register.name, address, count)


def test_each_member_is_put_into_its_bit_and_no_other_changes(prover: Proof) -> None:
    dice, size = random.Random(2), prover.world.bits.high + 1
    for group in bit_groups(prover):
        own = registers(prover, group, WRITABLE)
        for address, count in spans(own, 8 * size) if own else ():
            copy = prover.machine.fresh(prover.world.names.structs[group.name].lower())
            bits: dict[int, int] = {}
            for register in own:
                values = [dice.random() < 0.5 for _ in range(register.count)]
                copy[member(prover, group, register)] = values if register.count > 1 else values[0]
                bits |= {at: int(bit) for at, bit in zip(addresses(register), values, strict=True)}
            before = [dice.randrange(256) for _ in range(size)]
            array, name = list(before), ordered(prover, "pack", group.name)
            status, _ = prover.run(name, uiAddress=address, iCount=count, aBits=array, stData=copy)
            asked = range(address, address + count)
            if count <= 0 or any(at not in bits for at in asked):
                assert status == "not_covered", (group.name, address, count)
                continue
            mask = sum(1 << (at - address) for at in asked)
            wanted = sum(bits[at] << (at - address) for at in asked)
            old = int.from_bytes(bytes(before), "little")
            assert (status, array) == ("ok", list((old & ~mask | wanted).to_bytes(size, "little")))
