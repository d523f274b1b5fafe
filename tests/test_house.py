"""The compiler keeps its own rules: which module imports which, and what is absent. See docs/architecture.md."""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from compiler_modules import GENERATED, MODULES, PACKAGE, imported, inside, nodes, tree
from fieldspec.targets import BUILT_IN
from proofs import share

ROOT = Path(__file__).parent.parent
ARCHITECTURE = ROOT / "docs" / "architecture.md"

TEXTS = sorted(path for path in PACKAGE.rglob("*") if path.is_file() and path.suffix not in (".pyc", ".json"))
TESTS = sorted((ROOT / "tests").glob("*.py"))

LONGEST_FILE = 400
COMMANDS = tuple(
    f"{inside(path)}/" for path in sorted((PACKAGE / "command").iterdir()) if path.is_dir() and path.name != "rendering"
)
"""The verbs and what they share: the only ones that read and write files, and print."""

# The only places where a library is imported: folders end with a slash.
HOMES = {
    "yaml": ("language/reading/",),
    "jsonschema_rs": ("language/reading/",),
    "jinja2": ("targets/templates.py",),
    "construct": ("codec/reference/",),
    "pyarrow": ("tools/captures/",),
    "openpyxl": ("tools/lists/workbook_reader.py",),
    "xlsxwriter": ("tools/lists/workbook_writer.py",),
    "argparse": ("cli.py", *COMMANDS),
    "rich": COMMANDS,
    "shtab": COMMANDS,
    "os": ("cli.py", *COMMANDS, "tools/carriers/"),
    "shutil": COMMANDS,
    "tempfile": COMMANDS,
    "subprocess": COMMANDS,
    "socket": ("tools/carriers/",),
    "serial": ("tools/carriers/",),
    "websockets": ("tools/carriers/",),
    "can": ("tools/carriers/can_bus.py",),
    "canopen": ("tools/lists/formats/object_dictionary.py",),
    "cantools": ("tools/lists/formats/can_database.py",),
    "logging": (
        "tools/lists/formats/",
        "command/verbs/lsp.py",
    ),  # what a library says of a file is refused or noted there
    "textual": COMMANDS,
    "mcp": COMMANDS,
    "pygls": ("command/editor/",),
    "lsprotocol": ("command/editor/",),
    "platform": (),
    "getpass": (),
    "datetime": ("tools/lists/workbook_writer.py",),  # workbooks have one that is the same in all of them
    # A review records the date of the day, and a simulation runs by a clock.
    "time": (
        *("command/verbs/build.py", "command/audit_inputs/audit_files.py", "tools/simulator/clock.py"),
        "command/builds/freshness.py",  # a time of a file counts once the clock has left it behind
    ),
    "random": ("tools/simulator/faults.py", "command/packages/codec_loading.py"),  # judges have a fixed seed
    "uuid": ("targets/twincat/", "targets/plcopen/"),  # identifiers are computed from names and equal in every build
    "pickle": (),
    "jsonschema": (),
    "dataclasses": ("foundation/classes.py",),
}
TOUCHES_THE_WORLD = {
    "print",
    "open",
    "input",
    "exec",
    "eval",
    "breakpoint",
    "write_text",
    "write_bytes",
    "mkdir",
    "unlink",
}
NOT_THE_WORLD = {
    ("foundation/classes.py", "exec"),  # it writes constructors, from names of attributes alone
    ("tools/lists/workbook_size.py", "open"),  # it opens a part of a workbook that is in memory
}
UNDONE = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
ALGORITHMS = re.compile(r"crc16_modbus|CRC-16/MODBUS")
LIBRARIES = re.compile(r"from canopen\.objectdictionary import|library canopen")
"""Libraries that read files of other programs, which are named after a protocol."""

VENDORS_NAMES = re.compile(
    r"IoDrvModbus|byModbusErrorCode|MODBUS_ERRORS|Modbus_?Request|Tc2_ModbusRTU|ModbusRtuMaster\w*|Modbus_?Master|Modbus_Comm_Load",
    re.I,
)
"""Names of the blocks of vendors that adapters call, and of what is called after them."""
MAKERS = ("hiwin", "toyo", "taiyo", "profidrive")


FOLDERS: dict[str, list[Path]] = {}
for path in MODULES:
    FOLDERS.setdefault(inside(path.parent), []).append(path)
"""The modules by their folder. A test of each module would take longer to run than to pass."""


def named(node: ast.Call) -> str:
    return node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")


def test_paths_that_the_documentation_names_exist() -> None:
    named = re.findall(r"`([\w.]+/[\w./-]*|[\w-]+\.(?:py|md))`", ARCHITECTURE.read_text("utf-8"))
    assert len(named) > 40
    homes = (ROOT, PACKAGE, ROOT / "docs")
    assert [place for place in named if not any((home / place).exists() for home in homes)] == []


@pytest.mark.parametrize("library", HOMES)
def test_a_library_is_imported_only_where_it_belongs(library: str) -> None:
    users = {inside(path) for path in MODULES if library in {name.partition(".")[0] for name in imported(path)}}
    assert {user for user in users if not user.startswith(HOMES[library])} == set()


