"""A list becomes the first file of a device: valid, nothing verified, and nothing of the list lost."""

from __future__ import annotations

import csv
import hashlib
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from command_line import SPECS, TEST_SPECS, CommandLine
from example_counts import examples
from fieldspec.command.pipeline import checked, load
from fieldspec.language.diagnostics import Severity
from fieldspec.tools.lists.assumption import Options
from fieldspec.tools.lists.imported import imported
from fieldspec.tools.lists.listing import listing
from fieldspec.tools.lists.naming import named, snake
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.lists.skeleton import Origin, skeleton
from fieldspec.tools.lists.text_sheet import text_sheet
from spec_files import DEVICE

ORIGIN = Origin("list.csv", "0" * 64, 999)
TABLE = """
| No. | Address | Name            | Words | R/W | Range     | Unit |
|-----|---------|-----------------|-------|-----|-----------|------|
| 1   | 2000H   | Target position | 2     | R/W | -100~100  | mm   |
| 2   | 2002H   | Speed (max.)    | 1     | R/W | 1~100     | %    |
| 3   | 2004H   | 状态            | 1     | R   |           |      |
"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def spec_text(text: str, options: Options) -> str:
    """The text of a spec without a protocol."""
    sheet = text_sheet(text.encode())
    result = imported(listing(sheet, {}, options), sheet, 0)
    return skeleton("gadget", ORIGIN, result.registers, result.refused).text


def rows(text: str) -> list[dict[str, object]]:
    """The registers of a spec that is created from a list; it passes the check, with warnings at most."""
    spec = spec_text(text, Options(base="hex"))
    findings = checked(load({"gadget/device.yaml": spec.encode()}))
    assert [(finding.code, finding.severity) for finding in findings] == [("facts_verified", Severity.WARNING)], (
        findings[0].message
    )
    (group,) = yaml.safe_load(spec)["registers"]
    assert all(isinstance(row["name"], str) for row in group["rows"])
    group_rows: list[dict[str, object]] = group["rows"]
    return group_rows


def test_a_pasted_table_becomes_a_spec_that_passes_with_a_warning(run: CommandLine) -> None:
    path = run.folder / "lifter" / "device.yaml"
    ran = run("import", "-", "--to", str(path), stdin=TABLE.encode())
    assert ran.code == 0
    assert ran.out.partition("lifter/device.yaml: ")[2].splitlines() == [
        "3 registers, addresses read as hex",
        "columns used: address, name, words, access from R/W, unit, range",
        "columns not used: No.",
        "rows: 3 of 3 used (100 %)",
        "assumed: address space: registers (the list does not say it; --space decides)",
        "assumed: types: i32, u16 (the list does not say them of 3 rows; --column type decides)",
        "assumed: order of words: ABCD, the high word first (the list does not say it; --order decides)",
    ]
    assert path.read_text("utf-8").partition("\nregisters:\n")[2] == (
        '  - group: listed\n    section: "1"\n    unverified: true\n    gaps:\n'
        "      - {at: 0x2003, reason: The list leaves them out.}\n    rows:\n"
        "      - {at: 0x2000, name: target_position, type: i32, checked: {words: 2}, access: rw, unit: mm, "
        'range: -100..100, printed_name: "Target position", '
        "inferred: {type: The list does not say it.}, source: L4, unverified: true}\n"
        '      - {at: 0x2002, name: speed, type: u16, checked: {words: 1}, access: rw, unit: "%", range: 1..100, '
        'printed_name: "Speed (max.)", inferred: {type: The list does not say it.}, source: L5, unverified: true}\n'
        '      - {at: 0x2004, name: register_2004, type: u16, checked: {words: 1}, access: ro, printed_name: "状态", '
        "inferred: {type: The list does not say it.}, source: L6, unverified: true}\n"
    )
    ran = run("check")
    assert ran.code == 0
    assert ran.out.endswith("5 warnings\n")
    assert "not compared with the manual: listed, target_position, speed and register_2004 of `registers`" in ran.out


@pytest.mark.parametrize("device", ["ck10", "tc100"])
def test_an_imported_export_does_not_differ_from_its_device(
    device: str, run: CommandLine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "list.xlsx"
    CommandLine(capsys, monkeypatch, SPECS)("export", device, "--to", "xlsx", "--out", str(path))
    assert run("import", str(path), "--to", str(run.folder / "twin" / "device.yaml")).code == 0
    ran = run("compare", "twin", str(path), "--ignore", "name")
    assert ran.code == 0, ran.out
    assert run("build", "twin", "--out", str(tmp_path / "out")).code == 0
    page = (tmp_path / "out" / "docs" / "twin" / "1.html").read_text("utf-8")
    assert "Not compared with the manual yet." in page


def test_a_folder_may_have_any_name_that_a_device_may_have(run: CommandLine) -> None:
    path = run.folder / "my_meter" / "device.yaml"
    assert run("import", "-", "--to", str(path), stdin=TABLE.encode()).code == 0
    assert yaml.safe_load(path.read_text("utf-8"))["device"]["id"] == "my_meter"


def test_the_list_is_the_source_of_every_fact(run: CommandLine) -> None:
    ran = run("import", "-", "--to", "-", stdin=TABLE.encode())
    spec = yaml.safe_load(ran.out)
    manual = spec["device"]["manual"]
    assert manual["sha256"] == hashlib.sha256(TABLE.encode()).hexdigest()
    assert manual["lines"] == 6
    assert [row["source"] for row in spec["registers"][0]["rows"]] == ["L4", "L5", "L6"]
    assert all(row["unverified"] for row in spec["registers"][0]["rows"])


@pytest.mark.parametrize(
    ("heads", "cells", "wanted"),
    [
        ("Type", "FLOAT", {"type": "f32", "checked": {"words": 2}}),
        ("Type", "DINT", {"type": "i32", "checked": {"words": 2}}),
        ("Type,Words", "INT,2", {"type": "i32", "checked": {"words": 2}}),
        ("Type,Words", "string,8", {"type": "text", "length": 16}),
        ("Type,Words", "UINT16,2", {"type": "u32", "notes": ["The list says UINT16, and 2 words."]}),
        ("Type", "Bitfield", {"type": "u16", "notes": ["Type in the list: Bitfield."]}),
        ("Words", "3", {"type": "bytes", "length": 6}),
        ("Min,Max", "-5,5", {"type": "i16", "range": "-5..5"}),
        ("Type,Min,Max", "UINT16,-5,5", {"notes": ["Least value in the list: -5.", "Greatest value in the list: 5."]}),
        ("Range", "0.1~5", {"notes": ["Range in the list: 0.1~5."]}),
        ("Range,Default", "1~5,9", {"range": "1..5", "notes": ["Default in the list: 9."]}),
        ("Default", "0x10", {"default": 16}),
        ("Const", "0x10", {"const": 16, "default": None}),
        ("Range,Constant", "1~5,9", {"range": "1..5", "const": None, "notes": ["Constant in the list: 9."]}),
        ("Unit", "℃", {"unit": "°C"}),
        ("Unit", "furlong", {"notes": ["Unit in the list: furlong."]}),
        ("Access", "sometimes", {"notes": ["Access in the list: sometimes."]}),
        ("Scale", "0.01", {"scale": 0.01}),
        ("Name,Description", "*/ {{ x }},yes", {"label": None, "name": "yes", "printed_name": "*/ {{ x }}"}),
        ("Name", "@x: [y], #z", {"printed_name": "@x: [y]"}),
    ],
)
def test_a_cell_becomes_a_key_or_a_note(heads: str, cells: str, wanted: dict[str, object]) -> None:
    (row,) = rows(f"Address,{heads}\n0x10,{cells}\n")
    assert {key: row.get(key) for key in wanted} == wanted


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Target Position", "target_position"),
        ("TargetPosition2", "target_position_2"),
        ("homing speed [0.1 rpm]", "homing_speed"),
        ("Pn-001: Vitesse à vide", "pn_001_vitesse_a_vide"),
        ("位置", "register_2000"),
        ("伺服ON", "register_2000"),
        ("2nd speed", "second_speed"),
        ("24V supply", "v_supply_24"),
        ("ΣP", "sigma_p"),
        ("Größe", "grosse"),
        ("U", "u"),
        ("", "register_2000"),
        ("***", "register_2000"),
    ],
)
def test_a_name_is_made_of_english_words(text: str, name: str) -> None:
    assert named([text], 0x2000) == name


def test_equal_names_are_told_apart_by_the_address() -> None:
    group_rows = rows("Address,Name\n0x10,Speed\n0x11,Speed\n0x12,speed 0012\n0x13,Speed\n")
    assert [row["name"] for row in group_rows] == ["speed", "speed_0011", "speed_0012", "speed_0013"]


def test_rows_out_of_order_keep_their_order() -> None:
    assert [row["at"] for row in rows("Address,Name\n0x20,a b\n0x10,c d\n")] == [0x20, 0x10]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Address,Words\n0x10,2\n0x11,1\n", "not used: row 3: holds 0x0011, as row 2 does"),
        ("Address\n0x10\n0x10\n", "not used: row 3: holds 0x0010, as row 2 does"),
        ("Address,Space\n0x10,pnu\n0x11,holding\n", "not used: row 2: has the space pnu, which is not one of"),
        ("Address\n0x10\n0x10000\n", "not used: row 3: has the address 65536, which is beyond 65535"),
        ("Address,Name\n0x10,a\ntbd,b\n", "not used: row 3, Address `tbd`: is not an address"),
        ('Address,Name\n0x10,a\n"8,192",b\n', "not used: row 3, Address `8,192`: is written with thousands separators"),
    ],
)
def test_a_row_that_contradicts_another_one_is_refused_by_its_number(text: str, message: str, run: CommandLine) -> None:
    path = run.folder / "lifter" / "device.yaml"
    ran = run("import", "-", "--to", str(path), stdin=text.encode())
    assert (ran.code, ran.err) == (0, "")
    assert message in ran.out
    assert message.removeprefix("not used: ") in path.read_text("utf-8")
    assert run("check").code == 0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Address,Count\n0x10,9999999\n", "has no row that can be a register: row 2: has the address 16"),
        ("Address\n0x10000\n", "has no row that can be a register: row 2: has the address 65536"),
    ],
)
def test_a_list_without_a_row_that_can_be_used_is_refused(text: str, message: str, run: CommandLine) -> None:
    path = run.folder / "lifter" / "device.yaml"
    ran = run("import", "-", "--to", str(path), stdin=text.encode())
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert not path.parent.exists()


def test_an_import_overwrites_nothing(run: CommandLine) -> None:
    path = run.folder / "lifter.yaml"
    path.write_text("mine", "utf-8")
    ran = run("import", "-", "--to", str(path), stdin=TABLE.encode())
    assert ran.code == 2
    assert "already exists" in ran.err
    assert path.read_text("utf-8") == "mine"


@pytest.mark.parametrize(
    ("options", "addresses"),
    [
        ((), [0, 1]),
        (("--base", "decimal"), [40001, 40002]),
        (("--base", "decimal", "--offset", "40000"), [1, 2]),
    ],
)
def test_modbus_references_are_read_as_such_unless_an_option_says_otherwise(
    options: tuple[str, ...], addresses: list[int], run: CommandLine
) -> None:
    ran = run("import", "-", "--to", "-", *options, stdin=b"Address,Name\n40001,a b\n40002,c d\n")
    assert [row["at"] for row in yaml.safe_load(ran.out)["registers"][0]["rows"]] == addresses


CELLS = st.text(alphabet=st.characters(exclude_characters="\r\n\0", exclude_categories=("Cs",)), max_size=12)


@given(cells=st.lists(st.tuples(st.integers(0, 0xFFFE), *[CELLS] * 9), min_size=1, max_size=6))
@examples(60)
def test_any_cells_give_a_spec_that_passes_or_a_refusal(cells: list[tuple[object, ...]]) -> None:
    heads = "Address\tName\tLabel\tType\tWords\tAccess\tUnit\tMin\tMax\tDefault\n"
    lines = ["\t".join(str(cell).replace("\t", " ").replace('"', "'") for cell in row) for row in cells]
    try:
        spec = spec_text(heads + "\n".join(lines), Options(base="decimal"))
    except ListError:
        return
    wrong = [
        finding
        for finding in checked(load({"gadget/device.yaml": spec.encode()}))
        if finding.severity is Severity.ERROR
    ]
    assert [finding.code for finding in wrong if finding.code != "addresses_within_space"] == []


def test_a_text_without_a_word_gives_no_name() -> None:
    assert snake("…") == ""


POWERS = """
| Address | Name   | Words | Type   | R/W | Scale    | Min | Max | Unit |
|---------|--------|-------|--------|-----|----------|-----|-----|------|
| 9C88    | A      | 1     | uint16 | R   | {scale}  |     |     | A    |
| 9C89    | Total  | 2     | uint32 | R   | {scale}  |     |     | Wh   |
| 9C8B    | A_SF   | 1     | int16  | R   |          | {bounds} |      |
"""


@pytest.mark.parametrize("scale", ["A_SF", "10^A_SF", "10 ^ a_sf", "10**A_SF"])
@pytest.mark.parametrize("bounds", [" | ", "-3 | 3"])
def test_a_scale_that_names_another_row_is_read_from_that_register(scale: str, bounds: str) -> None:
    current, total, exponent = rows(POWERS.format(scale=scale, bounds=bounds))
    assert current["scale_by"] == total["scale_by"] == exponent["name"] == "a_sf"
    assert exponent["range"] == ("-10..10" if bounds == " | " else "-3..3")
    assert ("range" in exponent.get("inferred", {})) == (bounds == " | ")  # type: ignore[operator]
    assert "notes" not in current


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("| A_SF   | 1     | int16  | R ", "| A_SF   | 2     | float  | R "),
        ("| A_SF   | 1     | int16  | R ", "| A_SF   | 1     | int16  |   "),
        ("| 9C89    | Total ", "| 9C89    | A_SF  "),
        ("  -3 | 3 ", "  -30 | 3 "),
    ],
)
def test_a_scale_that_names_no_exponent_becomes_a_note(old: str, new: str) -> None:
    text = POWERS.format(scale="A_SF", bounds="-3 | 3").replace("| -3 | 3", "|  -3 | 3").replace(old, new)
    assert new in text
    assert rows(text)[0]["notes"] == ["Scale in the list: A_SF."]


def test_an_exported_list_gives_back_the_exponents_of_its_scales(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "inverter.csv"
    own, run.folder = run.folder, TEST_SPECS
    assert run("export", "inverter", "--out", str(path)).code == 0
    run.folder = own
    names = ("name", "power", "power_sf", "modules.current", "module_current_sf")
    lines = path.read_text("utf-8").splitlines(keepends=True)
    path.write_text("".join(line for line in lines if any(f",{name}," in line for name in names)), "utf-8")
    spec = own / "again" / "device.yaml"
    assert run("import", str(path), "--to", str(spec)).code == 0
    again = yaml.safe_load(spec.read_text("utf-8"))
    facts = [*again["registers"][0]["rows"], *again["records"][-1]["fields"]]
    scaled = {row["name"]: row["scale_by"] for row in facts if "scale_by" in row}
    assert scaled == {"power": "power_sf", "current": "module_current_sf"}


KEYS = """
registers:
  - group: keys
    section: "1"
    rows:
      - {at: 0x0010, name: unlock, type: u16, checked: {words: 1}, access: wo, const: 0xA55A, source: L1}
      - {at: 0x0011, name: speed, type: u16, checked: {words: 1}, access: rw, default: 50, source: L2}
