"""The sources for TIA Portal are in the form that it takes, whatever a spec says, and refused ones are not written."""

from __future__ import annotations

import io
import json
import re
import shutil
import sys
from pathlib import Path

import openpyxl
import pytest

sys.path.insert(0, str(Path(__file__).parent))

from s7_text import blocks, types

from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.records import encoded
from fieldspec.foundation.classes import replace
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import Workbook
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.controllers.declarations import declarations
from fieldspec.targets.controllers.dialects import SIEMENS
from fieldspec.targets.scl.backend import files, refusals
from fieldspec.targets.scl.project import project
from fieldspec.targets.scl.sources import clashes, string
from fieldspec.tools.lists.workbook_writer import packed
from layouts import SPECS, TEST_SPECS, layouts, newest
from shared_results import shared
from spec_files import DEVICE

CASES = Path(__file__).parent.parent / "cases"
RULES = sorted(path.name for path in CASES.glob("plc_*"))
OF_DEVICES = [
    f"plc_{rule}" for rule in ("enums_fit", "frames_supported", "names_distinct", "names_fit", "spaces_supported")
]
"""The rules about a device as a whole. What breaks another one is left out."""
PRINTED = shared(
    "devices_of_scl",
    lambda: {
        name
        for root in (SPECS, TEST_SPECS)
        for name, versions in layouts(root).items()
        if not has_errors(refusals(versions))
    },
)
"""The devices that the output takes."""
LAYOUTS = [
    pytest.param(versions[-1], id=name)
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    if name in PRINTED
]
ELEMENTARY = "BOOL|BYTE|WORD|DWORD|USINT|SINT|UINT|INT|UDINT|DINT|REAL|LREAL"


def sources(layout: DeviceLayout) -> dict[str, str]:
    """The texts of a device by what they are: `types.udt`, `data.db`, `functions.scl`, `layout.csv`."""
    name = stem(layout.device.id, layout.device.version)
    before = f"{name}/{name}_"
    return {path.removeprefix(before): text for path, text in files([layout]).items() if isinstance(text, str)}


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_sources_have_a_byte_order_mark_and_line_ends_of_windows(layout: DeviceLayout) -> None:
    for name, text in sources(layout).items():
        assert text.startswith("\ufeff"), name
        assert text.count("\ufeff") == 1, name
        assert text.endswith("\r\n"), name
        assert set(re.findall(r"\r?\n|\r", text)) == {"\r\n"}, name


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_types_stand_behind_those_that_they_use(layout: DeviceLayout) -> None:
    known: set[str] = set()
    for name, members in types(sources(layout)["types.udt"]).items():
        for member in members:
            inner = re.sub(r"^(ARRAY\[0\.\.\d+\] OF )+", "", member.type)
            if not re.fullmatch(f"{ELEMENTARY}|STRING\\[\\d+\\]", inner):
                assert inner.strip('"') in known, (name, member)
        assert name not in known
        known.add(name)


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_type_that_blocks_and_functions_use_is_declared(layout: DeviceLayout) -> None:
    outputs = sources(layout)
    declared = set(types(outputs["types.udt"]))
    used = {name for text in outputs.values() for name in re.findall(r': (?:ARRAY\[[^]]*\] OF )?"(type\w+)"', text)}
    assert used <= declared
    functions = set(re.findall(r'^FUNCTION "(\w+)"', outputs["functions.scl"], re.M))
    called = set(re.findall(r'"(\w+_\w+)"\(', "".join(outputs.values())))
    assert called <= functions


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_no_text_of_a_spec_leaves_its_comment_or_its_string(layout: DeviceLayout) -> None:
    outputs = sources(layout)
    for line in outputs["types.udt"].removeprefix("\ufeff").split("\r\n"):
        assert re.fullmatch(
            rf'|//.*|(TYPE|END_TYPE) ?("\w+")?|VERSION : 0\.1|   (END_)?STRUCT;?|'
            rf'      ("\w+"|\w+) : (ARRAY\[0\.\.\d+\] OF )*({ELEMENTARY}|"\w+"|STRING\[\d+\]);(   // .*)?',
            line,
        ), line
    for line in outputs.get("data.db", "").removeprefix("\ufeff").split("\r\n"):
        assert re.fullmatch(
            r"|//.*|(BEGIN|NON_RETAIN|END_DATA_BLOCK|VERSION : 0\.1)|DATA_BLOCK \"\w+\"|   (END_)?STRUCT;?|"
            r"\{ S7_Optimized_Access := '(TRUE|FALSE)' \}|      \w+ : [^';]+( := \d+)?;(   // \d+ bytes)?|"
            r"   entries\[\d+\]\.(code := -?\d+|text := '([^'$]|\$\$|\$')*');",
            line,
        ), line


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_regions_close_within_the_branches_that_they_open_in(layout: DeviceLayout) -> None:
    opened: list[str] = []
    for line in sources(layout)["functions.scl"].split("\r\n"):
        word = re.split("[ ;]", line.strip(), maxsplit=1)[0]
        if word in ("REGION", "IF", "CASE", "FOR"):
            opened.append(word)
        elif word in ("END_REGION", "END_IF", "END_CASE", "END_FOR"):
            assert opened.pop() == word.removeprefix("END_")
        elif word == "END_FUNCTION_BLOCK":
            assert opened == []


