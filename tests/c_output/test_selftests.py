"""The C headers, judged by compilers and by the self-tests that are generated with them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiling import COMPILERS, compiled

from fieldspec.backends.c.backend import files
from laid_out import MADE_UP, SPECS, layouts

VERSIONS = [versions for root in (SPECS, MADE_UP) for versions in layouts(root).values()]
TEXTS = {path: text for versions in VERSIONS for path, text in files(versions).items()}
HEADERS = sorted(path for path in TEXTS if path.endswith(".h"))


def written(folder: Path, header: str) -> Path:
    """The self-test of a header, with the header beside it."""
    source = header.replace(".h", "_selftest.c")
    for path in (header, source):
        (folder / path).write_text(TEXTS[path], encoding="utf-8", newline="\n")
    return folder / source


@pytest.mark.parametrize(
    ("header", "compiler"),
    [
        (header, compiler)
        for header in HEADERS
        for compiler in COMPILERS
        if compiler != "sanitized" or "before" not in header
    ],
)
def test_a_header_compiles_without_a_warning_and_passes_its_self_test(
    header: str, compiler: str, tmp_path: Path
) -> None:
    program = compiled(compiler, written(tmp_path, header), tmp_path / "selftest")
    result = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout
    assert result.stdout.endswith(" passed, 0 failed\n")


def test_a_self_test_fails_when_a_field_lies_elsewhere(tmp_path: Path) -> None:
    source = written(tmp_path, "tc100_v2_0.h")
    header = tmp_path / "tc100_v2_0.h"
    text = header.read_text("utf-8")
    wrong = text.replace("tc100_store_u16_be(out + 6, ", "tc100_store_u16_be(out + 8, ", 1)
    assert wrong != text
    header.write_text(wrong, encoding="utf-8")
    program = compiled("gcc", source, tmp_path / "selftest")
    assert subprocess.run([str(program)], capture_output=True, check=False).returncode == 1


def test_two_versions_of_a_device_cannot_be_included_together(tmp_path: Path) -> None:
    for header in ("tc100_v2_0.h", "tc100_before_2_0.h"):
        (tmp_path / header).write_text(TEXTS[header], encoding="utf-8")
    source = tmp_path / "both.c"
    source.write_text('#include "tc100_v2_0.h"\n#include "tc100_before_2_0.h"\nint main(void) { return 0; }\n')
    with pytest.raises(AssertionError, match="another version of this device"):
        compiled("gcc", source, tmp_path / "both")


def test_the_wide_table_gives_the_same_check(tmp_path: Path) -> None:
    source = written(tmp_path, "tc100_v2_0.h")
    program = compiled("gcc", source, tmp_path / "selftest", "-DTC100_WIDE_CRC_TABLE")
    assert subprocess.run([str(program)], capture_output=True, check=False).returncode == 0
