"""Members of structs lie in memory where their fields lie on the wire, and a function asks the compiler whether so."""

from __future__ import annotations

import csv
import io
import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import DEVICES, NAMES, REAL, program_of, proof, words_in
from st_declared import NATURAL, size_of
from standard_text import anonymous, named, without_comments

from external_tools import require_tool
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.structured.layout_table import rows
from fieldspec.targets.controllers.structured.program import Program
from fieldspec.targets.st.backend import files, text
from layouts import SPECS, newest
from matiec import matiec


@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_the_function_that_asks_for_sizes_is_content(root: Path, device: str) -> None:
    machine = proof(root, device).machine
    (name,) = (name for name in machine.unit.functions if name.endswith("sizesareright"))
    assert machine.call(name) == (True,)


def test_the_function_that_asks_for_sizes_finds_gaps_that_the_compiler_fills_up() -> None:
    from st_machine import Machine
    from st_syntax import parsed

    program = program_of(SPECS, "hiwin-e")
    loose = text(program).replace("{attribute 'pack_mode' := '1'}", "{attribute 'pack_mode' := '4'}")
    machine = Machine(parsed(loose), only=program.sizes.name.lower())
    assert machine.call(program.sizes.name) == (False,)
    assert size_of(machine.unit, "st_hiwine_telegram111request")[0] == 28
    assert size_of(machine.unit, "st_hiwine_telegram111request", NATURAL)[0] == 28


def test_telegram_111_has_24_bytes_and_each_member_lies_where_its_field_does() -> None:
    program = program_of(SPECS, "hiwin-e")
    (placed,) = (item for item in program.placed if item.struct.key == "telegram_111_request")
    assert placed.size == 24
    assert [(member.member.name, member.at) for member in placed.members] == [
        ("wControlWord1", 0),
        ("wPositioningControlWord1", 2),
        ("wPositioningControlWord2", 4),
        ("wControlWord2", 6),
        ("uiVelocityOverride", 8),
        ("diMdiTargetPosition", 10),
        ("diMdiVelocity", 14),
        ("uiMdiAcceleration", 18),
        ("uiMdiDeceleration", 20),
        ("abyPadding1", 22),
    ]


def wire_places(program: Program, record: RecordLayout) -> dict[str, tuple[int, int]]:
    """The place and the size of each member of a telegram's struct, by the name of its field."""
    (placed,) = (placed_member for placed_member in program.placed if placed_member.struct.key == record.name)
    names = {
        program.declared.world.names.members[record.name][text]: text
        for text in program.declared.world.names.members[record.name]
    }
    return {
        names[placed_member.member.name]: (placed_member.at, placed_member.size)
        for placed_member in placed.members
        if placed_member.member.name in names
    }


@pytest.mark.parametrize("device", REAL)
def test_the_bytes_at_the_places_in_memory_hold_the_values_of_every_example(device: str) -> None:
    program, prover = program_of(SPECS, device), proof(SPECS, device)
    layout = program.declared.layout
    messages = {message.name: message for message in telegrams(layout)}
    for example in layout.device.examples.values():
        if example.message not in messages:
            continue
        data = messages[example.message].data(example.direction)
        array = words_in(example.frame, "bytes", "big")
        copy = prover.machine.fresh(prover.world.names.structs[data.name].lower())
        status, _ = prover.run(prover.world.routine("unpack", data.name, "bytes"), aBytes=array, stData=copy)
        assert status == "ok"
        for name, (at, size) in wire_places(program, data).items():
            field = data.named(name)
            assert field is not None
            assert (at, size) == (field.offset, field.size), name
            value = copy[prover.world.member(data.name, name).lower()]
            order = "big" if field.order == "big" else "little"
            assert int.from_bytes(example.frame[at : at + size], order) == value % (1 << (8 * size)), (example.id, name)


@pytest.mark.proof(5)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_the_table_of_places_is_whole_and_has_no_gaps(root: Path, device: str) -> None:
    (table,) = (text for name, text in files([newest(root, device)]).items() if name.endswith("_layout.csv"))
    rows = list(csv.DictReader(io.StringIO(table)))
    at: dict[str, int] = {}
    for row in rows:
        assert int(row["at"]) == at.get(row["struct"], 0), row
        at[row["struct"]] = int(row["at"]) + int(row["bytes"])
    assert at == {row["struct"]: int(row["size"]) for row in rows}


def unpacked_types(text: str) -> str:
    """The structs of a text for matiec: without pragmas, with numbers for enums, with names for types of arrays."""
    enums = dict(re.findall(r"TYPE (\w+) :\n\(.*?\n\) (\w+);", text, re.DOTALL))
    anonymous_text = anonymous(without_comments(text))
    structs = re.findall(r"^TYPE \w+ :\nSTRUCT\n.*?^END_TYPE$", anonymous_text, re.DOTALL | re.MULTILINE)
    remaining = [struct for struct in structs if "STRING(" not in struct]
    return named(re.sub(r"\bE_\w+", lambda match: enums[match.group()], "\n".join(remaining)))


@pytest.mark.proof(2)
@pytest.mark.parametrize(("root", "device"), DEVICES, ids=NAMES)
def test_a_compiler_that_packs_structs_places_members_where_the_table_says(
    root: Path, device: str, tmp_path: Path
) -> None:
    program = program_of(root, device)
    # matiec wants something to run beside types.
    function = "FUNCTION F_Nothing : INT VAR_INPUT iOf : INT; END_VAR F_Nothing := iOf; END_FUNCTION"
    (tmp_path / "text.st").write_text(f"{unpacked_types(text(program))}\n{function}\n", "utf-8")
    tool = matiec()
    folders = ["-I", str(tool / "lib"), "-T", str(tmp_path)]
    ran = subprocess.run([str(tool / "iec2c"), *folders, str(tmp_path / "text.st")], capture_output=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, b"")
    checks = []
    for struct, size, member, _, at, total, *_ in rows(program):
        kind, name = struct.upper(), member.upper()
        checks.append(f'_Static_assert(sizeof({kind}) == {size}, "{kind}");')
        checks.append(f'_Static_assert(offsetof({kind}, {name}) == {at}, "{kind}.{name}");')
        checks.append(f'_Static_assert(sizeof((({kind} *)0)->{name}) == {total}, "{kind}.{name}");')
    head = [
        "#include <stddef.h>",
        '#include "iec_std_lib.h"',
        "#pragma pack(push, 1)",
        '#include "POUS.h"',
        "#pragma pack(pop)",
    ]
    (tmp_path / "sizes.c").write_text("\n".join([*head, *checks]) + "\n", "utf-8")
    compiler = [require_tool("gcc"), "-Wall", "-Werror", "-fsyntax-only", "-isystem", str(tool / "lib" / "C")]
    judged = subprocess.run([*compiler, str(tmp_path / "sizes.c")], capture_output=True, text=True, check=False)
    assert (judged.returncode, judged.stderr) == (0, "")
