"""The translation of Python to JavaScript: equal results in both languages, and an error for all else."""

from __future__ import annotations

import ast
import json
import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.targets.explainer import RUNTIME, SHARED, module_text
from fieldspec.targets.explainer.translation.expressions import Expressions
from fieldspec.targets.explainer.translation.names import Names, Untranslatable
from fieldspec.targets.explainer.translation.statements import Statements

FUNCTIONS = """
def bounds(low: int, number: int, high: int) -> bool:
    return low <= number < high

def quotient(number: int, size: int) -> int:
    return -(-number // size) + number // size

def pieces(data: bytes) -> list[str]:
    return [data[:2].hex(" ").upper(), data[-2:].hex(), (data + b"\\x07")[3:].hex(), f"0x{data[0]:04X}"]

def grouped(pairs: list[list[str]]) -> list[list[str]]:
    result: dict[tuple[str, str], list[str]] = {}
    for first, second, name in pairs:
        result.setdefault((first, second), []).append(name)
    return [[first, second, *names] for (first, second), names in result.items() if second not in first]

def ordered(names: list[str]) -> list[str]:
    return sorted(names, key=lambda name: (len(name), name == "b", name))

def count_down(number: int) -> Iterator[int]:
    while number > 0:
        yield number
        number = number - 2
    if not number:
        yield from (own * own for own in range(3) if own)

def first_word(text: str) -> str:
    match = re.search(r"(?i)(?P<word>[a-z]\\w*)\\s*$", text)
    if match is None:
        return "none"
    word = match["word"] or ""
    return word.lower()

def hexadecimal(text: str) -> list[int]:
    try:
        data = bytes.fromhex(text)
    except ValueError:
        return [-1]
    return list(data)

@dataclass(frozen=True)
class Point:
    x: int
    y: int = 2

    @property
    def text(self) -> str:
        return f"{self.x}|{self.y}"

def moved(x: int) -> list[str]:
    point = Point(x)
    return [point.text, replace(point, y=x + 1).text, replace(point).text if point.x else ""]

def either(names: list[str], other: list[str]) -> list[str]:
    total = names or other
    last = total[-1] if total else ""
    return [last, *(name for name in total if name and name != last)]
"""

CALLS = [
    ("bounds", 1, 1, 4),
    ("bounds", 1, 4, 4),
    ("quotient", 7, 2),
    ("quotient", -7, 2),
    ("grouped", [["a", "b", "c"], ["a", "b", "d"], ["ab", "b", "e"], ["b", "a", "f"]]),
    ("ordered", ["b", "ccc", "a", "aaa", "c"]),
    ("first_word", "12 Größe "),
    ("first_word", "12 -"),
    ("hexadecimal", "0A ff10"),
    ("hexadecimal", "0 Aff"),
    ("moved", 0),
    ("moved", 5),
    ("either", [], ["x", "y", "", "z"]),
    ("either", ["k"], ["x"]),
]
REFUSED = {
    "with open('x') as file:\n        pass": "With",
    "return 1 if number else number and text": "`and`",
    "return f(number, text=text)": "places",
    "return [*number][::2]": "Subscript",
    "return f'{number:>8}'": "form of a text",
    "return unknown": "unknown",
    "global f": "Global",
    "number += [1]": "AugAssign",
    "return text.title()": "title",
    "return number @ text": "BinOp",
}


def translated(source: str) -> str:
    tree = ast.parse(source)
    names = Names({"sample": tree})
    spellings = {node.name: node.name for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    statements = Statements(Expressions("sample", names, spellings))
    return "\n".join(line for node in tree.body for line in statements.top(node))


def test_translated_functions_return_what_they_return_in_python(tmp_path: Path) -> None:
    for folder, modules in (("", SHARED), ("explain", RUNTIME)):
        (tmp_path / folder).mkdir(exist_ok=True)
        for name in modules:
            (tmp_path / folder / f"{name}.js").write_text(module_text(name), "utf-8")
    calls = [*CALLS, ("pieces", b"\x01\x02\x03\x04\x05"), ("count_down", 5), ("count_down", 4)]
    arguments = [
        [
            f"Uint8Array.of({', '.join(map(str, own))})" if isinstance(own, bytes) else json.dumps(own)
            for own in call[1:]
        ]
        for call in calls
    ]
    texts = [f"{call[0]}({', '.join(own)})" for call, own in zip(calls, arguments, strict=True)]
    lists = [re.sub(r"^(count_down.*)", r"[...\1]", text) for text in texts]
    program = f'import {{ py }} from "./explain/python.js";\n{translated(FUNCTIONS)}\n'
    program = re.sub(r"\bcountDown\b", "count_down", program)
    program += f"console.log(JSON.stringify([{', '.join(lists)}]));"
    (tmp_path / "sample.mjs").write_text(program, "utf-8")
    (tmp_path / "package.json").write_text('{"type": "module"}')
    result = subprocess.run(
        [require_tool("node"), "sample.mjs"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr
    scope = {"re": re, "dataclass": dataclass, "replace": replace, "islice": islice, "Iterator": Iterator}
    exec(FUNCTIONS, scope)
    expected = [scope[name](*values) for name, *values in calls]  # type: ignore[operator]
    assert json.loads(result.stdout) == [list(own) if isinstance(own, Iterator) else own for own in expected]


@pytest.mark.parametrize("statement", REFUSED)
def test_a_construct_without_a_translation_is_refused_by_its_line(statement: str) -> None:
    with pytest.raises(Untranslatable, match=r"sample\.py:2: ") as refused:
        translated(f"def f(number: int, text: str) -> object:\n    {statement}\n")
    assert REFUSED[statement] in str(refused.value)


def test_translated_modules_call_what_the_module_of_python_has() -> None:
    modules = "".join(map(module_text, RUNTIME))
    own = set(re.findall(r"^  (\w+)(?::|,$)", module_text("python"), re.MULTILINE))
    assert set(re.findall(r"\bpy\.(\w+)", modules)) <= own
