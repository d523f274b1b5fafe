"""Compiled C and the reference agree on random bytes: what is refused and why, and what is encoded again."""

from __future__ import annotations

import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import SANITIZED, require_tool
from driver import records, settled, source

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.language.model.encoding import has_single_bytes, is_real
from fieldspec.targets.c.backend import files
from fieldspec.targets.c.runtime_files import status_names
from layouts import SPECS, TEST_SPECS, newest

REAL_DEVICES = ["ck10", "esc11", "hiwin-e", "tc100"]
INVENTED_DEVICES = [
    "gadget",
    "gizmo",
    "glider-x",
    "sealer",
    "beacon",
    "servo2",
    "caller",
    "scanner",
    "widget",
    "courier",
    "observer",
    "heatmeter",
    "coupler",
]
DEVICES = [*((SPECS, device) for device in REAL_DEVICES), *((TEST_SPECS, device) for device in INVENTED_DEVICES)]
TRIES = 60
NUMBERS = {name.removeprefix("err_"): number for number, name in enumerate(status_names())}


@pytest.fixture(params=DEVICES, ids=[device for _, device in DEVICES], scope="module")
def driver(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[DeviceLayout, Path]:
    """A layout, and the program that decodes and encodes with its header."""
    layout = newest(*request.param)
    folder = tmp_path_factory.mktemp("driver")
    for path, text in files([layout]).items():
        (folder / path).write_text(text, encoding="utf-8")
    (folder / "driver.c").write_text(source(layout), encoding="utf-8")
    require_tool(SANITIZED[0])
    subprocess.run([*SANITIZED, "-w", "-o", str(folder / "driver"), str(folder / "driver.c")], check=True)
    return layout, folder / "driver"


def answers(program: Path, lines: list[str]) -> Iterator[tuple[int, str | None]]:
    """For each line, the status of decoding and the bytes encoded again, None where encoding is refused."""
    text = "".join(f"{line}\n" for line in lines)
    result = subprocess.run([str(program)], input=text, capture_output=True, text=True, check=True)
    output_lines = result.stdout.splitlines()
    assert len(output_lines) == len(lines)
    for line in output_lines:
        status, second, again = line.split(" ")
        yield int(status), again if second == "0" else None


def values_to_encode(record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
    """The values that an encoder takes: those of reserved, constant and measuring fields are left out."""
    result = {}
    for field in record.fields:
        constant = field.value is not None and field.value.const is not None
        if constant or field.field.measures or field.field.reserved:
            continue
        value = values[field.name]
        if field.record is not None:
            inner = field.record
            value = (
                [values_to_encode(inner, item) for item in value] if field.is_list else values_to_encode(inner, value)
            )
        result[field.name] = value
    return result


def expected(layout: DeviceLayout, record: RecordLayout, data: bytes) -> tuple[int, str | None]:
    """The status of decoding in the reference and the bytes that it encodes again, None where it refuses to."""
    try:
        values = decoded(record, data, layout.device)
    except CodecError as error:
        return NUMBERS[error.reason], None
    try:
        return 0, encoded(record, values_to_encode(record, values), layout.device).hex()
    except CodecError:
        return 0, None


def random_bytes(record: RecordLayout, dice: random.Random) -> bytes:
    """Bytes that resemble a record: often of the right size, of small numbers, with a correct length or count field."""
    form = record
    if record.selector is not None and dice.random() < 0.8:
        number = dice.choice(list(record.chosen))
        form = record.chosen[number]
    most = form.most if form.most is not None else form.least + 40
    last = form.fields[-1] if form.fields else None
    size = dice.choice([form.least, dice.randint(form.least, most), max(0, form.least - 1), most + 1])
    if last is not None and last.field.repeat is not None and dice.random() < 0.6:
        size = last.offset + last.size * dice.randint(last.field.repeat.low, min(last.field.repeat.high, 20))
    data = bytearray(dice.randbytes(size))
    if dice.random() < 0.5:
        data = bytearray(dice.choice([0, 0, 0, 1, 1, 2, 0x30, 0x41, 0xFF]) for _ in range(size))
    if form is not record and record.selector is not None:
        put(data, record.selector, number)
    for field in form.fields:
        measure = field.field.measures
        other = form.named(measure.field) if measure is not None else None
        if measure is not None and other is not None and dice.random() < 0.8:
            length = len(data) - other.offset if other.count is None else other.size * other.count
            put(data, field, length if measure.of == "bytes" else length // other.size)
    return bytes(data)


def put(data: bytearray, field: FieldLayout, number: int) -> None:
    """Writes the number of a field, if there is room for both."""
    if len(data) >= field.offset + field.size and 0 <= number < 1 << (8 * field.size):
        order = "little" if field.order == "little" else "big"
        data[field.offset : field.offset + field.size] = number.to_bytes(field.size, order)  # type: ignore[arg-type]


def comparable(record: RecordLayout) -> bool:
    """Whether all bytes survive: no not-a-numbers, which are several, and no value that other bytes are too."""
    inner = [field.record for field in record.fields if field.record is not None]
    encodings = [field.value.encoding for field in record.fields if field.value is not None]
    return not any(map(is_real, encodings)) and all(map(has_single_bytes, encodings)) and all(map(comparable, inner))


@pytest.mark.proof(3)
def test_c_and_the_reference_agree_on_random_bytes(driver: tuple[DeviceLayout, Path]) -> None:
    layout, program = driver
    dice = random.Random(layout.device.id)
    layouts_by_name = records(layout)
    cases = [
        (name, random_bytes(record, dice))
        for name, record in layouts_by_name.items()
        for _ in range(TRIES * max(1, len(record.chosen)))
    ]
    taken = set()
    for (name, data), answer in zip(
        cases, answers(program, [f"{name} {data.hex()}" for name, data in cases]), strict=True
    ):
        record = layouts_by_name[name].of_data(data)
        status, expected_text = expected(layout, layouts_by_name[name], data)
        assert answer[0] == status, (name, data.hex(), answer)
        if status == 0 and record is not None and comparable(record):
            assert answer[1] == expected_text, (name, data.hex(), answer)
            taken.add(name)
    assert taken >= {name for name, record in layouts_by_name.items() if record.selector is not None}


@pytest.mark.proof(7)
def test_c_and_the_reference_agree_on_damaged_frames(driver: tuple[DeviceLayout, Path]) -> None:
    layout, program = driver
    dice = random.Random(layout.device.id)
    reference = codec(layout)
    cases = []
    for example in layout.device.examples.values():
        for _ in range(8):
            frame = bytearray(example.frame)
            for _ in range(dice.randint(0, 2)):
                frame[dice.randrange(len(frame))] = dice.choice([0, 1, 0x30, 0x41, 0xFF])
            cases.append((example, bytes(frame[: dice.choice([len(frame), len(frame), len(frame) - 1])])))
    lines = [f"{example.link}.{example.direction} {frame.hex()}" for example, frame in cases]
    for (example, frame), (status, _) in zip(cases, answers(program, lines), strict=True):
        shape = layout.links[example.link].frame(example.direction)
        try:
            reference.links[example.link].decode(frame, example.direction, example.message)
            reason, offset = "", None
        except CodecError as error:
            reason, offset = error.reason, error.offset
        of_values = reason in ("unknown_value", "wrong_const", "wrong_measure")
        # A frame whose delimiters or characters are wrong has no parts.
        size = len(reference.links[example.link].parts(frame, example.direction)) if of_values else 0
        behind = {part.at(size) for part in shape.trailer} if of_values else set()
        inside = of_values and (offset is None or (offset >= shape.header_size and offset not in behind))
        if reason == "" or inside:
            assert status == 0, (example.id, frame.hex(), reason, status)
        elif reason in ("wrong_mark", "not_hex", "wrong_checksum", "wrong_const"):
            assert status == NUMBERS[reason], (example.id, frame.hex(), reason, status)


def test_a_name_that_would_occur_twice_gets_a_number() -> None:
    naming = settled(newest(TEST_SPECS, "widget"))
    first, second = naming.macro("enum", "a_b", "c"), naming.macro("enum", "a", "b_c")
    assert [first, second] == ["WIDGET_A_B_C", "WIDGET_A_B_C_2"]
    assert naming.macro("enum", "a_b", "c") == first
    assert naming.type("record", "codec_status") == "widget_codec_status_2"
