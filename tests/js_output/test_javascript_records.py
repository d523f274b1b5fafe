"""Records refuse what is not a value of theirs, for the reason that the reference has."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from javascript import module_path, package

from external_tools import require_tool
from fieldspec.codec.reference.records import CodecError, encoded
from fieldspec.foundation.names import Name
from layouts import SPECS, TEST_SPECS, layouts, newest

LAYOUT = layouts(SPECS)["hiwin-e"][-1]
RECORD = LAYOUT.messages["telegram_111"].response
RIGHT: dict[str, Any] = {field.name: 7 for field in RECORD.fields if not field.field.reserved}
FIRST = next(iter(RIGHT))
PROGRAM = """
const { Telegram111Response } = await import(process.argv[1]);
try {
  console.log(Array.from(Telegram111Response.encode(JSON.parse(process.argv[2]))).join(" "));
} catch (error) {
  console.log(error.reason);
}
"""
VALUES: dict[str, dict[str, Any]] = {
    "all fields": RIGHT,
    "a field too many": {**RIGHT, "other": 1},
    "a field too few": {name: number for name, number in RIGHT.items() if name != FIRST},
    "a name for another": {**{name: number for name, number in RIGHT.items() if name != FIRST}, "other": 1},
    "a number that is too great": {**RIGHT, FIRST: 0x10000},
    "a number that is too small": {**RIGHT, FIRST: -1},
    "a number too great, and a field too many": {**RIGHT, FIRST: 0x10000, "other": 1},
    "no whole number": {**RIGHT, FIRST: 1.5},
    "a text": {**RIGHT, FIRST: "5"},
}


def expected(values: dict[str, Any]) -> str:
    """The bytes of some values, or the reason of the refusal, by the reference."""
    try:
        return " ".join(map(str, encoded(RECORD, values, LAYOUT.device)))
    except CodecError as error:
        return error.reason


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", VALUES)
def test_a_record_has_the_bytes_or_the_reason_of_the_reference(name: str) -> None:
    values = {Name.of(key).camel(): value for key, value in VALUES[name].items()}
    command = [require_tool("node"), "--input-type=module", "-e", PROGRAM, module_path(LAYOUT), json.dumps(values)]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    assert run.stdout.strip() == expected(VALUES[name])


NO_OBJECTS = """
const record = (await import(process.argv[1]))[process.argv[2]];
const reasons = [null, undefined, 5, "abcdefghi", () => 1].map((value) => {
  try {
    return `${record.encode(value)}`;
  } catch (error) {
    return error.reason;
  }
});
console.log(reasons.join(" "));
"""


@pytest.mark.parametrize("name", ["WriteRegisterRequest", "ReportServerIdRequest"])
def test_a_record_refuses_what_is_not_an_object_even_without_fields(name: str) -> None:
    module = module_path(layouts(SPECS)["ck10"][-1])
    command = [require_tool("node"), "--input-type=module", "-e", NO_OBJECTS, module, name]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert printed.split() == ["wrong_type", "missing_value", "wrong_type", "wrong_type", "wrong_type"]


LONG = """
const { record } = await import(process.argv[1]);
const size = (value) => value.size;
const codec = record({ name: "log", least: 0, most: 2 ** 31, write: () => 0, size, keys: { size: 0 }, units: {} });
try {
  console.log(codec.encode({ size: Number(process.argv[2]) }).length);
} catch (error) {
  console.log(`${error.reason}: ${error.detail}`);
}
"""


@pytest.mark.parametrize(
    ("size", "printed"), [(9, "9"), (2**30, "wrong_length: log has 1073741824 bytes, which are too many")]
)
def test_a_record_is_as_long_as_the_offsets_of_its_functions_reach(size: int, printed: str) -> None:
    module = str(package() / "runtime" / "record.js")
    command = [require_tool("node"), "--input-type=module", "-e", LONG, module, str(size)]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip() == printed


def test_data_of_a_case_without_data_may_be_left_out() -> None:
    program = """
const { DataRecord } = await import(process.argv[1]);
const { data, ...other } = DataRecord.decode(new Uint8Array([0, 0x13]));
console.log(Array.from(DataRecord.encode(other)).join(" "), data.length);
"""
    command = [require_tool("node"), "--input-type=module", "-e", program, module_path(newest(TEST_SPECS, "heatmeter"))]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == "0 19 0\n"
