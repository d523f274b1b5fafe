"""A common header of a device includes the header of the version that is selected at compile time."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled

from fieldspec.targets.c.backend import files
from layouts import SPECS, layouts

VERSIONS = layouts(SPECS)["esc11"]
PROGRAM = """
#include <stdio.h>
#include "esc11.h"
#include "esc11.h"
int main(void) { puts(ESC11_VERSION); puts(ESC11_IDENTITY); return 0; }
"""


def program(folder: Path, compiler: str, *flags: str, code: str = PROGRAM) -> list[str]:
    """The output lines of a program that is compiled with some flags."""
    for path, text in files(VERSIONS).items():
        (folder / path).write_text(text, encoding="utf-8", newline="\n")
    source = folder / "program.c"
    source.write_text(code, encoding="utf-8")
    compilation = compiled(compiler, source, folder / "program", "-Wno-unused-function", *flags)
    return subprocess.run([str(compilation)], capture_output=True, text=True, check=True).stdout.split()


@pytest.mark.parametrize("compiler", ["gcc", "clang", "g++"])
@pytest.mark.parametrize(("name", "version"), [("V1_17", "1.17"), ("BEFORE_1_17", "before-1.17"), ("LATEST", "1.17")])
def test_the_selected_version_is_included(name: str, version: str, compiler: str, tmp_path: Path) -> None:
    (layout,) = (layout for layout in VERSIONS if layout.device.version == version)
    output = program(tmp_path, compiler, f"-DESC11_SELECT=ESC11_SELECT_{name}")
    assert output == [version, layout.identity]


def test_the_version_may_be_named_in_the_program(tmp_path: Path) -> None:
    code = f"#define ESC11_SELECT ESC11_SELECT_BEFORE_1_17\n{PROGRAM}"
    assert program(tmp_path, "gcc", code=code)[0] == "before-1.17"


@pytest.mark.parametrize("flags", [(), ("-DESC11_SELECT=ESC11_SELECT_V9_9", "-Wno-undef"), ("-DESC11_SELECT=",)])
def test_an_unknown_or_missing_version_stops_the_compiler(flags: tuple[str, ...], tmp_path: Path) -> None:
    with pytest.raises(AssertionError, match="one of ESC11_SELECT_BEFORE_1_17, ESC11_SELECT_V1_17 or"):
        program(tmp_path, "gcc", *flags)


def test_the_header_of_a_device_with_one_version_is_that_version(tmp_path: Path) -> None:
    versions = layouts(SPECS)["ck10"]
    assert len(versions) == 1
    for path, text in files(versions).items():
        (tmp_path / path).write_text(text, encoding="utf-8", newline="\n")
    source = tmp_path / "program.c"
    source.write_text(PROGRAM.replace("esc11", "ck10").replace("ESC11", "CK10"), encoding="utf-8")
    for flags in ((), ("-DCK10_SELECT=CK10_SELECT_V1",), ("-DCK10_SELECT=CK10_SELECT_LATEST",)):
        compilation = compiled("gcc", source, tmp_path / "program", "-Wno-unused-function", *flags)
        output = subprocess.run([str(compilation)], capture_output=True, text=True, check=True).stdout.split()
        assert output == [versions[0].device.version, versions[0].identity]
