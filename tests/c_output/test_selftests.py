"""The C headers, judged by compilers and by the self-tests that are generated with them."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import COMPILERS, compiled, require_tool

from fieldspec.foundation.names import stem
from fieldspec.language.reading.project import read
from fieldspec.targets.c.backend import files
from layouts import SPECS, TEST_SPECS, layout_at, layouts

KNOT = read({"knot-1/device.yaml": (Path(__file__).parent / "knot.yaml").read_bytes()}).devices["knot-1"]
VERSIONS = [versions for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]
VERSIONS.append([layout_at(KNOT, version) for version in KNOT.versions()])
HEADERS = {
    f"{stem(layout.device.id, layout.device.version)}.h": number
    for number, versions in enumerate(VERSIONS)
    for layout in versions
}
"""The number of its device for each header."""
TEST_DEVICES = tuple(stem(device, "") for device in layouts(TEST_SPECS) if device != "widget")
NEWEST = {stem(versions[-1].device.id, versions[-1].device.version) + ".h" for versions in VERSIONS}


def compilers_of(header: str) -> Iterable[str]:
    """All compilers for the newest version of a real device and for the device with everything, some for the others."""
    if header in NEWEST and not header.startswith(TEST_DEVICES):
        return [compiler for compiler in COMPILERS if compiler != "clang"]  # it makes the sanitized one
    return ("sanitized", "tcc") if header in NEWEST else ("g++",)


@cache
def texts_of(header: str) -> Mapping[str, str]:
    """The files of the device of a header, which only the tests that run need."""
    return files(VERSIONS[HEADERS[header]])


def write_selftest(folder: Path, header: str) -> Path:
    """Writes the self-test of a header, and both headers beside it; returns the path of the self-test."""
    source = header.replace(".h", "_selftest.c")
    for path in (header, header.replace(".h", "_constants.h"), source):
        (folder / path).write_text(texts_of(header)[path], encoding="utf-8", newline="\n")
    return folder / source


@pytest.mark.proof(10)
@pytest.mark.parametrize(
    ("header", "compiler"),
    [(header, compiler) for header in sorted(HEADERS) for compiler in compilers_of(header)],
)
def test_a_header_compiles_without_a_warning_and_passes_its_self_test(
    header: str, compiler: str, tmp_path: Path
) -> None:
    program = compiled(compiler, write_selftest(tmp_path, header), tmp_path / "selftest")
    result = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout
    assert result.stdout.endswith(" passed, 0 failed\n")


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [
        ("tc100_v2_0", "tc100_store_u16_be(out + 6, ", "tc100_store_u16_be(out + 8, "),
        ("glider_x_v1_1", "out->values.integer8[at] = glider_x_signed_8(", "out->values.integer8[at] = (int8_t)(1 + "),
        ("glider_x_v1_1", "element = 2u;", "element = 1u;"),
        ("glider_x_v1_1", "STATUS_WORD_STATE_RUNNING_VALUE 0x0003u", "STATUS_WORD_STATE_RUNNING_VALUE 0x0001u"),
        ("glider_x_v1_1", "GLIDER_X_PAR_SERVO_BASE 0x2000u", "GLIDER_X_PAR_SERVO_BASE 0x2001u"),
        ("glider_x_v1_1", "rest >= 0.5 && whole % 2 != 0", "rest >= 0.5"),
        ("glider_x_v1_1", "(double)raw / 16384.0", "(double)raw / 16383.0"),
        ("glider_x_v1_1", '{INT64_C(3808), INT64_C(78), "AL.EE0"', '{INT64_C(3808), INT64_C(79), "AL.EE0"'),
    ],
)
def test_a_self_test_fails_when_the_header_is_wrong(name: str, right: str, wrong: str, tmp_path: Path) -> None:
    source = write_selftest(tmp_path, f"{name}.h")
    headers = [tmp_path / f"{name}.h", tmp_path / f"{name}_constants.h"]
    (header,) = (header for header in headers if right in header.read_text("utf-8"))
    header.write_text(header.read_text("utf-8").replace(right, wrong, 1), encoding="utf-8")
    program = compiled("gcc", source, tmp_path / "selftest")
    assert subprocess.run([str(program)], capture_output=True, check=False).returncode == 1


def test_a_machine_without_double_gets_none(tmp_path: Path) -> None:
    source = write_selftest(tmp_path, "glider_x_v1_1.h")
    assert compiled("gcc", source, tmp_path / "selftest.o", "-DGLIDER_X_WITHOUT_DOUBLE", "-ffreestanding", "-c")
    command = [require_tool("gcc"), "-E", "-P", "-DGLIDER_X_WITHOUT_DOUBLE", str(tmp_path / "glider_x_v1_1.h")]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert "glider_x_telegram_3_request_encode" in text
    assert re.findall(r"glider.*\bdouble\b.*", text) == []


def test_two_versions_of_a_device_cannot_be_included_together(tmp_path: Path) -> None:
    for header in ("tc100_v2_0.h", "tc100_before_2_0.h"):
        write_selftest(tmp_path, header)
    source = tmp_path / "both.c"
    source.write_text('#include "tc100_v2_0.h"\n#include "tc100_before_2_0.h"\nint main(void) { return 0; }\n')
    with pytest.raises(AssertionError, match="another version of this device"):
        compiled("gcc", source, tmp_path / "both")


def test_the_wide_table_gives_the_same_checksum(tmp_path: Path) -> None:
    source = write_selftest(tmp_path, "tc100_v2_0.h")
    program = compiled("gcc", source, tmp_path / "selftest", "-DTC100_WIDE_CRC_TABLE")
    assert subprocess.run([str(program)], capture_output=True, check=False).returncode == 0
