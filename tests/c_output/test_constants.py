"""The constants of a device are in a header of their own, which its header includes, and which compiles alone."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled
from headers import newest_texts

from fieldspec.targets.c.backend import files
from layouts import SPECS, layouts

NEWEST = {name: newest_texts()[name] for name in layouts(SPECS)}
STEMS = {name: next(path for path in texts if path.endswith("_constants.h")) for name, texts in NEWEST.items()}


def write_files(folder: Path, texts: dict[str, str]) -> None:
    for path, text in texts.items():
        (folder / path).write_text(text, encoding="utf-8", newline="\n")


@pytest.mark.parametrize("compiler", ["gcc", "clang", "g++", "tcc"])
@pytest.mark.parametrize("device", NEWEST)
def test_constants_compile_alone(device: str, compiler: str, tmp_path: Path) -> None:
    (tmp_path / STEMS[device]).write_text(NEWEST[device][STEMS[device]], encoding="utf-8", newline="\n")
    source = tmp_path / "alone.c"
    source.write_text(
        f'#include "{STEMS[device]}"\n#include "{STEMS[device]}"\nint main(void) {{ return 0; }}\n', "utf-8"
    )
    program = compiled(compiler, source, tmp_path / "alone")
    assert subprocess.run([str(program)], check=False).returncode == 0


@pytest.mark.parametrize("device", NEWEST)
def test_a_constant_of_registers_and_bits_is_stated_once_and_among_the_constants(device: str) -> None:
    text, constants = NEWEST[device][STEMS[device].replace("_constants", "")], NEWEST[device][STEMS[device]]
    named = re.findall(r"^#define (\w+_(?:ADDRESS|WORDS|MASK|SHIFT|MIN|MAX)) ", constants, re.MULTILINE)
    assert named
    assert len(named) == len(set(named))
    assert not [name for name in named if f"#define {name} " in text]


@pytest.mark.parametrize("device", NEWEST)
def test_constants_have_no_function(device: str) -> None:
    assert not re.search(r"^static |^\{", NEWEST[device][STEMS[device]], re.MULTILINE)


def test_constants_of_another_version_are_refused(tmp_path: Path) -> None:
    write_files(tmp_path, files(layouts(SPECS)["tc100"]))
    source = tmp_path / "both.c"
    source.write_text(
        '#include "tc100_before_2_0_constants.h"\n#include "tc100_v2_0.h"\nint main(void) { return 0; }\n', "utf-8"
    )
    with pytest.raises(AssertionError, match="another version of this device is already included"):
        compiled("gcc", source, tmp_path / "both")
