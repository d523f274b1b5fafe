"""The fuzz targets find nothing in the headers, and find defects that are put into them."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import STRICT, require_tool
from fuzz import built, command

from external_tools import without
from fieldspec.foundation.names import stem
from fieldspec.targets.c.backend import files
from layouts import SPECS, TEST_SPECS, newest

DEVICES = [*((SPECS, name) for name in ("tc100", "esc11", "hiwin-e", "ck10"))]
DEVICES += [(TEST_SPECS, name) for name in ("compass", "gadget", "glider-x", "widget")]
SECONDS = 1


def clang() -> str:
    """The path of clang; skips the test if clang has no fuzzer."""
    tool = require_tool("clang")
    folder = subprocess.run([tool, "-print-resource-dir"], capture_output=True, text=True, check=True).stdout.strip()
    return (
        tool if list(Path(folder).glob("lib/*/libclang_rt.fuzzer*")) else without("libclang-rt, which has libFuzzer,")
    )


def fuzzed(folder: Path, root: Path, device: str, seconds: int, right: str = "", wrong: str = "") -> str:
    """The last output of a fuzzer; before it runs, a text of its header may be replaced."""
    tool, layout = clang(), newest(root, device)
    name = stem(device, layout.device.version)
    texts = files([layout])
    if right:
        assert right in texts[f"{name}.h"]
        texts[f"{name}.h"] = texts[f"{name}.h"].replace(right, wrong, 1)
    for path, text in texts.items():
        (folder / path).write_text(text, encoding="utf-8", newline="\n")
    program = built(tool, folder, folder / f"{name}_fuzz.c", *([] if right else STRICT))
    call = command(program, seconds, folder / "corpus")
    result = subprocess.run(call, capture_output=True, text=True, check=False, errors="replace")
    assert (result.returncode == 0) == ("SUMMARY" not in result.stderr)
    return result.stderr


@pytest.mark.proof(1)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=[device for _, device in DEVICES])
def test_a_fuzzer_finds_nothing(root: Path, device: str, tmp_path: Path) -> None:
    output = fuzzed(tmp_path, root, device, SECONDS)
    assert "SUMMARY" not in output, output[-3000:]
    assert re.search(r"^Done \d{4,} runs", output, re.MULTILINE)


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("root", "device", "right", "wrong", "expected_text"),
    [
        (SPECS, "tc100", "if (length != 28u)", "if (length > 28u)", "heap-buffer-overflow"),
        (SPECS, "tc100", "if (size < 3u)", "if (size < 1u)", "SUMMARY"),
        (SPECS, "tc100", "tc100_store_u16_be(out + 6, ", "tc100_store_u16_be(out + 8, ", "deadly signal"),
        (SPECS, "esc11", "if (capacity < ", "if (capacity + 1u < ", "SUMMARY"),
        (TEST_SPECS, "glider-x", "if (!(count > ", "if ((count != count) && !(count > ", "outside the range"),
    ],
)
def test_a_fuzzer_finds_what_is_wrong(
    root: Path, device: str, right: str, wrong: str, expected_text: str, tmp_path: Path
) -> None:
    assert expected_text in fuzzed(tmp_path, root, device, 60, right, wrong)


@pytest.mark.proof(8)
@pytest.mark.parametrize("level", ["-O0", "-O1", "-O2", "-O3"])
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("device", ["armband", "compass", "gadget", "widget"])
def test_compilers_warn_of_nothing_in_a_fuzz_target(device: str, compiler: str, level: str, tmp_path: Path) -> None:
    layout = newest(TEST_SPECS, device)
    for path, text in files([layout]).items():
        (tmp_path / path).write_text(text, encoding="utf-8", newline="\n")
    source = tmp_path / f"{stem(device, layout.device.version)}_fuzz.c"
    command = [require_tool(compiler), "-std=c99", level, "-Wall", "-Wextra", "-Werror", "-c", str(source)]
    run = subprocess.run([*command, "-o", str(tmp_path / "target.o")], capture_output=True, text=True, check=False)
    assert run.stderr == ""