def test_only_the_command_line_touches_the_world() -> None:
    uses = {
        f"{inside(path)}:{node.lineno}: {named(node)}"
        for path in MODULES
        if not inside(path).startswith(("cli.py", *COMMANDS))
        for node in nodes(path)
        if isinstance(node, ast.Call) and named(node) in TOUCHES_THE_WORLD
        if (inside(path), named(node)) not in NOT_THE_WORLD
    }
    assert uses == set()


def test_lines_are_printed_only_where_they_are_escaped() -> None:
    homes = ("command/console/streams.py", "command/console/terminal.py")
    uses = {
        f"{inside(path)}:{node.lineno}"
        for path in MODULES
        if inside(path) not in homes
        for node in nodes(path)
        if isinstance(node, ast.Call) and named(node) == "print"
        if not isinstance(node.func, ast.Attribute)  # that of a console of `rich`
    }
    assert uses == set()


def test_html_comes_from_templates_which_escape_it() -> None:
    # Pages have too many cells and lines for templates.
    homes = tuple(f"targets/docs/{name}.py" for name in ("html", "markdown"))
    end_tag = re.compile("</(a|body|code|d[dlt]|div|h[1-6]|li|ol|p|script|span|strong|style|svg|table|t[dhr]|ul)>")
    uses = {
        f"{inside(path)}:{node.lineno}"
        for path in MODULES
        if inside(path) not in homes
        for node in nodes(path)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and end_tag.search(node.value)
    }
    assert uses == set()


def test_texts_are_read_and_written_as_utf8() -> None:
    uses = {
        f"{path.name}:{node.lineno}: {named(node)}"
        for path in [*MODULES, *TESTS]
        for node in nodes(path)
        if isinstance(node, ast.Call)
        and named(node) in ("read_text", "write_text")
        and ast.unparse(node.func) != "distribution.read_text"  # it takes the name of a file, and no encoding
        and "utf-8" not in [part.value for part in ast.walk(node) if isinstance(part, ast.Constant)]
    }
    assert uses == set()


def test_no_assertion_is_content_with_one_of_several_things() -> None:
    # Such an assertion hides what the result is: nobody notices that one of the things is wrong, or is always true.
    loose = [
        f"{path.relative_to(ROOT)}:{node.lineno}"
        for path in sorted((ROOT / "tests").rglob("*.py"))
        for node in nodes(path)
        if isinstance(node, ast.Assert) and is_loose(node.test)
    ]
    assert loose == []


CLOCKS = ("monotonic", "perf_counter", "time")


def test_no_test_fails_because_the_machine_is_busy() -> None:
    # What takes too long is shown by the time of a processor, by memory or by counts: see tests/bounded.py.
    bound = []
    for path in sorted({*(ROOT / "tests").rglob("*.py")} - {ROOT / "tests" / "bounded.py"}):
        for node in nodes(path):
            if isinstance(node, ast.Call) and named(node) in ("run", "communicate", "check_output", "check_call"):
                limits = [word.value for word in node.keywords if word.arg == "timeout"]
                numbers = [limit for limit in limits if isinstance(getattr(limit, "value", ""), int | float)]
                bound += [(path.name, node.lineno) for _ in numbers]
            elif isinstance(node, ast.Assert):
                least = [part for part in ast.walk(node.test) if isinstance(part, ast.Lt | ast.LtE)]
                clocks = [part for part in ast.walk(node) if isinstance(part, ast.Call) and named(part) in CLOCKS]
                bound += [(path.name, node.lineno) for _ in clocks if least]
    assert bound == []


def is_loose(test: ast.AST) -> bool:
    """Whether a test is of the form `a or b`, of itself, within `and`, or for all of several things."""
    if isinstance(test, ast.BoolOp):
        return isinstance(test.op, ast.Or) or any(map(is_loose, test.values))
    if isinstance(test, ast.Call) and named(test) == "all":
        return any(isinstance(part, ast.GeneratorExp) and is_loose(part.elt) for part in test.args)
    return False


def test_the_compiler_knows_no_device_and_no_protocol() -> None:
    folders = [path for path in (ROOT / "specs").iterdir() if path.is_dir() and path.name != "protocols"]
    names = (
        {path.name for path in folders} | {path.stem for path in (ROOT / "specs" / "protocols").iterdir()} | {*MAKERS}
    )
    assert len(names) > 6
    names_by_file = {}
    files = [*TEXTS, *PACKAGE.rglob("*.json")]
    assert {part for path in files for part in path.parts} >= BUILT_IN  # the folder of every output, wherever it is
    for path in files:
        text = ALGORITHMS.sub("", f"{inside(path)}\n{path.read_text('utf-8')}")
        text = LIBRARIES.sub("", VENDORS_NAMES.sub("", text)).lower()
        if present := [name for name in names if name in text]:
            names_by_file[inside(path)] = present
    assert names_by_file == {}


