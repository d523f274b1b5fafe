"""Every function block of every device runs: those that no other rig has are run here, compiled."""

from __future__ import annotations

import random
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, ClassVar

import pytest

sys.path.insert(0, str(Path(__file__).parent))

import test_execution_registers as groups
from benches import Bench, block_names
from devices import Tc100, Transport
from drawing import drawn_value, drawn_values
from loaded import REAL, programs, words_in
from proving import Proof, without
from rigs import NUMBER, Esc11Rig, HiwinRig, Rig, Tc100Rig
from test_simulated_blocks import SPEEDS, Ck10Rig, Ck10TableRig, Telegram9Rig, TelegramRig, connect
from test_speed_blocks import LimitRig

from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.records import encoded
from fieldspec.targets.controllers.routines.blocks.ports import FRAMES, own_links
from fieldspec.targets.controllers.routines.register_range import answer_type
from fieldspec.targets.controllers.routines.wrapping import link_words
from layouts import SPECS, newest

LINES = [
    f"{link}{message}" for link in ("Rtu", "Ascii") for message in ("ReadRegisters", "WriteRegister", "WriteRegisters")
]
ELSEWHERE: dict[str, set[str]] = {
    "ck10": {*Ck10Rig.blocks, *Ck10TableRig.blocks, *LINES},
    "tc100": {*Tc100Rig.blocks, *LINES},
    "esc11": {*Esc11Rig.blocks},
    "hiwin-e": {block for rig in (HiwinRig, Telegram9Rig, LimitRig, *SPEEDS.values()) for block in rig.blocks},
}
"""The blocks that the rigs of other tests have."""
IN_PROGRAMS = ("Grip", "Release")
"""The blocks that, as the panels themselves, run in test_ready_programs.py."""
CLIENTS = {"rtu": "RtuClient", "ascii": "AsciiClient"}
JOGS = dict.fromkeys(("ck10", "tc100", "esc11"), "Jog") | {"hiwin-e": "Telegram111Jog"}
STOPS = {"ck10": "ImmediateStop", "tc100": "EmergencyStop", "esc11": "Stop", "hiwin-e": "Telegram111QuickStop"}
SAVES = {"ck10": ["SaveParameters"], "tc100": ["Save"]}
VERSIONS = {"ck10": ["ReadFirmwareVersion"], "tc100": ["ReadFirmwareVersion"]}
ALARMS = dict.fromkeys(("ck10", "tc100", "esc11"), "ReadAlarm") | {"hiwin-e": "Telegram111ReadAlarm"}


def tasks(device: str) -> list[str]:
    """The blocks for tasks that run here."""
    return [JOGS[device], STOPS[device], *SAVES.get(device, []), *VERSIONS.get(device, []), ALARMS[device]]


def messages(device: str) -> list[str]:
    """The blocks that exchange a message."""
    return [name for name in rest(device) if "Send" in name]


def transfers(device: str) -> list[str]:
    """The blocks that read and write registers of a group, and elements of a table."""
    if device not in SAVES:
        return []
    return [name for name in rest(device) if name.startswith(("Read", "Write")) and name not in tasks(device)]


def rest(device: str) -> list[str]:
    """The blocks that the rigs of other tests do not have."""
    names = [name for name in block_names(SPECS, device) if name not in ELSEWHERE[device]]
    return [name for name in names if name not in IN_PROGRAMS and not name.endswith("Panel")]


def bench(device: str, names: Sequence[str], folder: Path) -> Bench:
    """Some blocks, in the program that all rigs here have, and those elsewhere where it has few arrays."""
    whole = block_names(SPECS, device)
    if device in SAVES:
        more = {"ServoOn", "ServoOff", JOGS[device], *CLIENTS.values()}
        whole = [name for name in whole if name in more or name in rest(device)]
    return Bench(SPECS, device, names, folder, program=whole)


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.mark.parametrize("device", REAL)
def test_every_block_of_a_device_has_a_rig(device: str) -> None:
    run = {*ELSEWHERE[device], *tasks(device), *messages(device), *transfers(device), *CLIENTS.values()}
    assert [name for name in rest(device) if name not in run] == []


