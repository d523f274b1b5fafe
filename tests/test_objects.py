"""Objects with index and sub-index: the bytes of their values in every generated language, and on the command line."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.explain.explanation import explained
from fieldspec.targets.c.backend import files
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

sys.path.insert(0, str(Path(__file__).parent / "js_output"))

from javascript import module_path

NODE = newest(TEST_SPECS, "node")
MODULE = module_of(NODE)
VALUES = MODULE.objects.VALUES
ELEMENTS = {
    "torque": (-100, "9c"),
    "password": (0xBEEF, "efbe"),
    "speed": (-1.5, "0000c0bf"),
    "offset": (-2, "feffffff"),
    "enabled": (True, "01"),
}
SIZES = {1: 0x4F, 2: 0x4B, 4: 0x43}
HEAD = "00 00 05 85 08 00 00 00"

PROGRAM = """
import { readFileSync } from "node:fs";
const { Objects } = await import(process.argv[1]);
const { values } = Objects.parameters;
const hex = (bytes) => Buffer.from(bytes).toString("hex");
for (const [subindex, value, size, data] of JSON.parse(readFileSync(0, "utf8"))) {
  const response = { size, data: Uint8Array.from(Buffer.from(data, "hex")) };
  const read = Objects.valueIn(response, values, subindex);
  const row = [hex(values.toBytes(value, subindex)), read, values.accessOf(subindex)];
  for (const wrong of [{ ...response, size: size === 0x47 ? 0x43 : 0x47 }, { ...response, size: 0 }]) {
    try { Objects.valueIn(wrong, values, subindex); row.push(""); } catch (error) { row.push(error.reason); }
  }
  console.log(JSON.stringify(row));
}
"""


def test_an_element_has_the_same_bytes_in_python_and_javascript() -> None:
    jobs = []
    for name, (value, data) in ELEMENTS.items():
        assert VALUES.to_bytes(value, VALUES.index(name)).hex() == data
        assert VALUES.from_bytes(bytes.fromhex(data), VALUES.index(name)) == value
        jobs.append([VALUES.index(name), value, SIZES[len(data) // 2], data.ljust(8, "0")])
    run = subprocess.run(
        [require_tool("node"), "--input-type=module", "-e", PROGRAM, module_path(NODE)],
        input=json.dumps(jobs),
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    rows = [json.loads(line) for line in run.stdout.splitlines()]
    access = {"password": "wo"}
    assert rows == [
        [data, value, access.get(name, "rw"), "wrong_length", "wrong_length"]
        for name, (value, data) in ELEMENTS.items()
    ]


def test_the_number_of_bytes_chooses_the_message_that_writes() -> None:
    requests = [
        MODULE.objects.write_request(VALUES, value, subindex=VALUES.index(name))
        for name, (value, _) in ELEMENTS.items()
    ]
    assert [type(request).__name__ for request in requests] == [
        f"Download{len(data) // 2}Request" for _, data in ELEMENTS.values()
    ]
    with pytest.raises(codec_error(), match=r"values.torque .*-101"):
        MODULE.objects.write_request(VALUES, -101, subindex=1)
    with pytest.raises(codec_error(), match=r"values.count can only be read"):
        MODULE.objects.write_request(VALUES, 1, subindex=VALUES.index("count"))


@pytest.mark.parametrize(
    ("data", "value", "verdict"),
    [
        ("4F 00 20 01 9C 00 00 00", "-100 %", ""),
        ("43 00 20 05 FE FF FF FF", "-0.002 mm", ""),
        ("4F 00 20 01 7F 00 00 00", "127 %", "wrong: should be -100..100 %"),
        ("4B 00 20 01 9C 00 00 00", "", "wrong: should be 1 byte"),
    ],
)
def test_a_response_is_explained_by_the_object(data: str, value: str, verdict: str) -> None:
    row = explained(NODE, "sdo", "response", bytes.fromhex(f"{HEAD} {data}"), "upload").rows[-1]
    assert (row.value, row.verdict) == (value, verdict)
    assert row.meanings[0].name.startswith("values.")


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        (["upload", "index=error_register"], "00 00 06 05 08 00 00 00 40 01 10 00 00 00 00 00"),
        (["upload", "index=1018h", "subindex=serial_number"], "00 00 06 05 08 00 00 00 40 18 10 04 00 00 00 00"),
        (
            ["download_4", "index=values", "subindex=offset", "data=-1.5 mm"],
            "00 00 06 05 08 00 00 00 23 00 20 05 24 FA FF FF",
        ),
        (["download_2", "index=0x3000", "subindex=0", "data=12 34"], "00 00 06 05 08 00 00 00 2B 00 30 00 12 34 00 00"),
    ],
)
def test_encode_writes_objects_by_name(arguments: list[str], frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["encode", "node", *arguments, "node=5", "--specs", str(TEST_SPECS)]) == 0
    assert capsys.readouterr().out.strip() == frame


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (
            ["download_2", "index=values", "subindex=torque", "data=5"],
            "values has 1 byte; use another message",
        ),
        (["download_1", "index=values", "subindex=highest_subindex", "data=5"], "values can only be read"),
        (["download_1", "index=values", "subindex=9", "data=5"], "values has no element 9"),
        (["download_1", "index=values", "subindex=torque", "data=101"], "not in -100..100"),
    ],
)
def test_encode_refuses_what_no_object_takes(
    arguments: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["encode", "node", *arguments, "node=5", "--specs", str(TEST_SPECS)]) == 2
    assert text in capsys.readouterr().err


@pytest.mark.parametrize(
    ("data", "clean"),
    [
        ("43 18 10 04 78 56 34 12", "43 18 10 04 00 00 00 00"),
        ("4B 00 20 02 34 12 AA BB", "4B 00 20 02 34 12 00 00"),
        ("43 00 30 00 78 56 34 12", "43 00 30 00 00 00 00 00"),
    ],
)
def test_redacted_responses_have_no_serial_number_and_nothing_behind_a_value(data: str, clean: str) -> None:
    redaction = Redaction(NODE, Secrets())
    frame = bytes.fromhex(f"{HEAD} {data}")
    decoded = redaction.codec.links["sdo"].decode(frame, "response", "upload")
    assert redaction.frame("sdo", "response", frame, decoded, {}) == bytes.fromhex(f"{HEAD} {clean}")


C_PROGRAM = """
#include "node_v1.h"
int main(void)
{
    static const uint8_t body[] = {0x4B, 0x00, 0x20, 0x02, 0x34, 0x12, 0x00, 0x00};
    node_upload_response response;
    size_t size = 0u;
    uint16_t count = 0u;
    if (node_upload_response_decode(body, sizeof body, &response) != NODE_OK) {
        return 1;
    }
    if (node_par_objects_upload_response_data_size(&response, &size) != NODE_OK) {
        return 2;
    }
    if (size != NODE_PAR_OBJECTS_VALUES_COUNT_SIZE || size == NODE_PAR_OBJECTS_VALUES_SPEED_SIZE) {
        return 3;
    }
    return node_par_objects_values_count_decode(response.data, &count) != NODE_OK || count != 0x1234u ? 4 : 0;
}
"""


def test_a_header_says_how_many_bytes_of_a_response_are_the_value(tmp_path: Path) -> None:
    for path, text in files([NODE]).items():
        place = tmp_path / Path(path).name
        place.write_text(str(text), encoding="utf-8")
    (tmp_path / "program.c").write_text(C_PROGRAM, encoding="utf-8")
    program = tmp_path / "program"
    warnings = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
    command = [require_tool("gcc"), *warnings, str(tmp_path / "program.c"), "-o", str(program)]
    subprocess.run(command, check=True)
    assert subprocess.run([str(program)], check=False).returncode == 0
