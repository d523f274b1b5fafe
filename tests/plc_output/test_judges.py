"""Independent parsers and schemas judge what is generated for controllers."""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import pytest
import tree_sitter
import tree_sitter_iec61131_3_st
from blark.input import load_file_by_name
from blark.parse import parse_item, parse_source_code
from lxml import etree

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import objects, sources
from loaded import DEVICES, NAMES, REAL, program_of
from shapes import KEYWORDS, Shapes
from st_machine import Machine
from st_syntax import StError, parsed, tokens
from standard_text import DECLARED

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.targets.controllers.adapters.programs import ALTERNATIVE
from fieldspec.targets.controllers.literals import length, string
from fieldspec.targets.plcopen.backend import files as plcopen_files
from fieldspec.targets.st.backend import files as st_files
from fieldspec.targets.twincat.backend import files as twincat_files
from fieldspec.targets.twincat.backend import identifier, path
from layouts import SPECS, TEST_SPECS, newest
from proofs import share

HERE = Path(__file__).parent
TC6_NAMESPACE = "http://www.plcopen.org/xml/tc6_0200"
INTERFACE = ("returnType", "inputVars", "outputVars", "inOutVars", "localVars", "documentation")
"""The parts of a function in the order in which CODESYS exports them."""
PARTS = 4
ALL = [*DEVICES, (TEST_SPECS, "hostile")]
NASTY = "a *) b (* c ]]> d $' e $N f {attribute 'x'} g // h\\ni \\u4f3a \\\" j &amp; <k> ${l} {{m}}"


def hostile() -> DeviceLayout:
    """A device whose texts try to end comments, strings, pragmas and CDATA."""
    text = (TEST_SPECS / "hostile" / "device.yaml").read_text(encoding="utf-8")
    for key in ("label", "doc", "title", "edition"):
        text = text.replace(f'{key}: "', f'{key}: "{NASTY} ')
    text = text.replace("name: codec_error\n", "name: codec_error\n    kind: alarm\n")
    text = text.replace("{value: 0, name: register}", f'{{value: 0, name: register, problem: "{NASTY}"}}')
    assert text.count("]]>") > 10
    files = {
        "hostile/device.yaml": text.encode(),
        "protocols/wire.yaml": (TEST_SPECS / "protocols/wire.yaml").read_bytes(),
    }
    device, findings = read(files).devices["hostile"].at("1")
    assert not has_errors(findings), findings[0].message
    return device_layout(device)


def blark_takes(lines: Sequence[str]) -> None:
    """Asserts that blark parses some lines."""
    result = parse_source_code("\n".join(lines) + "\n")
    assert result.exception is None, (result.exception, "\n".join(lines))


@cache
def statement_forms() -> list[list[str]]:
    """Every form of statement in the functions of the four devices."""
    seen = Shapes()
    programs = (program_of(SPECS, device) for device in REAL)
    functions = (item for program in programs for item in program.items if item.kind == "function")
    return [some for item in functions for some in seen.statements(item.implementation)]


@pytest.mark.proof(1)
@pytest.mark.parametrize("part", range(PARTS))
def test_blark_parses_every_form_of_statement(part: int) -> None:
    value = statement_forms()[part::PARTS]
    for at in range(0, len(value), 4):
        body = [line for some in value[at : at + 4] for line in some]
        blark_takes(["FUNCTION F_Form : BOOL", *body, "END_FUNCTION"])


def test_blark_parses_every_form_of_declaration() -> None:
    seen = Shapes()
    for device in REAL:
        for item in program_of(SPECS, device).items:
            if item.kind == "block":
                continue
            head = item.kind == "function"
            lines = seen.head(item.declaration) if head else seen.new_lines(item.declaration)
            if lines:
                blark_takes([*lines, "RETURN;", "END_FUNCTION"] if head else lines)


@pytest.mark.proof
def test_blark_parses_whole_blocks() -> None:
    blocks = [item for device in REAL for item in program_of(SPECS, device).items if item.kind == "block"]
    for item in share(blocks[:6], 2):
        blark_takes(item.lines)