class TaskRig(Rig):
    """The blocks for tasks of a device, against the simulator."""

    def __init__(self, device: str, folder: Path) -> None:
        self.starting = {JOGS[device]: ["endless", "absolute"]}  # type: ignore[misc]
        client = [CLIENTS["rtu"]] if device in SAVES else []
        super().__init__(bench(device, ["ServoOn", "ServoOff", *tasks(device), *client], folder))
        connect(self, device, "serial" if device == "esc11" else "rtu")
        for block, name in self.bench.inputs:
            if name == "Velocity":
                self.bench.set(block, **{name: 50})


class TelegramTaskRig(TelegramRig):
    """The same on telegram 111."""

    starting: ClassVar[dict[str, Sequence[str]]] = {JOGS["hiwin-e"]: ["endless"]}
    blocks = ("Telegram111ServoOn", "Telegram111ServoOff", *tasks("hiwin-e"))


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", REAL)
def test_tasks_that_no_other_rig_has_are_carried_out(device: str, folder: Path) -> None:
    rig: Any = TelegramTaskRig(folder) if device == "hiwin-e" else TaskRig(device, folder)
    form, jog, alarm = "Telegram111" if device == "hiwin-e" else "", JOGS[device], ALARMS[device]
    rig.device.home()
    rig.bench.set(jog, JogBackward=True)
    rig.run(30)
    assert rig.device.motion.starts == [], "no edge has been seen"
    assert rig.done(f"{form}ServoOn") == "Done"
    for end in ("release", "stop"):
        rig.run(2, jog, JogBackward=False)
        if device == "esc11":  # A gripper that is closed cannot be closed.
            rig.run(250, jog, JogForward=True).run(60, jog, JogForward=False)
        rig.run(30, jog, JogBackward=True)
        assert (rig.device.motion.moving, rig.ended(jog)) == (True, "Busy"), end
        if end == "stop":
            assert rig.done(STOPS[device]) == "Done"
            rig.run(60)
            assert rig.ended(jog) == "CommandAborted"
        rig.run(60, jog, JogBackward=False)
        assert not rig.device.motion.moving, end
    for block in SAVES.get(device, []):
        assert rig.done(block) == "Done"
    for block in [alarm, *VERSIONS.get(device, [])]:
        rig.run(20, block, Enable=True)
        assert (rig.bench.out[block, "Valid"], rig.bench.out[block, "Error"]) == (True, False), block
    (number,) = (name for block, name in rig.bench.outputs if block == alarm and ("larm" in name or "Fault" in name))
    assert rig.bench.out[alarm, number] == 0
    rig.device.alarm(3)
    rig.run(20)
    assert rig.bench.out[alarm, number] == 3


class Memory(Tc100):
    """Registers on a line of Modbus, which do nothing; `asked` are the first addresses and the words of requests."""

    def __init__(self, device: str, link: str) -> None:
        super().__init__()
        self.codec = codec(newest(SPECS, device)).links[link]
        self.requests: list[tuple[int, int]] = []

    def pass_scan(self) -> None:
        """Nothing changes by itself."""

    def _asked(self, frame: bytes) -> tuple[str, dict[str, Any]]:
        decoded = self.codec.decode(frame, "request")
        assert decoded.head["station"] == self.STATION
        values = dict(decoded.values)
        self.requests.append((values["address"], values.get("word_count", len(values.get("values", [0])))))
        return decoded.message.name, values

    def _write(self, address: int, words: list[int]) -> None:
        self.words |= {address + at: word for at, word in enumerate(words)}