def test_files_are_small() -> None:
    long = {}
    tests = [path for path in (ROOT / "tests").rglob("*.py") if "node_modules" not in path.parts]
    for path in [*TEXTS, *tests]:
        lines = len(path.read_text("utf-8").splitlines())
        if lines > LONGEST_FILE:
            long[path.relative_to(ROOT).as_posix()] = lines
    assert long == {}


def documented() -> dict[str, set[str]]:
    """The methods of each class that have docstrings, there or in a class that it extends, by the class."""
    classes = [node for path in MODULES for node in nodes(path) if isinstance(node, ast.ClassDef)]
    bases = {node.name: [base.id for base in node.bases if isinstance(base, ast.Name)] for node in classes}
    methods: dict[str, set[str]] = {node.name: set() for node in classes}
    for node in classes:
        functions = (inner for inner in node.body if isinstance(inner, ast.FunctionDef))
        methods[node.name] |= {inner.name for inner in functions if ast.get_docstring(inner)}
    for _ in range(3):  # the depth of extended classes
        for name, extended in bases.items():
            methods[name] |= {method for base in extended for method in methods.get(base, ())}
    return methods


def public(body: list[ast.stmt], within: str = "") -> Iterator[tuple[str, ast.FunctionDef | ast.ClassDef]]:
    """The public functions and classes of a module, and the public methods of such classes."""
    for node in body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield within + node.name, node
            if isinstance(node, ast.ClassDef):
                yield from public(node.body, f"{node.name}.")


@pytest.mark.parametrize("folder", FOLDERS)
def test_public_names_have_docstrings_but_methods_whose_base_has_them(folder: str) -> None:
    methods = documented()
    for path in FOLDERS[folder]:
        assert ast.get_docstring(tree(path)), inside(path)
        # The docstring of a module documents what the module is named after.
        names = [name for name, node in public(tree(path).body) if not ast.get_docstring(node) and name != path.stem]
        names = [name for name in names if name.rpartition(".")[2] not in methods.get(name.rpartition(".")[0], ())]
        assert names == [], inside(path)


@pytest.mark.parametrize("folder", FOLDERS)
def test_public_functions_say_what_they_raise(folder: str) -> None:
    for path, (name, node) in ((module, own) for module in FOLDERS[folder] for own in public(tree(module).body)):
        if isinstance(node, ast.FunctionDef):
            own = ast.Module(node.body, [])
            caught = {id(inner) for block in ast.walk(own) if isinstance(block, ast.Try) for inner in ast.walk(block)}
            raises = any(isinstance(inner, ast.Raise) and id(inner) not in caught for inner in ast.walk(own))
            if raises:
                assert "aises" in (ast.get_docstring(node) or ""), (inside(path), name)


def test_nothing_is_left_to_do() -> None:
    here = Path(__file__)
    files = [path for path in [*TEXTS, *TESTS, *(ROOT / "docs").glob("*.md")] if path != here]
    assert [path.name for path in files if UNDONE.search(path.read_text("utf-8"))] == []
    raised = {inside(path) for path in MODULES for node in nodes(path) if is_stub(node)}
    assert raised == set()


def is_stub(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and node.id == "NotImplementedError"


def test_generated_code_does_not_import_the_compiler() -> None:
    texts = [path for path in TEXTS if GENERATED in path.parts or path.suffix == ".j2"]
    assert [inside(path) for path in texts if re.search(r"(import|from) fieldspec\b", path.read_text("utf-8"))] == []


BUILD = """
import hashlib, json, pathlib, sys
from fieldspec.targets import OUTPUTS
from fieldspec.language.diagnostics import has_errors
from fieldspec.command.pipeline import checked, layouts, load, outputs
places = [("specs", "protocols/*.yaml"), *(("tests/specs", f"{name}/**/*.yaml") for name in sys.argv[1:])]
paths = [(root, path) for root, pattern in places for path in sorted(pathlib.Path(root).glob(pattern))]
project = load({path.relative_to(root).as_posix(): path.read_bytes() for root, path in paths})
found = [finding.message for finding in checked(project)]
devices = [layouts(spec) for spec in project.devices.values()]
files = {}
for name, output in OUTPUTS.items():
    files |= outputs([versions for versions in devices if not has_errors(output.refusals(versions))], [name])
print(json.dumps([found, {path: hashlib.sha256(content).hexdigest() for path, content in files.items()}]))
"""


def built(seed: str) -> list[dict[str, str]]:
    """The findings and the hashes of all outputs of the made-up devices, in their order."""
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    devices = ["protocols", *share(sorted(path.parent.name for path in ROOT.glob("tests/specs/*/device.yaml")), 8)]
    call = [sys.executable, "-c", BUILD, *devices]
    ran = subprocess.run(call, cwd=ROOT, env=environment, capture_output=True, check=True)
    report: list[dict[str, str]] = json.loads(ran.stdout)
    return report


@pytest.mark.proof
def test_outputs_are_the_same_whatever_the_hashes_of_strings() -> None:
    first, second = built("0"), built("1")
    assert len(first[1]) > 10
    assert [list(part) for part in first] == [list(part) for part in second]
    assert first == second