def test_blark_parses_whole_functions_and_what_hostile_labels_are_in() -> None:
    program = program_of(SPECS, "esc11")
    for item in [item for item in program.items if "PointMode" in item.name or "Grip" in item.name][:8]:
        blark_takes(item.lines)
    (text,) = (text for name, text in st_files([hostile()]).items() if name.endswith(".st"))
    assert "]]>" in text
    for piece in re.split(r"\n\n(?=// ==|// GVL)", text)[1:3]:
        for kind in re.findall(r"(?ms)^\{attribute.*?^END_TYPE$", piece)[:6]:
            blark_takes(kind.splitlines())


@pytest.mark.parametrize(("root", "device"), ALL, ids=[*NAMES, "hostile"])
def test_tree_sitter_parses_every_function_and_struct(root: Path, device: str) -> None:
    parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_iec61131_3_st.language()))
    for item in program_of(root, device).items:
        # Its grammar has neither pragmas, nor enums with a base type after them, nor global constants by themselves.
        lines = [line for line in item.lines if not line.startswith("{")]
        if item.kind in ("function", "block") or "STRUCT" in lines:
            tree = parser.parse("\n".join(lines).encode())
            assert not tree.root_node.has_error, item.name


@pytest.mark.proof(3)
@pytest.mark.parametrize(("root", "device"), ALL, ids=[*NAMES, "hostile"])
def test_everything_that_is_named_is_declared_once_and_every_value_fits_its_type(root: Path, device: str) -> None:
    (text,) = (text for name, text in st_files([newest(root, device)]).items() if name.endswith(".st"))
    Machine(parsed(text))
    names = {token.text.lower() for token in tokens(text) if token.kind == "name"}
    assert not {name for name in names if "__" in name or name.endswith("_")}


@pytest.mark.parametrize("text", ["it's $5", "$", "'", "a\nb\tc", "\"'$N'\"", "溫度 °C", "🤖 $'"])
def test_texts_of_codes_hold_every_character(text: str) -> None:
    wide = not text.isascii()
    kind = f"{'WSTRING' if wide else 'STRING'}({length(text, wide)})"
    lines = ["VAR_GLOBAL CONSTANT", f"    TEXT : {kind} := {string(text, wide)};", "END_VAR"]
    blark_takes(lines)
    unit = parsed("\n".join(lines))
    Machine(unit)
    assert literal_text(unit.globals[0][2][1]) == text


def literal_text(literal: str) -> str:
    """The text that a literal stands for."""
    digits = 4 if literal[0] == '"' else 2
    form = re.compile(rf"\$([0-9A-F]{{{digits}}})|\$(.)|([^$])", re.DOTALL)
    return "".join(chr(int(m[1], 16)) if m[1] else m[2] or m[3] for m in form.finditer(literal[1:-1]))


def test_hostile_labels_stay_within_comments_and_texts() -> None:
    layout = hostile()
    (text,) = (text for name, text in st_files([layout]).items() if name.endswith(".st"))
    hostile_text = newest(TEST_SPECS, "hostile")
    (other,) = (text for name, text in st_files([hostile_text]).items() if name.endswith(".st"))
    assert list(parsed(text).functions) == list(parsed(other).functions)
    Machine(parsed(text))
    for line in text.splitlines():
        assert line.isprintable(), line


