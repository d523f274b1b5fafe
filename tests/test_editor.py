"""An editor that follows the first line of a spec file completes, explains and judges the language."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.language.schema import described, schema
from language_server import LanguageServer
from proofs import share

ROOT = Path(__file__).parent.parent
FOLDERS = ("specs", "tests/specs", "tests/audit")
SPECS = sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.yaml"))
REAL = share([path for path in SPECS if path.is_relative_to(ROOT / "specs")], 8)
PAGES = sorted(path for path in (ROOT / "docs").glob("*.md") if "yaml-language-server: " in path.read_text("utf-8"))
MODELINE = re.compile(r"# yaml-language-server: \$schema=(\S+)\n")
CURSOR = "¦"
PROPERTY = 10
"""The kind of completion for a key."""

# The cursor, the definition whose keys are completed there, and those of them that are already present.
KEYS = {
    "file": (f"{CURSOR}\n", "", ()),
    "device": (f"device:\n  {CURSOR}\n", "device", ()),
    "group": (f"registers:\n  - group: a\n    {CURSOR}\n", "register_group", ("group",)),
    "row": (f"registers:\n  - group: a\n    rows:\n      - {{at: 1, a{CURSOR}}}\n", "register", ("at",)),
    "block_row": (f"registers:\n  - group: a\n    rows:\n      - at: 1\n        {CURSOR}\n", "register", ("at",)),
    "message": (f"messages:\n  - name: stop\n    {CURSOR}\n", "message", ("name",)),
    "field": (f"messages:\n  - name: stop\n    request:\n      - {{name: b, t{CURSOR}}}\n", "field", ("name",)),
    "member": (f"enums:\n  - name: a\n    members:\n      - {{value: 1, n{CURSOR}}}\n", "member", ("value",)),
    "erratum": (f"errata:\n  - id: a\n    {CURSOR}\n", "erratum", ("id",)),
}
ROW = "registers:\n  - group: a\n    rows:\n      - at: 1\n        name: b\n"
VALUES = {
    "access": (f"{ROW}        access: {CURSOR}\n", "access"),
    "type": (f"{ROW}        type: {CURSOR}\n", "type"),
}


@pytest.fixture(scope="module")
def server() -> Iterator[LanguageServer]:
    with LanguageServer([require_tool("yaml-language-server"), "--stdio"], ROOT) as running:
        yield running


@pytest.fixture
def path(request: pytest.FixtureRequest) -> Path:
    """A file of its own for each test, beside the real specs, that is open in the editor and not on disk."""
    return ROOT / "specs" / "unsaved" / f"{re.sub(r'[^a-z0-9]+', '_', request.node.name)}.yaml"


def typed(text: str) -> tuple[str, int, int]:
    """A spec file with its first line, and the line and column of the cursor in it."""
    modeline = MODELINE.match(REAL[0].read_text("utf-8"))
    assert modeline
    before, _, after = (modeline[0] + text).partition(CURSOR)
    return before + after, before.count("\n"), len(before) - before.rfind("\n") - 1


@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.relative_to(ROOT).as_posix())
def test_every_spec_file_names_the_schema(spec: Path) -> None:
    modeline = MODELINE.match(spec.read_text("utf-8"))
    assert modeline
    named = (spec.parent / modeline[1]).resolve()
    assert named == ROOT / "specs" / "fieldspec.schema.json"
    assert named.is_file()


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_spec_file_of_the_documentation_names_the_schema(page: Path) -> None:
    files = re.findall(r"^`(specs/[\w./-]+)`\n\n```yaml\n(.*?)```", page.read_text("utf-8"), re.DOTALL | re.MULTILINE)
    named = {path: MODELINE.match(text) for path, text in files}
    paths = {path: modeline and posixpath.normpath(f"{path}/../{modeline[1]}") for path, modeline in named.items()}
    assert paths == dict.fromkeys(paths, "specs/fieldspec.schema.json")


@pytest.fixture(scope="module")
def started(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Specs that fieldspec has written for users of an installed fieldspec, with those of the protocols."""
    specs = tmp_path_factory.mktemp("project") / "specs"
    specs.mkdir()
    assert main(["new", "device", "pump", "--protocol", "modbus", "--specs", str(specs)]) == 0
    assert main(["new", "device", "valve", "--protocol", "packet", "--specs", str(specs)]) == 0
    device = specs / "valve" / "device.yaml"
    line = "versions:\n  - {line: firmware, builds: true, members: [{id: '1.0', source: 1 L1}]}\n"
    device.write_text(device.read_text("utf-8") + line, "utf-8")
    assert main(["new", "version", "valve", "1.1", "--specs", str(specs)]) == 0
    table = specs.parent / "list.csv"
    table.write_text("address,name\n1,speed\n", "utf-8")
    assert main(["import", str(table), "--to", str(specs / "oven" / "device.yaml")]) == 0
    return specs


