"""A log or a capture costs little for each line and value. Calls are counted, as clocks differ from run to run."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable, Iterator
from types import FrameType

import numpy as np
import pytest

from command_line import SPECS, CommandLine
from fieldspec.codec.explain.values import decode_value
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Truth, Whole
from fieldspec.language.model.value import Value
from fieldspec.tools.captures.decoders import Decoder
from fieldspec.tools.captures.text_list import TextList
from fieldspec.tools.captures.verdicts import OK, UNLISTED_BITS, UNLISTED_MEMBER, VERDICT_NUMBERS
from layouts import all_layouts, newest
from test_libmodbus import crc

LINES = 60
MOST_CALLS = 8000
"""The calls for a line. Each reading of a frame takes some hundreds, and each register that is printed some tens."""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, SPECS)


def calls(work: Callable[[], object]) -> int:
    """The calls of Python functions that some work takes."""
    number = 0

    def count(_: FrameType, event: str, __: object) -> None:
        nonlocal number
        number += event == "call"

    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(None)
    return number


def log(count: int, damage: int) -> bytes:
    """Reads of registers of the TC100, each answered with other words; `damage` is done to the checksums."""
    chance = random.Random(count)
    lines = []
    for _ in range(count // 2):
        words = chance.choice((1, 2, 10))
        address = chance.choice((0x1000, 0x1005, 0x2000, 0x2010)).to_bytes(2, "big")
        for frame in (b"\1\3" + address + bytes((0, words)), bytes((1, 3, 2 * words)) + chance.randbytes(2 * words)):
            sent = frame + crc(frame)
            lines.append((sent[:-1] + bytes([sent[-1] ^ damage])).hex(" "))
    return "\n".join(lines).encode()


@pytest.mark.parametrize("damage", [0, 0x55], ids=["whole", "damaged"])
def test_a_line_of_a_log_takes_few_calls(run: CommandLine, damage: int) -> None:
    def explain(count: int) -> int:
        return calls(lambda: run("decode", "tc100", "-", stdin=log(count, damage)))

    explain(4)  # what is read and made once
    assert explain(LINES) - explain(4) < MOST_CALLS * (LINES - 4)


def test_the_lines_of_a_log_that_repeats_itself_take_still_fewer(run: CommandLine) -> None:
    once = log(LINES // 10, 0)
    explain = [
        calls(lambda count=count: run("decode", "tc100", "-", stdin=b"\n".join([once] * count))) for count in (1, 10)
    ]
    assert explain[1] < 4 * explain[0]


def named_values() -> Iterator[tuple[Device, Value]]:
    """The values of registers whose numbers have names, each once."""
    visited = set()
    for layout in all_layouts():
        for register in layout.registers:
            value = register.register.value
            key = layout.device.id, value.type.name, value.enum, value.flags, repr(value.sentinels), value.const
            if (
                (value.enum or value.flags or value.sentinels)
                and isinstance(value.encoding, Whole | Truth)
                and key not in visited
            ):
                visited.add(key)
                yield layout.device, value


def test_columns_name_and_judge_numbers_as_an_explanation_does() -> None:
    chance = random.Random(1)
    for device, value in named_values():
        texts = TextList()
        decoder = Decoder(device, texts, value, "big", False, False, False)
        size = value.size
        numbers = [*range(40), *(chance.getrandbits(8 * size) for _ in range(60)), (1 << 8 * size) - 1]
        data = [(number % (1 << 8 * size)).to_bytes(size, "big") for number in numbers]
        columns = decoder.decode(np.frombuffer(b"".join(data), np.uint8), np.arange(len(data)) * size)
        for row, raw in enumerate(data):
            read = decode_value(device, value, raw, "big", False)
            names = [own.name or f"bit_{own.bits}" for own in read.meanings if own.kind != "state"]
            text = texts.texts[columns.text[row]] if columns.text[row] >= 0 else ""
            assert text == "+".join(names), (device.id, value, raw.hex())
            verdict = int(columns.verdict[row])
            known = OK if verdict in (UNLISTED_BITS, UNLISTED_MEMBER) else verdict
            assert known == VERDICT_NUMBERS.get(read.reason, OK), (device.id, value, raw.hex())


def test_a_word_of_bits_takes_no_call_for_each_of_its_numbers() -> None:
    device = newest(SPECS, "ck10").device
    word = next(register.value for register in device.registers() if register.value.flags and register.value.size == 2)
    decoder = Decoder(device, TextList(), word, "big", False, False, False)
    buffer = np.arange(1 << 16, dtype=">u2").view(np.uint8)
    assert calls(lambda: decoder.decode(buffer, np.arange(1 << 16) * 2)) < 2 << 16