def test_a_block_that_moves_has_its_parts_in_regions() -> None:
    text = sources(newest(SPECS, "tc100"))["functions.scl"]
    block = text.partition('FUNCTION_BLOCK "Tc100_MoveAbsolute"')[2].partition("END_FUNCTION_BLOCK")[0]
    assert re.findall(r"REGION \w+", block) == ["REGION Timers", "REGION Start", "REGION Steps"]


def test_strings_escape_what_ends_them_and_have_ascii_alone() -> None:
    assert string("5 $ 'off' 85 °C\n") == "'5 $$ $'off$' 85 ?C?'"
    assert string("x" * 300, 254) == "'" + "x" * 254 + "'"


def test_blocks_that_are_laid_over_the_wire_have_standard_access_and_the_others_are_optimized() -> None:
    outputs = blocks(sources(newest(SPECS, "hiwin-e"))["data.db"])
    assert len(outputs) > 10
    for name, body in outputs.items():
        overlaid = 'Image"' in body
        assert f"S7_Optimized_Access := '{'FALSE' if overlaid else 'TRUE'}'" in body, name


def test_the_calls_in_the_comments_of_blocks_are_of_functions_that_are_there() -> None:
    outputs = sources(newest(SPECS, "hiwin-e"))
    assert '"HiwinE_PackTelegram111RequestBytes"(data := "HiwinETelegram111Values".toDevice' in outputs["data.db"]
    assert 'FUNCTION "HiwinE_PackTelegram111RequestBytes" : UINT' in outputs["functions.scl"]


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_workbook_of_constants_is_in_the_form_of_tag_tables(layout: DeviceLayout) -> None:
    name = stem(layout.device.id, layout.device.version)
    workbook = files([layout])[f"{name}/{name}_constants.xlsx"]
    assert isinstance(workbook, Workbook)
    content = packed(workbook)
    assert content == packed(workbook)
    book = openpyxl.load_workbook(io.BytesIO(content))
    assert book.sheetnames == ["PLC Tags", "TagTable Properties", "Constants"]
    heading, *rows = book["Constants"].iter_rows(values_only=True)
    assert heading == ("Name", "Path", "Data Type", "Value", "Comment")
    names = [str(row[0]) for row in rows]
    assert len({name.lower() for name in names}) == len(names)
    assert all(re.fullmatch("[A-Z][A-Z0-9]*(_[A-Z0-9]+)*", name) and len(name) <= 125 for name in names)
    assert {row[1] for row in rows} == {row[0] for row in book["TagTable Properties"].iter_rows(2, values_only=True)}
    bits = {"Byte": 8, "Word": 16, "DWord": 32, "USInt": 8, "UInt": 16, "UDInt": 32, "SInt": 7, "Int": 15, "DInt": 31}
    for name, _, kind, value, _ in rows:
        if kind in ("Real", "LReal"):
            assert re.fullmatch(r"-?\d+\.\d+", str(value)), name
        else:
            assert kind in bits, (name, kind)
            number = int(str(value).removeprefix("16#"), 16 if str(value).startswith("16#") else 10)
            assert -(1 << bits[str(kind)]) <= number < 1 << bits[str(kind)], name


def test_constants_are_those_of_the_device() -> None:
    layout = newest(SPECS, "tc100")
    constants = {
        constant.name: constant
        for constant_list in declarations(layout, SIEMENS).constants
        for constant in constant_list.constants
    }
    for register in layout.registers:
        if not register.register.reserved:
            name = f"TC100_REG_{register.name.upper()}"
            if name in constants:
                assert constants[name].value == register.address
    enum = layout.device.enums["alarm_code"]
    for member in enum.members:
        assert constants[f"TC100_ALARM_CODE_{member.name.upper()}"].value == member.value