@pytest.mark.proof(3)
@pytest.mark.parametrize("name", ["plain", "hostile", *REAL])
def test_plcopen_xml_fits_its_schema_and_holds_what_the_text_holds(name: str) -> None:
    layout = (
        hostile() if name == "hostile" else newest(TEST_SPECS, "widget") if name == "plain" else newest(SPECS, name)
    )
    schema = etree.XMLSchema(etree.parse(str(HERE / "tc6_xml_v201.xsd")))
    texts = {path: text for path, text in plcopen_files([layout]).items() if path.endswith(".xml")}
    text = texts[min(texts, key=len)]
    own = [item for item in sources("codesys", layout) if item.name != ALTERNATIVE]
    document = etree.fromstring(text.encode())
    # The public schema is that of 2.01, which calls its names otherwise; CODESYS exports 2.00.
    renamed = etree.fromstring(text.replace(TC6_NAMESPACE, f"{TC6_NAMESPACE[:-4]}0201").encode())
    assert schema.validate(renamed), schema.error_log.last_error
    spaces = {"p": TC6_NAMESPACE, "x": "http://www.w3.org/1999/xhtml"}
    (unpacked_text,) = (text for path, text in st_files([layout]).items() if path.endswith(".st"))
    unit = parsed(unpacked_text)
    names = [item.lower() for item in document.xpath("//p:pou/@name", namespaces=spaces)]
    added = [name.lower() for item in own for name in objects(item)]
    assert sorted(names) == sorted([*unit.functions, *unit.blocks, *added])
    unpacked_text += "".join(item.text for item in own)
    types = [item.lower() for item in document.xpath("//p:dataType/@name", namespaces=spaces)]
    arrays = [array.lower() for array, _ in DECLARED.findall(unpacked_text)]
    assert sorted(types) == sorted([*unit.enums, *unit.structs, *arrays])
    for pou in document.xpath("//p:pou", namespaces=spaces):
        (body,) = pou.xpath("p:body/p:ST/x:xhtml", namespaces=spaces)
        assert body.text in unpacked_text
        assert not len(body)
        order = [etree.QName(section).localname for section in pou.find("p:interface", spaces)]
        assert [*dict.fromkeys(order)] == [section for section in INTERFACE if section in order], pou.get("name")
    modes = document.xpath("//p:Attribute[@Name='pack_mode']/@Value", namespaces=spaces)
    assert set(modes) == {"1"}
    assert {"creationDateTime": "2000-01-01T00:00:00"}.items() <= dict(document[0].attrib).items()
    for other in texts.values():
        renamed = etree.fromstring(other.replace(TC6_NAMESPACE, f"{TC6_NAMESPACE[:-4]}0201").encode())
        assert schema.validate(renamed), schema.error_log.last_error


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", REAL)
def test_each_object_of_plcopen_xml_is_in_one_folder_by_its_identifier(name: str) -> None:
    for place, text in plcopen_files([newest(SPECS, name)]).items():
        if not place.endswith(".xml"):
            continue
        document = etree.fromstring(text.encode())
        spaces = {"p": TC6_NAMESPACE}
        placed = {
            item.get("Name"): item.get("ObjectId")
            for item in document.xpath("//p:ProjectStructure/p:Folder/p:Object", namespaces=spaces)
        }
        declared = {
            item.get("name"): item.findtext("p:addData/p:data/p:ObjectId", namespaces=spaces)
            for item in document.xpath("//p:dataType | //p:pou | //p:globalVars", namespaces=spaces)
        }
        assert placed == declared
        assert len(set(placed.values())) == len(placed)


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", ["hostile", *REAL])
def test_twincat_files_hold_the_objects_of_the_text(name: str) -> None:
    layout = hostile() if name == "hostile" else newest(SPECS, name)
    (unpacked_text,) = (text for path, text in st_files([layout]).items() if path.endswith(".st"))
    own = {name: text for item in sources("twincat", layout) for name, text in objects(item).items()}
    seen: dict[str, str] = {}
    for place, text in twincat_files([layout]).items():
        if not place.endswith((".TcDUT", ".TcGVL", ".TcPOU")):
            continue
        assert text.startswith("\ufeff<?xml"), place
        root = ElementTree.fromstring(text.encode())
        (element,) = root
        assert place.endswith(f"/{element.attrib['Name']}.Tc{element.tag}")
        assert element.attrib["Id"] not in seen, (place, seen[element.attrib["Id"]])
        seen[element.attrib["Id"]] = place
        declaration = (element.findtext("Declaration") or "").partition("\n")[2]
        implementation = element.findtext("Implementation/ST")
        if element.attrib["Name"] in own:
            assert declaration.partition("VAR")[2] in own[element.attrib["Name"]], place
            assert (implementation or "") in own[element.attrib["Name"]], place
            continue
        end = "END_FUNCTION_BLOCK" if "\nFUNCTION_BLOCK " in f"\n{declaration}" else "END_FUNCTION"
        whole = declaration if implementation is None else f"{declaration}\n{implementation}\n{end}"
        assert f"\n{whole}\n" in unpacked_text, place
    assert len(seen) > 10


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", REAL)
def test_the_project_for_twincat_includes_each_file_and_calls_programs_that_are_there(name: str) -> None:
    outputs = twincat_files([newest(SPECS, name)])
    (project,) = (text for path, text in outputs.items() if path.endswith(".plcproj"))
    names = {"m": "http://schemas.microsoft.com/developer/msbuild/2003"}
    root = ElementTree.fromstring(project.lstrip("\ufeff").encode())
    included = [item.attrib["Include"].replace("\\", "/") for item in root.iterfind(".//m:Compile", names)]
    files = [path.partition("/")[2] for path in outputs if path.endswith((".TcDUT", ".TcGVL", ".TcPOU", ".TcTTO"))]
    assert sorted(included) == sorted(files)
    tasks = [text for path, text in outputs.items() if path.endswith(".TcTTO")]
    called = [item for text in tasks for item in ElementTree.fromstring(text.encode()).iterfind(".//PouCall/Name")]
    assert called
    assert [item.text for item in called if f"POUs/{item.text}.TcPOU" not in included] == []


