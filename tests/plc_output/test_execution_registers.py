"""The generated functions for registers, enums and quantities are run, and agree with the reference codec."""

from __future__ import annotations

import random
import struct
import sys
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from comparisons import all_finite, compare_states
from drawing import drawn_bytes, drawn_value, drawn_values
from loaded import COMPUTING, DEVICES, NAMES, WAY_NAMES, WAYS, computing, judged, proof_by, words_in
from proving import Proof, without

from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.quantities import state_name
from fieldspec.codec.reference.records import decoded, decoded_value, encoded, encoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.targets.controllers.routines.enums import enum_routines
from fieldspec.targets.controllers.routines.quantities import quantities
from fieldspec.targets.controllers.routines.register_range import answer_name, answer_type
from fieldspec.targets.vectors.backend import idle_vectors
from layouts import SPECS, TEST_SPECS

pytestmark = pytest.mark.proof()

TRIES = 25
READ, WRITABLE = ("ro", "rw"), ("wo", "rw")


@pytest.fixture(params=WAYS, ids=WAY_NAMES, scope="module")
def prover(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """What is generated for each device."""
    return proof_by(request, tmp_path_factory)


def test_records_of_tables_agree_with_the_reference_on_random_words_and_values(prover: Proof) -> None:
    layout = prover.world.layout
    dice, order = random.Random(layout.device.id), layout.device.byte_order
    for record in {table.record.name: table.record for table in layout.tables.values()}.values():
        name = ordered(prover, "unpack", record.name)
        for _ in range(TRIES):
            data, first = drawn_bytes(record, dice), dice.randrange(len(prover.fresh(prover.world.words)))
            words, array = words_in(data, "words", order), prover.fresh(prover.world.words)
            first = min(first, len(array) - len(words))
            array[first : first + len(words)] = words
            copy = prover.machine.fresh(prover.world.names.structs[record.name].lower())
            value = {"aWords": array, "iFirst": first, "stData": copy}
            assert prover.run(name, **value, iCount=first + len(words) - 1)[0] == "incomplete"
            status, _ = prover.run(name, **value, iCount=first + len(words))
            try:
                expected = without(record, decoded(record, data, layout.device))
            except CodecError as error:
                judged(status, error, record.name)
                continue
            assert (status, prover.struct_out(record, copy)) == ("ok", expected)
        if not any(table.writable for table in layout.tables.values() if table.record.name == record.name):
            unit = prover.machine.unit.functions
            assert not any(name.startswith(prover.world.routine("pack", record.name).lower()) for name in unit)
            continue
        for _ in range(2 * TRIES):
            values = drawn_values(layout, record, dice)
            array = prover.fresh(prover.world.words)
            value = {"aWords": array, "iFirst": 1, "stData": prover.struct_in(record, values)}
            status, _ = prover.run(ordered(prover, "pack", record.name), **value)
            try:
                words = words_in(encoded(record, values, layout.device), "words", order)
            except CodecError as error:
                judged(status, error, values)
                continue
            assert (status, array[: len(words) + 2]) == ("ok", [0, *words, 0])


def ordered(prover: Proof, deed: str, name: str) -> str:
    """The function of a record or a group, whose name states the order of words."""
    start = prover.world.routine(deed, name).lower()
    (actual,) = (
        name
        for name in prover.machine.unit.functions
        if name.startswith(start) and name.removeprefix(start) in ("", "highwordfirst", "lowwordfirst")
    )
    return actual


def test_an_element_of_a_table_has_its_address(prover: Proof) -> None:
    for table in prover.world.layout.tables.values():
        name = prover.world.routine(table.name, "address")
        indexes = table.table.indexes
        for index in (indexes[0] - 1, *indexes, indexes[-1] + 1):
            status, (address,) = prover.positional(name, index)
            expected = ("ok", table.table.address(index)) if index in indexes else ("out_of_range", 0)
            assert (status, address) == expected


def registers(prover: Proof, group: RegisterGroup, access: tuple[str, ...]) -> list[RegisterLayout]:
    """The registers of a group that have one of some accesses; a trigger can be written in any case."""
    return [
        register
        for register in prover.world.layout.registers
        if register.register in group.registers
        and (register.register.access in access or (access == WRITABLE and register.register.trigger))
    ]


def spans(registers: list[RegisterLayout], most: int) -> Iterator[tuple[int, int]]:
    """Addresses and numbers of words to read: each register alone, too little of it, and all from each one on."""
    last = max(register.register.end for register in registers)
    for register in registers:
        yield register.address, register.words
    for register in random.Random(5).sample(registers, min(8, len(registers))):
        yield register.address, min(most, last - register.address)
        yield max(0, register.address - 1), min(most, register.words + 2)
        yield register.address, register.words - 1


def read_of(prover: Proof, register_layout: RegisterLayout, words: dict[int, int]) -> list[Any]:
    """What the reference makes of each element of a register; None for one that does not lie in the words."""
    result: list[Any] = []
    register, order = register_layout.register, prover.world.layout.device.byte_order
    for number in range(register_layout.count):
        at = register_layout.address + number * register_layout.stride
        if any(word not in words for word in range(at, at + register_layout.words)):
            result.append(None)
            continue
        data = b"".join(words[word].to_bytes(2, order) for word in range(at, at + register_layout.words))  # type: ignore[arg-type]
        raw = value_construct(register.answer, register_layout.order, register_layout.swapped).parse(
            data[: register.value.size]
        )
        result.append(decoded_value(register_layout.name, register.answer, raw, prover.world.layout.device, None))
    return result


@pytest.mark.proof(7)
def test_groups_of_registers_are_read_as_the_reference_reads_them(prover: Proof) -> None:
    dice, most = random.Random(1), prover.world.words.high + 1
    for group in prover.world.layout.device.word_groups():
        registers_of_group = registers(prover, group, READ)
        for address, count in spans(registers_of_group, most) if registers_of_group else ():
            words = {address + at: dice.choice([0, 0, 1, dice.randrange(1 << 16)]) for at in range(max(0, count))}
            array = [*words.values(), *([0xFFFF] * (most - len(words)))]
            copy = prover.machine.fresh(prover.world.names.structs[group.name].lower())
            before = {register.name: read_out(prover, group, register, copy) for register in registers_of_group}
            name = ordered(prover, "unpack", group.name)
            status, _ = prover.run(name, uiAddress=address, iCount=count, aWords=array, stData=copy)
            try:
                expected = {register.name: read_of(prover, register, words) for register in registers_of_group}
            except CodecError as error:
                judged(status, error, (group.name, address, count))
                continue
            if not all_finite([*expected.values()]):
                assert status == "no_number", (group.name, address, count)
                continue
            there = any(value is not None for values in expected.values() for value in values)
            assert status == ("ok" if there else "not_covered"), (group.name, address, count)
            for register in registers_of_group:
                pairs = zip(expected[register.name], before[register.name], strict=True)
                wanted = [old if new is None else new for new, old in pairs]
                assert read_out(prover, group, register, copy) == wanted, (register.name, address)


@pytest.mark.proof(4)
def test_the_registers_of_an_idle_device_are_read_as_the_vectors_say(prover: Proof) -> None:
    layout = prover.world.layout
    for read in idle_vectors([layout]):
        link, message = layout.links[read["link"]], layout.messages[read["message"]]
        for direction, run in (("request", prover.build), ("response", prover.parse)):
            frame, values = bytes.fromhex(read[direction]["right"]), read[direction]["values"]
            if direction == "request":
                assert run(link, message, values) == ("ok", frame), read["address"]
            else:
                assert run(link, message, frame)[0] == "ok", read["address"]
        answer = read["response"]["values"][message.message.single_access.values]
        words = answer if isinstance(answer, list) else [answer]
        is_bits = layout.device.bit_access(message.message) is not None
        most = len(prover.fresh(prover.world.bits if is_bits else prover.world.words))
        array = [*words, *([0] * (most - len(words)))]
        names = {name.partition("[")[0] for name in read["registers"]}
        for group in layout.device.groups:
            registers_of_group = [register for register in registers(prover, group, READ) if register.name in names]
            if not registers_of_group:
                continue
            copy = prover.machine.fresh(prover.world.names.structs[group.name].lower())
            value = {"uiAddress": read["address"], "iCount": read["words"], "stData": copy}
            value["aBits" if is_bits else "aWords"] = array
            assert prover.run(ordered(prover, "unpack", group.name), **value)[0] == "ok", (group.name, read["address"])
            for register in registers_of_group:
                for at, actual in enumerate(read_out(prover, group, register, copy)):
                    index = f"[{register.register.index_from + at}]" if register.count > 1 else ""
                    wanted = read["registers"].get(register.name + index, actual)
                    raw = actual.hex() if isinstance(actual, bytes) else actual
                    assert raw == wanted, register.name


def read_out(prover: Proof, group: RegisterGroup, register: RegisterLayout, value: dict[str, Any]) -> list[Any]:
    """What the elements of a register are in a variable: what was read, where that has a member of its own."""
    if answer_type(prover.world, register) is None:
        return prover.register_out(register, value[member(prover, group, register)])
    actual = value[prover.world.member(group.name, answer_name(register)).lower()]
    return list(actual) if register.count > 1 else [actual]


def member(prover: Proof, group: RegisterGroup, register: RegisterLayout) -> str:
    """The member of a register."""
    return prover.world.member(group.name, register.name).lower()


@pytest.mark.proof(7)
def test_groups_of_registers_are_written_as_the_reference_writes_them(prover: Proof) -> None:
    dice, most, device = random.Random(2), prover.world.words.high + 1, prover.world.layout.device
    for group in device.word_groups():
        registers_of_group = registers(prover, group, WRITABLE)
        for address, count in spans(registers_of_group, most) if registers_of_group else ():
            copy = prover.machine.fresh(prover.world.names.structs[group.name].lower())
            values = {
                register.name: [
                    drawn_value(prover.world.layout, register.register.value, dice) for _ in range(register.count)
                ]
                for register in registers_of_group
            }
            for register in registers_of_group:
                copy[member(prover, group, register)] = prover.register_in(register, values[register.name])
            array = [0] * most
            name = ordered(prover, "pack", group.name)
            status, _ = prover.run(name, uiAddress=address, iCount=count, aWords=array, stData=copy)
            try:
                words = encoded_words(prover, registers_of_group, values, address, count)
            except CodecError as error:
                judged(status, error, (group.name, address, count))
                continue
            if count > 0 and len(words) == count:
                assert (status, array) == ("ok", [*(words[address + at] for at in range(count)), *[0] * (most - count)])
            else:
                assert status == "not_covered", (group.name, address, count)


def encoded_words(
    prover: Proof, registers: list[RegisterLayout], values: dict[str, list[Any]], address: int, count: int
) -> dict[int, int]:
    """The words that the reference writes, by their addresses, of the registers that lie wholly in a range."""
    device, words = prover.world.layout.device, {}
    for register in registers:
        for number in range(register.count):
            at, value = register.address + number * register.stride, register.register.value
            if address <= at and at + register.words <= address + count:
                raw = encoded_value(register.name, value, values[register.name][number], device)
                data = (
                    value_construct(value, register.order, register.swapped).build(raw).ljust(2 * register.words, b"\0")
                )
                word_values = words_in(data, "words", device.byte_order)
                words |= {at + word: number_of for word, number_of in enumerate(word_values)}
    return words


def test_a_number_on_the_wire_is_a_member_of_its_enum_or_is_refused(prover: Proof) -> None:
    for enum in prover.world.layout.device.enums.values():
        names = [routine.name for routine in enum_routines(prover.world, enum)]
        known = {member.value: member for member in reversed(enum.members) if not member.unavailable}
        for raw in {*known, *(value + by for value in known for by in (-1, 1)), 0} if names else ():
            kind = prover.world.raw_type(enum.name)
            if not kind.low <= raw <= kind.high:
                continue
            valid, value = prover.machine.call(names[0], **{f"{prefix(prover, names[0])}": raw})
            assert valid == (raw in known), (enum.name, raw)
            if valid:
                kind_name = prover.world.names.enums[enum.name].name
                member_name = prover.world.names.enum_members[enum.name][known[raw].name]
                assert value == raw
                if prover.machine.unit.enums:
                    assert prover.machine.number(kind_name, member_name) == raw
                if names[1].lower() in prover.machine.unit.functions:
                    assert prover.machine.call(names[1], eValue=value) == (True, raw)


def prefix(prover: Proof, name: str) -> str:
    """The only input of a function."""
    return next(
        variable
        for role, variable, _, _ in prover.machine.unit.functions[name.lower()].variables
        if role == "VAR_INPUT"
    )


@pytest.mark.proof(6)
@pytest.mark.parametrize("way", COMPUTING)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_counts_become_quantities_and_quantities_the_nearest_counts(
    root: Path, device: str, way: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    prover = computing(root, device, way, tmp_path_factory)
    dice = random.Random(3)
    for name, same in quantities(prover.world.layout).items():
        value = same[0].value
        low, high = (value.ranges.low, value.ranges.high) if value.ranges else (value.type.low, value.type.high)
        sentinels = {sentinel.value for sentinel in value.sentinels}
        for raw in {low, high, low - 1, high + 1, 0, 1, *(dice.randint(low, high) for _ in range(8)), *sentinels}:
            if not value.type.low <= raw <= value.type.high:
                continue
            state = state_name(prover.world.layout.device, value, raw)
            status, (quantity, *marks) = prover.positional(prover.world.routine(name, "from_counts"), raw)
            assert status == ("ok" if state in ("", "out_of_range") else "out_of_range"), (name, raw)
            assert any(marks) == (state == "out_of_range"), (name, raw)
            if status == "ok":
                assert quantity == pytest.approx(float(value.in_unit(raw)), rel=1e-15, abs=1e-300)
                is_resolved = not state and abs(raw) < 1 << 40
                for beside in (Fraction(0), Fraction(49, 100), Fraction(-49, 100)) if is_resolved else ():
                    exact = (raw + beside) * Fraction(value.scale) + Fraction(value.offset)
                    assert counts(prover, name, float(exact)) == ("ok", raw), (name, raw, beside)
        assert counts(prover, name, float("nan"))[0] == "out_of_range"
        for bound, by in ((low, Decimal(-2)), (high, Decimal(2))):
            if abs(bound) <= 1 << 50:  # beyond it, a number of eight bytes does not resolve two counts
                quantity = float(value.in_unit(bound) + by * value.scale)
                assert counts(prover, name, quantity)[0] == "out_of_range"


@pytest.mark.proof(9)
@pytest.mark.parametrize("way", COMPUTING)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_special_values_and_values_out_of_range_are_told_from_others(
    root: Path, device: str, way: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    compare_states(computing(root, device, way, tmp_path_factory))


def counts(prover: Proof, name: str, quantity: float) -> tuple[str, int]:
    """The status and the count of a quantity."""
    status, (actual,) = prover.positional(prover.world.routine(name, "to_counts"), quantity)
    return status, actual


@pytest.mark.parametrize("way", COMPUTING)
def test_of_two_equally_near_counts_the_even_one_is_taken(way: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    prover = computing(TEST_SPECS, "widget", way, tmp_path_factory)
    result = [counts(prover, "temperature", -40 + half / 4) for half in (1, 3, 5, -1, -3, -5)]
    assert result == [("ok", number) for number in (0, 2, 2, 0, -2, -2)]


@pytest.mark.parametrize("way", COMPUTING)
def test_conversions_by_a_reference_agree_with_their_formula(
    way: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    prover = computing(SPECS, "hiwin-e", way, tmp_path_factory)
    for share in prover.world.layout.device.conversions.values():
        for raw in (0, 1, 77, share.full_scale // 3, share.full_scale // 2):
            exact = share.quantity(raw, Fraction(3000))
            name = prover.world.routine(share.name, "from_counts")
            status, (quantity, *marks) = prover.positional(name, raw, 3000.0)
            assert not any(marks)
            assert (status, quantity) == ("ok", pytest.approx(float(exact), rel=1e-12, abs=1e-12)), share.name
            status, (back,) = prover.positional(prover.world.routine(share.name, "to_counts"), float(exact), 3000.0)
            assert (status, back) == ("ok", raw), share.name
        assert prover.positional(prover.world.routine(share.name, "to_counts"), 1.0, 0.0)[0] == "out_of_range"


@pytest.mark.parametrize("way", COMPUTING)
def test_floats_are_made_of_their_bits_and_back_exactly(way: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    prover, dice = computing(TEST_SPECS, "widget", way, tmp_path_factory), random.Random(4)
    numbers = [0, 1, 0x7FFFFF, 0x800000, 0x3F800000, 0x7F7FFFFF, 0x80000001, 0xFF7FFFFF, 0xC0490FDB]
    for bits in [*numbers, *(dice.randrange(1 << 32) for _ in range(300)), 0x7F800000, 0xFF800000, 0x7FC00000]:
        (exact,) = struct.unpack(">f", bits.to_bytes(4, "big"))
        status, (value,) = prover.positional(prover.world.routine("real_from_bits"), bits)
        finite = bits >> 23 & 0xFF != 0xFF
        assert status == ("ok" if finite else "no_number"), hex(bits)
        if finite:
            assert value == exact
            assert prover.positional(prover.world.routine("bits_from_real"), exact) == ("ok", [bits]), hex(bits)
        else:
            assert prover.positional(prover.world.routine("bits_from_real"), exact)[0] == "no_number", hex(bits)