class TransferRig(Rig):
    """The blocks that transfer registers, with one of the clients after them."""

    starting: ClassVar[dict[str, Sequence[str]]] = {}

    def __init__(self, device: str, link: str, folder: Path) -> None:
        super().__init__(bench(device, [*transfers(device), CLIENTS[link]], folder))
        self.device = Memory(device, link)
        self.transport = Transport(self.bench, FRAMES, self.bench.lent[CLIENTS[link], "Frames"], delay=1)
        self.bench.set(CLIENTS[link], Station=Memory.STATION)
        self.proof = Proof(self.bench.world, self.bench.program)

    def lent(self, block: str) -> str:
        """The variable with the data of a block."""
        return next(
            name for (owner, parameter), name in self.bench.lent.items() if owner == block and "Data" in parameter
        )


@pytest.mark.proof(1)
@pytest.mark.parametrize("link", ["rtu", "ascii"])
@pytest.mark.parametrize("device", ["ck10", "tc100"])
def test_groups_of_registers_pass_through_each_client(device: str, link: str, folder: Path) -> None:
    rig, dice = TransferRig(device, link, folder), random.Random(link)
    run = set()
    for group in rig.bench.world.layout.device.word_groups():
        for way, access in (("Write", groups.WRITABLE), ("Read", groups.READ)):
            block = rig.bench.world.block(way.lower(), group.name).removeprefix(f"FB_{rig.bench.world.names.device}_")
            if block not in rig.bench.blocks:
                continue
            run.add(block)
            registers = groups.registers(rig.proof, group, access)
            simple = [register for register in registers if answer_type(rig.bench.world, register) is None] or registers
            register = dice.choice(simple)
            address, count = register.address, register.words
            words: dict[int, int] = {}
            for _ in range(100):
                values = {
                    register.name: [
                        drawn_value(rig.bench.world.layout, register.register.value, dice)
                        if register.register.value.const is None
                        else register.register.value.const
                        for _ in range(register.count)
                    ]
                }
                try:
                    words = groups.encoded_words(rig.proof, [register], values, address, count)
                    break
                except CodecError:
                    continue
            assert len(words) == count, register.name
            name, lent = groups.member(rig.proof, group, register), rig.lent(block)
            value = rig.proof.register_in(register, values[register.name])
            rig.device.requests.clear()
            rig.device.words = {} if way == "Write" else dict(words)
            if way == "Write":
                rig.bench.ports[lent][name] = value
            assert rig.done(block, Address=address, Count=count) == "Done", block
            assert rig.device.requests == [(address, count)], block
            if way == "Write":
                assert rig.device.words == words, block
            elif register in simple:
                (first, *_) = groups.read_out(rig.proof, group, register, rig.bench.ports[lent])
                assert first == values[register.name][0], register.name
            rig.run(1, block, Count=0)
            assert rig.done(block) == f"Error {NUMBER['request']}", block
            assert len(rig.device.requests) == 1, block
    assert {block for block in transfers(device) if "Point" not in block} <= run


@pytest.mark.parametrize("device", ["ck10", "tc100"])
def test_elements_of_tables_pass_through_a_client(device: str, folder: Path) -> None:
    rig, dice = TransferRig(device, "rtu", folder), random.Random(2)
    layout = rig.bench.world.layout
    (record,) = {table.record.name: table.record for table in layout.tables.values()}.values()
    for block in sorted((name for name in transfers(device) if "Point" in name), reverse=True):
        data = b""
        while not data:
            values = drawn_values(layout, record, dice)
            try:
                data = encoded(record, values, layout.device)
            except CodecError:
                continue
        words, several = words_in(data, "words", layout.device.byte_order), block.endswith("s")
        struct, port = rig.proof.struct_in(record, values), rig.lent(block)
        if block.startswith("Write"):
            rig.bench.ports[port] = [dict(struct) for _ in rig.bench.ports[port]] if several else dict(struct)
        rig.device.requests.clear()
        numbers = {"First": 1, "Last": 2} if several else {"Number": 1}
        if block.startswith("Read"):
            rig.run(1)
            first = rig.done(block, **numbers)
            assert first in ("Done", f"Error {NUMBER['damaged']}"), block
            rig.device._write(rig.device.requests[0][0], words * 2)
            rig.device.requests.clear()
        assert rig.done(block, **numbers) == "Done", block
        assert [count for _, count in rig.device.requests] == [len(words)] * (2 if several else 1), block
        at = rig.device.requests[0][0]
        assert [rig.device.words[at + number] for number in range(len(words))] == words, block
        if block.startswith("Read"):
            element = rig.bench.ports[port][1 if device == "ck10" else 0] if several else rig.bench.ports[port]
            assert rig.proof.struct_out(record, element) == without(record, values), block