def test_blark_reads_files_of_each_kind(tmp_path: Path) -> None:
    actual = twincat_files([newest(SPECS, "esc11")])
    for ending in ("TcDUT", "TcGVL", "TcPOU"):
        places = sorted((place for place in actual if place.endswith(ending)), key=lambda text: len(actual[text]))
        for place in places[:3]:
            file = tmp_path / Path(place).name
            file.write_text(actual[place], encoding="utf-8")
            items = load_file_by_name(file)
            assert items
            for result in (result for item in items for result in parse_item(item)):
                assert result.exception is None, (place, result.exception)


def test_the_identifier_of_an_object_depends_on_its_name_alone() -> None:
    assert identifier("ST_Gadget_Point") == identifier("st_gadget_point") == "{3f8c914a-e06e-534e-a08d-01253d54ac9f}"
    assert identifier("ST_Gadget_Point") != identifier("ST_Gadget_Points")


@pytest.mark.parametrize(
    ("wrong", "text"),
    [
        ("FUNCTION f : INT f := g; END_FUNCTION", "declared nowhere"),
        ("FUNCTION f : st f := 1; END_FUNCTION", "declared nowhere"),
        ("FUNCTION f : INT VAR a : INT; A : INT; END_VAR END_FUNCTION", "declared twice"),
        ("FUNCTION f : USINT f := 256; END_FUNCTION", "not in usint"),
        ("FUNCTION f : WORD f := WORD#16#1 + WORD#16#1; END_FUNCTION", "word + word"),
        ("FUNCTION f : INT VAR a : UINT; END_VAR f := a; END_FUNCTION", "uint where int"),
        ("FUNCTION f : REAL VAR a : DWORD; END_VAR f := DWORD_TO_REAL(a); END_FUNCTION", "different things"),
        ("TYPE e : (a := 0, b := 300) USINT; END_TYPE", "does not hold"),
        ("TYPE e : (a := 0, A := 1) USINT; END_TYPE", "there twice"),
        ("VAR_GLOBAL CONSTANT a : SINT := 128; END_VAR", "does not hold"),
        ("VAR_GLOBAL CONSTANT a : STRING(2) := 'abc'; END_VAR", "not a valid string of 2"),
        ("TYPE s : STRUCT a : t; END_STRUCT; END_TYPE", "declared nowhere"),
    ],
)
def test_what_a_parser_takes_and_means_nothing_is_refused_by_the_machine(wrong: str, text: str) -> None:
    with pytest.raises(StError, match=re.escape(text)):
        Machine(parsed(wrong))


def test_words_that_forms_keep_are_no_names_of_what_is_generated() -> None:
    for root, device in DEVICES:
        for item in program_of(root, device).items:
            assert item.name.lower() not in KEYWORDS
            assert path(item).endswith((f"{item.name}.TcDUT", f"{item.name}.TcGVL", f"{item.name}.TcPOU"))
