"""What is generated for compilers of IEC 61131-3 is what all other dialects have, and such a compiler takes it all."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import DEVICES, NAMES, program_of
from test_judges import hostile

from fieldspec.targets.controllers.routines.printer import implementation
from fieldspec.targets.iec.backend import constants, files, source, text
from layouts import newest
from matiec import matiec


@pytest.mark.proof(5)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_functions_have_the_statements_of_the_other_dialects_with_numbers_for_members(root: Path, device: str) -> None:
    other = program_of(root, device)
    source_text = source(newest(root, device))
    members = {
        f"{enum.name}.{member.name}": str(member.value) for enum in other.declared.enums for member in enum.members
    }
    assert [routine.name for routine in source_text.routines] == [routine.name for routine in other.routines]
    for ours, theirs in zip(source_text.routines, other.functions, strict=True):
        lines = [re.sub(r"//.*", "", line) for line in theirs.implementation]
        wanted = re.sub(r"\bE_\w+\.\w+", lambda match: members[match.group()], " ".join(lines))
        text = re.sub(r"\(\*.*?\*\)", "", " ".join(implementation(ours, source_text.spelling)))
        # A name of a member is longer than its number, so that lines break at other places.
        assert "".join(text.split()) == "".join(wanted.split()), ours.name


def translated(content: str, folder: Path) -> None:
    """Asserts that matiec takes a text without a word."""
    (folder / "text.st").write_text(content, "utf-8")
    tool = matiec()
    ran = subprocess.run(
        [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", str(folder), str(folder / "text.st")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (ran.returncode, ran.stderr) == (0, "")


@pytest.mark.proof(2)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_a_program_in_a_configuration_uses_every_constant(root: Path, device: str, tmp_path: Path) -> None:
    source_text = source(newest(root, device))
    all_constants = [
        constant for constant_list in source_text.declared.constants for constant in constant_list.constants
    ]
    external = "\n".join(f"{constant.name} : {constant.type.name};" for constant in all_constants)
    variables = "\n".join(f"v{number} : {constant.type.name};" for number, constant in enumerate(all_constants))
    uses = "\n".join(f"v{number} := {constant.name};" for number, constant in enumerate(all_constants))
    translated(
        f"PROGRAM Main VAR_EXTERNAL CONSTANT {external} END_VAR VAR {variables} END_VAR {uses} END_PROGRAM\n"
        f"CONFIGURATION Plant {constants(source_text)} RESOURCE Controller ON PLC "
        "TASK Cycle(INTERVAL := T#20ms, PRIORITY := 0); PROGRAM Instance WITH Cycle : Main; "
        "END_RESOURCE END_CONFIGURATION\n",
        tmp_path,
    )


def test_hostile_labels_stay_within_comments(tmp_path: Path) -> None:
    for name, content in files([hostile()]).items():
        if not name.endswith("_constants.st"):
            translated(content, tmp_path)
            assert all(line.isprintable() for line in content.splitlines())


def test_arrays_have_one_type_each(tmp_path: Path) -> None:
    for root, device in DEVICES:
        names = re.findall(r"^    (T_\w+) :", text(source(newest(root, device))), re.MULTILINE)
        assert len(names) == len(set(names))