"""


def test_an_exported_list_gives_back_constants_and_defaults_each_as_what_it_is(
    run: CommandLine, tmp_path: Path
) -> None:
    device = run.folder / "gadget" / "device.yaml"
    device.parent.mkdir()
    device.write_text(DEVICE + KEYS, "utf-8")
    path, spec = tmp_path / "gadget.csv", run.folder / "again" / "device.yaml"
    assert run("export", "gadget", "--out", str(path)).code == 0
    cells = {row["name"]: (row["default"], row["const"]) for row in csv.DictReader(path.open(encoding="utf-8"))}
    assert cells == {"unlock": ("", str(0xA55A)), "speed": ("50", "")}
    assert run("import", str(path), "--to", str(spec)).code == 0
    (group,) = yaml.safe_load(spec.read_text("utf-8"))["registers"]
    stated = {row["name"]: (row.get("default"), row.get("const")) for row in group["rows"]}
    assert stated == {"unlock": (None, 0xA55A), "speed": (50, None)}
    assert run("compare", "gadget", str(path)).code == 0


def test_cells_that_are_no_facts_and_bounds_in_counts_are_told(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "list.csv"
    rows = ("Address;Name;Type;Unit;Scale;Min;Max", "1;Speed;INT16;rpm;1,5;;", "2;Heat;INT16;rpm;0.1;-40;125")
    path.write_text("\n".join(rows), "utf-8")
    result = run("import", str(path), "--to", str(run.folder / "drive" / "device.yaml"))
    assert (result.code, result.err) == (0, "")
    assert result.out.splitlines()[-6:] == [
        "rows: 2 of 2 used (100 %)",
        "rows with cells that are only noted: 1; see `notes`",
        "assumed: addresses: decimal (digits without a mark; --base hex decides)",
        "assumed: Scale: quantity = count \u00d7 factor (multiply) (all factors are 1 or less; --gain multiply or "
        "--gain divide decides)",
        "assumed: bounds beside a scale: in counts (nothing shows which; --bounds decides)",
        "assumed: address space: registers (the list does not say it; --space decides)",
    ]
