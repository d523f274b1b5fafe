"""Compiled C and the reference codec agree on random bytes: on what is refused, and on what is written again."""

from __future__ import annotations

import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiling import require_tool
from driver import records, source

from fieldspec.backends.c.backend import files
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.primitive import Kind
from fieldspec.reference import CodecError, codec
from fieldspec.reference.records import decoded, encoded
from laid_out import MADE_UP, SPECS, newest

DEVICES = [(SPECS, "tc100"), (SPECS, "esc11"), (MADE_UP, "widget"), (MADE_UP, "gadget"), (MADE_UP, "gizmo")]
TRIES = 60


def program(layout: DeviceLayout, folder: Path) -> Path:
    for path, text in files([layout]).items():
        (folder / path).write_text(text, encoding="utf-8")
    (folder / "driver.c").write_text(source(layout), encoding="utf-8")
    target = folder / "driver"
    command = [require_tool("gcc"), "-std=c99", "-w", "-fsanitize=address,undefined", "-o", str(target)]
    subprocess.run([*command, str(folder / "driver.c")], check=True)
    return target


def given(record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
    """The values without those that nobody gives: reserved, constant and measuring fields."""
    kept = {}
    for field in record.fields:
        constant = field.value is not None and field.value.const is not None
        if constant or field.field.measures or field.field.reserved:
            continue
        held = values[field.name]
        if field.record is not None:
            inner = field.record
            held = [given(inner, item) for item in held] if field.listed else given(inner, held)
        kept[field.name] = held
    return kept


def expected(layout: DeviceLayout, record: RecordLayout, data: bytes) -> tuple[bool, str | None]:
    """Whether the reference takes the bytes, and what it writes again, None where it refuses that."""
    try:
        values = decoded(record, data, layout.device)
    except CodecError:
        return False, None
    try:
        return True, encoded(record, given(record, values), layout.device).hex()
    except CodecError:
        return True, None


def random_bytes(record: RecordLayout, dice: random.Random) -> bytes:
    """Bytes near what a record may be: often of the right size, often small numbers."""
    most = record.most if record.most is not None else record.least + 40
    size = dice.choice([record.least, dice.randint(record.least, most), max(0, record.least - 1), most + 1])
    if dice.random() < 0.5:
        return dice.randbytes(size)
    return bytes(dice.choice([0, 0, 0, 1, 1, 2, 0x30, 0x41, 0xFF]) for _ in range(size))


def comparable(record: RecordLayout) -> bool:
    """Whether all bytes survive: floats have several not-a-numbers, and a C text ends at its first zero."""
    inner = [field.record for field in record.fields if field.record is not None]
    kinds = [field.value.type.kind for field in record.fields if field.value is not None]
    return Kind.FLOAT not in kinds and Kind.TEXT not in kinds and all(map(comparable, inner))


@pytest.mark.parametrize(("root", "device"), DEVICES, ids=[device for _, device in DEVICES])
def test_c_and_the_reference_agree_on_random_bytes(root: Path, device: str, tmp_path: Path) -> None:
    layout = newest(root, device)
    dice = random.Random(device)
    held = records(layout)
    cases = [(name, random_bytes(record, dice)) for name, record in held.items() for _ in range(TRIES)]
    text = "".join(f"{name} {data.hex()}\n" for name, data in cases)
    result = subprocess.run([str(program(layout, tmp_path))], input=text, capture_output=True, text=True, check=True)
    lines = result.stdout.splitlines()
    assert len(lines) == len(cases)
    for (name, data), line in zip(cases, lines, strict=True):
        status, second, *again = line.split(" ")
        taken, written = expected(layout, held[name], data)
        assert (status == "0") == taken, (name, data.hex(), line)
        if taken and comparable(held[name]):
            assert (again[0] if second == "0" else None) == written, (name, data.hex(), line)


@pytest.mark.parametrize(("root", "device"), DEVICES, ids=[device for _, device in DEVICES])
def test_c_and_the_reference_agree_on_damaged_frames(root: Path, device: str, tmp_path: Path) -> None:
    layout = newest(root, device)
    dice = random.Random(device)
    reference = codec(layout)
    cases = []
    for example in layout.device.examples.values():
        for _ in range(8):
            frame = bytearray(example.frame)
            for _ in range(dice.randint(0, 2)):
                frame[dice.randrange(len(frame))] = dice.choice([0, 1, 0x30, 0x41, 0xFF])
            cases.append((example, bytes(frame[: dice.choice([len(frame), len(frame), len(frame) - 1])])))
    text = "".join(f"{example.link}.{example.direction} {frame.hex()}\n" for example, frame in cases)
    result = subprocess.run([str(program(layout, tmp_path))], input=text, capture_output=True, text=True, check=True)
    for (example, frame), line in zip(cases, result.stdout.splitlines(), strict=True):
        try:
            reference.links[example.link].decode(frame, example.direction, example.message)
            reason = ""
        except CodecError as error:
            reason = error.reason
        opened = line.split(" ")[0] == "0"
        whole = reason in ("", "unknown_value", "wrong_const", "wrong_measure")
        assert opened or not whole, (example.id, frame.hex(), reason, line)
        if reason in ("wrong_mark", "not_hex", "wrong_check"):
            assert not opened, (example.id, frame.hex(), reason, line)