NEW = ("pump/device.yaml", "protocols/modbus.yaml", "valve/device.yaml", "valve/versions/1.1.yaml", "oven/device.yaml")


@pytest.mark.parametrize("path", NEW)
def test_an_editor_finds_the_schema_from_every_file_that_fieldspec_writes(
    server: LanguageServer, started: Path, path: str
) -> None:
    file = started / path
    (finding,) = server.opened(file, file.read_text("utf-8") + "acess: rw\n")
    assert "acess" in finding["message"]


@pytest.mark.proof
def test_real_specs_have_no_finding_in_the_editor(server: LanguageServer) -> None:
    findings = {spec.name: server.opened(spec, spec.read_text("utf-8")) for spec in REAL}
    assert {name: diagnostics for name, diagnostics in findings.items() if diagnostics} == {}


@pytest.mark.parametrize(("text", "definition", "expected"), KEYS.values(), ids=KEYS)
def test_keys_are_completed_with_their_descriptions(
    server: LanguageServer, path: Path, text: str, definition: str, expected: tuple[str, ...]
) -> None:
    text, line, column = typed(text)
    server.opened(path, text)
    offered = {
        label: item["documentation"]
        for label, item in server.completions(path, line, column).items()
        if item["kind"] == PROPERTY
    }
    part = schema()["$defs"].get(definition) or schema()["properties"].get(definition) or schema()
    legal = {key: described(inner) for key, inner in part["properties"].items()}
    assert offered == {key: description for key, description in legal.items() if key not in expected}


@pytest.mark.parametrize(("text", "definition"), VALUES.values(), ids=VALUES)
def test_values_are_completed(server: LanguageServer, path: Path, text: str, definition: str) -> None:
    text, line, column = typed(text)
    server.opened(path, text)
    offered = [label.strip('"') for label in server.completions(path, line, column)]
    assert offered == schema()["$defs"][definition]["enum"]


def test_hovering_over_a_key_shows_its_description(server: LanguageServer, path: Path) -> None:
    text, line, column = typed(f"{ROW}        restart{CURSOR}: true\n")
    server.opened(path, text)
    assert schema()["$defs"]["register"]["properties"]["restart"]["description"] in server.hover(path, line, column - 2)


def test_hovering_over_a_shared_key_shows_its_description(server: LanguageServer, path: Path) -> None:
    text, line, column = typed(f"{ROW}        label{CURSOR}: 伺服\n")
    server.opened(path, text)
    assert schema()["$defs"]["fact"]["properties"]["label"]["description"] in server.hover(path, line, column - 2)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("acess: rw", "acess"),
        ("access: readonly", '"ro", "rw", "wo"'),
        ("at: 70000", "65535"),
        ("checked: {words: two}", "integer"),
        ("source: page 5", "pattern"),
    ],
)
def test_a_slip_is_marked_where_it_is(server: LanguageServer, path: Path, line: str, message: str) -> None:
    text, row, _ = typed(f"registers:\n  - group: a\n    rows:\n      - name: b\n        {line}{CURSOR}\n")
    (finding,) = server.opened(path, text)
    assert finding["range"]["start"]["line"] == row
    assert message in finding["message"]