def test_numbers_of_64_bits_are_split_in_the_order_of_the_wire() -> None:
    layout = newest(TEST_SPECS, "gadget")
    whole = layout.messages["cycle"].response
    declared = declarations(layout, SIEMENS)
    halves = declared.layout.messages["cycle"].response
    number = 0x0123_4567_89AB_CDEF
    values = {"mode": 0, "actual": 0, "total": number, "balance": -2, "ratio": 1.0, "counters": [0, 0]}
    values["lock"] = {"serial": 0, "turned": 0}
    split = {**values, "total_high": number >> 32, "total_low": number & 0xFFFFFFFF}
    split |= {"balance_high": -1, "balance_low": 0xFFFFFFFE}
    del split["total"], split["balance"]
    assert encoded(halves, split, layout.device) == encoded(whole, values, layout.device)
    addresses = {
        register.name: register.address for register in declared.layout.registers if register.name.startswith("total")
    }
    assert addresses == {"total_low": 0x12, "total_high": 0x14}


@pytest.mark.parametrize("code", OF_DEVICES)
def test_a_refused_device_stops_the_build_and_leaves_what_was_there(
    code: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    specs, out = tmp_path / "specs", tmp_path / "out"
    (specs / "gadget").mkdir(parents=True)
    arguments = ["build", "--specs", str(specs), "--out", str(out), "--to", "scl,vectors"]
    shutil.copy(CASES / code / "passing" / "device.yaml", specs / "gadget")
    assert main(arguments) == 0
    before = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
    assert any(path.suffix == ".udt" for path in before)
    shutil.copy(CASES / code / "failing" / "device.yaml", specs / "gadget")
    capsys.readouterr()
    assert main(arguments) == 1
    assert f"error[{code}]" in capsys.readouterr().out
    after = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
    stale = json.loads(after.pop(out / "manifest.json"))["stale"]
    del before[out / "manifest.json"]
    assert after == before
    assert {out / path for path in stale} == set(before)
    assert main([*arguments[:-1], "vectors"]) == 0


@pytest.mark.parametrize("code", sorted({*RULES} - {*OF_DEVICES}))
def test_a_fact_that_breaks_another_rule_is_left_out_and_named(
    code: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    specs, out = tmp_path / "specs", tmp_path / "out"
    (specs / "gadget").mkdir(parents=True)
    shutil.copy(CASES / code / "failing" / "device.yaml", specs / "gadget")
    arguments = ["build", "--specs", str(specs), "--out", str(out), "--to", "scl,vectors"]
    assert main(arguments) == 0
    assert f"warning[{code}]" in capsys.readouterr().out
    for ending in ("types.udt", "functions.scl"):
        (path,) = (out / "scl").glob(f"*/*_{ending}")
        assert "// Left out:" in path.read_text("utf-8"), ending
    assert main(arguments) == 0
    assert f"warning[{code}]" in capsys.readouterr().out, "a build without changes says it again"


def test_labels_that_end_comments_are_labels(tmp_path: Path) -> None:
    specs = tmp_path / "specs"
    (specs / "gadget").mkdir(parents=True)
    label = "ends (* and *) here } { */ // $' $N"
    text = (
        f'{DEVICE}records:\n  - {{name: point, source: 1 L2, fields: [{{name: speed, type: u16, label: "{label}"}}]}}\n'
    )
    (specs / "gadget" / "device.yaml").write_text(text, encoding="utf-8")
    assert main(["build", "--specs", str(specs), "--out", str(tmp_path / "out"), "--to", "scl"]) == 0
    (path,) = (tmp_path / "out" / "scl").glob("*/*_types.udt")
    content = path.read_bytes().decode("utf-8")
    (member,) = types(content)["typeGadgetPoint"]
    assert member.comment.startswith("ends ( * and * ) here ) ( * / / /")


@pytest.mark.proof(9)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_only_what_the_rules_name_is_refused(layout: DeviceLayout) -> None:
    real = layout.device.id in layouts(SPECS)
    assert not (real and refusals([layout]))
    assert {finding.code for finding in refusals([layout])} <= set(RULES)


def test_two_functions_of_one_name_are_refused() -> None:
    layout = newest(SPECS, "tc100")
    value = project(layout)
    (finding,) = clashes(replace(value, routines=(*value.routines, value.routines[0])))
    assert finding.code == "plc_names_distinct"
    assert value.routines[0].name in finding.message
