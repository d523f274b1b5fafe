"""The code that the site offers is right: it runs, it compiles, and its names are those of the outputs."""

from __future__ import annotations

import ast
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest

from bounded import HANGING
from docs_output.usage_rows import code, usages
from external_tools import require_tool
from python_package import NAME, module_of, package

ROOT = Path(__file__).parent.parent.parent
GENERATED = ROOT / "generated"
DEVICES = ["ck10", "esc11", "hiwin-e", "tc100"]
TEST_DEVICES = ["widget", "station", "glider-x", "meter", "mover", "hostile"]


def own(text: str) -> str:
    """Python for the package of the tests, without what needs the answer of a device."""
    blocks = text.replace("fieldspec_devices", NAME).split("\n\n")
    senders = [block.partition("# Send")[0] for block in blocks if "encode_request" in block and "record" not in block]
    return "\n".join([blocks[0], *senders])


@pytest.mark.parametrize("device", [*DEVICES, *TEST_DEVICES])
def test_python_for_the_site_encodes_requests(device: str) -> None:
    package()
    for path, text in code("python", device):
        scope: dict[str, Any] = {}
        exec(own(text), scope)
        assert ("frame" in scope) == ("encode_request" in own(text)), path


@pytest.mark.parametrize("device", [*DEVICES, *TEST_DEVICES])
def test_python_for_the_site_has_the_names_of_the_package(device: str) -> None:
    layout, codes = usages("python", device)
    module = module_of(layout)
    alias = device.replace("-", "_")
    for text in {text for texts in codes.values() for text in texts}:
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == alias:
                assert hasattr(module, node.attr), text
        for name, attribute in re.findall(r"# request is a \w+\.(\w+) with all fields\nrequest\.(\w+)", text):
            assert hasattr(getattr(module, name), attribute)


@pytest.mark.parametrize("output", ["python", "js"])
def test_readable_registers_have_code_and_reserved_ones_have_none(output: str) -> None:
    layout, codes = usages(output, "ck10")
    registers = [register.register for register in layout.registers]
    reserved = {register.place.path for register in registers if register.reserved}
    assert reserved
    assert reserved.isdisjoint(codes)
    readable = {register.place.path for register in registers if "r" in register.access}
    assert readable - reserved <= codes.keys()


@pytest.mark.parametrize("device", ["ck10", "tc100"])
def test_every_message_has_code_that_encodes_its_request(device: str) -> None:
    layout, codes = usages("python", device)
    sent = [message.message for link in layout.links.values() for message in link.messages.values()]
    assert sent
    for message in sent:
        assert any(".encode_request(" in text for text in codes[message.place.path]), message.name


def c_function(number: int, text: str) -> str:
    """A function with some code, and with the variables that its comments mention."""
    lines = [line for line in text.splitlines() if not line.startswith("#include")]
    before = []
    if kind := re.search(r"/\* telegram is a (\w+) with", text):
        before.append(f"{kind[1]} telegram = {{0}};")
    if "length bytes of data" in text:
        before += ["uint8_t data[1000] = {0};", "size_t length = 0;"]
    return "\n".join([f"void usage_{number}(void);", f"void usage_{number}(void)", "{", *before, *lines, "}"])


@pytest.mark.parametrize("device", DEVICES)
def test_c_for_the_site_compiles(device: str, tmp_path: Path) -> None:
    texts = [text for _, text in code("c", device)]
    header = re.findall(r'#include "(.+)"', texts[0])[0]
    functions = "\n".join(c_function(number, text) for number, text in enumerate(texts))
    (tmp_path / "usages.c").write_text(f'#include "{header}"\n{functions}\n', encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"-I{GENERATED / 'c'}", "-Wno-unused"]
    flags += ["-Wno-maybe-uninitialized", "-Wno-missing-field-initializers"]
    result = subprocess.run(
        [require_tool("gcc"), *flags, str(tmp_path / "usages.c")], capture_output=True, text=True, timeout=HANGING
    )
    assert result.returncode == 0, result.stderr


@pytest.mark.parametrize("device", DEVICES)
def test_javascript_for_the_site_encodes_requests(device: str, tmp_path: Path) -> None:
    rows = list(code("js", device))
    (module,) = {line for _, text in rows for line in re.findall(r'from "fieldspec-devices/(.+)"', text)}
    parts = []
    for path, text in rows:
        for block in text.split("\n\n")[1:]:
            part = block.partition("// Send")[0] if "answer" in block else "" if "record" in block else block
            known = "const bytes = new Uint8Array(64), data = new Uint8Array(1000);" if "bytes" in part else ""
            known += "const telegram = {};" if "telegram." in part else ""
            if "decode" not in part and ".encode(telegram)" not in part and "parameter.encode" not in part:
                parts.append(f"attempt({path!r}, () => {{ {known}\n{part}\n}});")
    start = f"import * as device from {str(GENERATED / 'js' / module)!r};\nlet runs = 0;\n"
    start += "function attempt(path, run) {\n"
    start += "  try { run(); runs += 1; } catch (error) { console.log(path, String(error)); }\n}\n"
    (tmp_path / "usages.mjs").write_text(f"{start}{chr(10).join(parts)}\nconsole.log(runs > 0);\n", encoding="utf-8")
    result = subprocess.run(
        [require_tool("node"), str(tmp_path / "usages.mjs")], capture_output=True, text=True, timeout=HANGING
    )
    assert (result.stdout, result.stderr) == ("true\n", "")


@pytest.mark.parametrize("device", DEVICES)
@pytest.mark.parametrize(
    ("output", "files", "names"),
    [
        ("st", "{}_v*.st", r"\b(?:FB|ST|F)_\w+|(?<=\.)[A-Z][A-Z0-9_]+\b|(?<=stData\.)\w+"),
        ("scl", "{}_v*/*.*", r'"([^"]+)"|(?<=#data\.)(\w+)'),
    ],
)
def test_code_for_controllers_has_the_names_of_the_output(output: str, files: str, names: str, device: str) -> None:
    stem = device.replace("-", "_")
    contents = [path for path in (GENERATED / output).glob(files.format(stem)) if path.suffix != ".xlsx"]
    known = set(re.findall(r"\w+", " ".join(path.read_text("utf-8") for path in contents)))
    if output == "scl":
        from openpyxl import load_workbook

        for path in (GENERATED / output).glob(f"{stem}_v*/*_constants.xlsx"):
            for sheet in load_workbook(path, read_only=True):
                known.update(str(row[0]) for row in sheet.iter_rows(values_only=True))
    texts = [text for _, text in code(output, device)]
    assert texts
    for text in texts:
        for match in re.finditer(names, text):
            name = next((group for group in match.groups() if group), match[0])
            assert name in known, text