@pytest.mark.parametrize("device", ["ck10", "esc11", "hiwin-e"])
def test_messages_are_sent_as_the_reference_encodes_them_and_answers_are_taken(device: str, folder: Path) -> None:
    layout, dice = newest(SPECS, device), random.Random(device)
    rig = Rig.__new__(TransferRig)
    Rig.__init__(rig, bench(device, messages(device), folder))
    world, proof, run = rig.bench.world, Proof(rig.bench.world, rig.bench.program), set()
    rig.device = Tc100()
    for link in own_links(layout):
        for message in link.messages.values():
            name = world.block(*link_words(world, link), "send", message.name)
            block = name.removeprefix(f"FB_{world.names.device}_")
            if block not in rig.bench.blocks:
                continue
            run.add(block)
            rig.transport = Transport(rig.bench, FRAMES, rig.bench.lent[block, "Frames"], delay=1)
            reference, sent = codec(layout).links[link.name], []
            request, frame = drawn_frame(layout, reference, link, message, "request", {}, dice)
            heads = {part.name: request[part.name] for part in link.request.header if part.name in request}
            same = {field.name: request[field.name] for field in message.response.fields if field.name in request}
            _, answer = drawn_frame(layout, reference, link, message, "response", {**same, **heads}, dice)
            inputs = [n for owner, n in rig.bench.inputs if owner == block and n not in ("Execute", "Abort")]
            lent = [v for (owner, n), v in rig.bench.lent.items() if owner == block and n != "Frames"]
            values = proof.asked(link, message, request)
            scalars = [value for value in values if not isinstance(value, (list, dict))]
            rig.bench.set(block, **dict(zip(inputs, scalars, strict=True)))

            def carry(transport: Transport, answer: bytes = answer, sent: list[bytes] = sent) -> int:
                sent.append(bytes(transport.of("frame")[: transport.of("send")]))
                data = list(transport.of("frame"))
                data[: len(answer)] = answer
                transport.put("frame", data)
                transport.put("received", len(answer))
                return 0

            rig.device.exchanged = carry
            rig.bench.restart()
            rig.run(3, block, Execute=True)
            assert sent == [], "no edge has been seen"
            for variable, value in zip(lent, values[len(scalars) :], strict=False):
                rig.bench.ports[variable] = value
            assert rig.done(block) == "Done", block
            assert sent == [frame], block
    assert run == set(messages(device))


def drawn_frame(
    layout: Any, reference: Any, link: Any, message: Any, direction: str, fixed: dict[str, Any], dice: random.Random
) -> tuple[dict[str, Any], bytes]:
    """Random values of a message that the reference encodes, and its frame."""
    for _ in range(1000):
        values = {
            **{part.name: 1 for part in link.frame(direction).header if part.is_argument},
            **drawn_values(layout, message.data(direction), dice),
            **fixed,
        }
        try:
            frame = reference.encode(direction, message.name, values)
            if not reference.decode(frame, direction, message.name).error:
                return values, frame
        except CodecError:
            continue
    raise AssertionError((message.name, direction))
