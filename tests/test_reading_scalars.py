"""Scalars are text until the schema gives them a type; one that does not fit is a finding that points to it."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest
from rich.cells import cell_len

from fieldspec.command.rendering.finding_text import rendered
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, ScalarValue, Sequence
from fieldspec.language.reading.project import read
from fieldspec.language.reading.scalars import typed
from fieldspec.language.reading.yaml_reader import decoded, key_span, parsed
from spec_files import DEVICE, pointed_at, project, unmarked

WRONG = object()
"""The scalar is refused where this kind is wanted."""

PLACES = {
    "integer": ("parameters: [{name: a, rows: [{name: b, number: 1, const: «»}]}]", "wrong_type"),
    "number": ("limits: [{name: a, value: «»}]", "wrong_type"),
    "boolean": ("parameters: [{name: a, rows: [{name: b, number: 1, restart: «»}]}]", "wrong_type"),
    "text": ("limits: [{name: a, doc: «»}]", ""),
    "free": ("examples: [{id: a, link: b, direction: request, frame: '00', values: {x: «»}}]", ""),
    "cell": ("lookups: [{name: a, columns: [{name: b}], rows: [{cells: [«»]}]}]", ""),
    "word": ("parameters: [{name: a, rows: [{name: b, number: 1, access: «»}]}]", "unknown_word"),
}
ALL = ("integer", "number", "boolean", "text", "free", "cell", "word")
W = WRONG
HALF, TENTH = Decimal("0.5"), Decimal("0.10")

# What a scalar is where an integer, a number, a boolean, a text, anything, a cell and a word is wanted.
MEANINGS: dict[str, tuple[object, ...]] = {
    "10": (10, 10, W, "10", 10, 10, W),
    "0": (0, 0, W, "0", 0, 0, W),
    "-5": (-5, -5, W, "-5", -5, -5, W),
    "+5": (5, 5, W, "+5", 5, 5, W),
    "0x10": (16, 16, W, "0x10", 16, 16, W),
    "-0x8000": (-32768, -32768, W, "-0x8000", -32768, -32768, W),
    "0xfFfF": (65535, 65535, W, "0xfFfF", 65535, 65535, W),
    "18446744073709551615": (2**64 - 1, 2**64 - 1, W, str(2**64 - 1), 2**64 - 1, 2**64 - 1, W),
    "0.5": (W, HALF, W, "0.5", HALF, HALF, W),
    "0.10": (W, TENTH, W, "0.10", TENTH, TENTH, W),
    "-0.01": (W, Decimal("-0.01"), W, "-0.01", Decimal("-0.01"), Decimal("-0.01"), W),
    "on": (W, W, W, "on", "on", "on", W),
    "No": (W, W, W, "No", "No", "No", W),
    "y": (W, W, W, "y", "y", "y", W),
    "True": (W, W, W, "True", "True", "True", W),
    "true": (W, W, True, "true", True, "true", W),
    "false": (W, W, False, "false", False, "false", W),
    "010": (W, W, W, "010", "010", "010", W),
    "-01": (W, W, W, "-01", "-01", "-01", W),
    "00.5": (W, W, W, "00.5", "00.5", "00.5", W),
    "12:30": (W, W, W, "12:30", "12:30", "12:30", W),
    "1e3": (W, W, W, "1e3", "1e3", "1e3", W),
    "0b1": (W, W, W, "0b1", "0b1", "0b1", W),
    "0o17": (W, W, W, "0o17", "0o17", "0o17", W),
    "1_000": (W, W, W, "1_000", "1_000", "1_000", W),
    ".5": (W, W, W, ".5", ".5", ".5", W),
    "5.": (W, W, W, "5.", "5.", "5.", W),
    ".inf": (W, W, W, ".inf", ".inf", ".inf", W),
    ".nan": (W, W, W, ".nan", ".nan", ".nan", W),
    "0x": (W, W, W, "0x", "0x", "0x", W),
    "٣": (W, W, W, "٣", "٣", "٣", W),
    "2024-01-01": (W, W, W, "2024-01-01", "2024-01-01", "2024-01-01", W),
    "~": (W, W, W, "~", None, None, W),
    "null": (W, W, W, "null", None, None, W),
    "''": (W, W, W, "", "", "", W),
    '"10"': (W, W, W, "10", "10", "10", W),
    "'0.5'": (W, W, W, "0.5", "0.5", "0.5", W),
    "'true'": (W, W, W, "true", "true", "true", W),
    "'~'": (W, W, W, "~", "~", "~", W),
    "rw": (W, W, W, "rw", "rw", "rw", "rw"),
    "'rw'": (W, W, W, "rw", "rw", "rw", "rw"),
    "1" * 5000: (W, W, W, "1" * 5000, "1" * 5000, "1" * 5000, W),
    "0x" + "1" * 5000: (W, W, W, "0x" + "1" * 5000, "0x" + "1" * 5000, "0x" + "1" * 5000, W),
    "0." + "1" * 5000: (W, W, W, "0." + "1" * 5000, "0." + "1" * 5000, "0." + "1" * 5000, W),
}
CASES = [
    pytest.param(scalar, kind, meant, id=f"{scalar[:24]} as {kind}")
    for scalar, meanings in MEANINGS.items()
    for kind, meant in zip(ALL, meanings, strict=True)
]


def scalars(node: Node) -> list[Scalar]:
    if isinstance(node, Scalar):
        return [node]
    inner = node.items if isinstance(node, Sequence) else node.values.values()
    return [scalar for part in inner for scalar in scalars(part)]


@pytest.mark.parametrize(("scalar", "kind", "meant"), CASES)
def test_the_type_of_a_scalar_depends_on_its_place(scalar: str, kind: str, meant: ScalarValue) -> None:
    text, code = PLACES[kind]
    clean, start, end = unmarked(text.replace("«»", f"«{scalar}»"))
    file, _ = decoded("a.yaml", clean.encode())
    node, slips = parsed(file)
    assert slips == []
    assert node is not None
    result, findings = typed(node)
    if meant is WRONG:
        assert [(finding.code, finding.span.start, finding.span.end) for finding in findings] == [(code, start, end)]
    else:
        assert findings == []
        (value,) = (scalar for scalar in scalars(result) if scalar.start == start)
        assert (value.value, type(value.value)) == (meant, type(meant))


def test_decimals_keep_every_digit() -> None:
    file, _ = decoded("a.yaml", b"limits: [{name: a, value: 0.10000000000000000001}]")
    node, _ = parsed(file)
    assert node is not None
    (_, scalar) = scalars(typed(node)[0])
    assert str(scalar.value) == "0.10000000000000000001"


ROW = "registers: [{{group: a, rows: [{{at: 1, name: b, type: u16, {}}}]}}]\n"

# The code of a finding, a text that has it, and a part of its help.
FINDINGS = {
    "a misspelt key": ("unknown_key", ROW.format("«acess»: rw"), "did you mean `access`?"),
    "a key of other mappings": ("unknown_key", ROW.format("«record»: x"), "`record` is a key of other mappings"),
    "a misspelt section": ("unknown_key", "«registrs»: []\n", "did you mean `registers`?"),
    "a key that is like no other": ("unknown_key", ROW.format("«qqq»: rw"), "`access`, `align`, `allow`"),
    "a key of another place": ("unknown_key", "notes: [{name: a, text: b, «at»: 1}]\n", "it can be `about`"),
    "a misspelt word": (
        "unknown_word",
        "enums: [{name: a, kind: «alram», members: [{value: 1, name: b}]}]\n",
        "did you mean `alarm`?",
    ),
    "a word of no kind": ("unknown_word", ROW.format("access: «readable»"), "`ro`, `rw`, `wo`"),
    "a number in quotes": ("wrong_type", ROW.format('checked: {words: «"1"»}'), "without quotes"),
    "a list for a text": ("wrong_type", ROW.format("doc: «[a]»"), "own words"),
    "a mapping for a number": ("wrong_type", ROW.format("checked: {words: «{a: 1}»}"), "words"),
    "a text for a list": ("wrong_type", "registers: «none»\n", "Registers"),
    "nothing for a list": ("wrong_type", "registers: «~»\n", "Registers"),
    "a scalar in a list of mappings": ("wrong_type", "registers: [«a»]\n", "Registers"),
    "a name with capitals": ("wrong_form", ROW.format("enum: «ServoOn»"), "lower case"),
    "a name of 65 characters": ("wrong_form", ROW.format(f"enum: «{'a' * 65}»"), "lower case"),
    "a source in words": ("wrong_form", ROW.format("source: «8.2 line 5»"), "L1622"),
    "a range with a hyphen": ("wrong_form", ROW.format("range: «0-5»"), "low..high"),
    "a range of words": ("wrong_form", ROW.format("range: «any»"), "low..high"),
    "an address that is too high": ("wrong_value", ROW.replace("at: 1", "at: «0x10000»").format("unit: V"), "address"),
    "a negative address": ("wrong_value", ROW.replace("at: 1", "at: «-1»").format("unit: V"), "address"),
    "a count of one": ("wrong_value", ROW.format("count: «1»"), "consecutive equal registers"),
    "a list that must not be empty": ("wrong_size", "enums: [{name: a, members: «[]»}]\n", "lowest first"),
    "a key that is missing": (
        "missing_key",
        "errata: [«{id: a, fact: b, reason: c, confidence: open, effect: name, source: L1}»]\n",
        "check that fails",
    ),
    "a key that is missing in a block": ("missing_key", "notes:\n  - «name: a»\n    title: b\n", "our own words"),
    "odd digits in a frame": ("wrong_form", "examples: [{id: a, link: b, direction: request, frame: «0»}]\n", "pairs"),
}
WIDE = {
    "plain": ("", ""),
    "after wide characters": ("limits: [{name: wide, label: 伺服ＯＮ, doc: e\u0301}]\n", ""),
    "in a line with wide characters": ("", "label: 伺服ＯＮ, "),
}


@pytest.mark.parametrize(("code", "text", "help"), FINDINGS.values(), ids=FINDINGS)
def test_a_finding_says_what_would_be_right(code: str, text: str, help: str) -> None:
    clean, start, end = unmarked(DEVICE + text)
    (finding,) = read({"gadget/device.yaml": clean.encode()}).findings
    assert (finding.code, pointed_at(finding.span)) == (code, clean[start:end])
    assert finding.span.start == start
    assert help in finding.help


def test_a_long_text_is_not_quoted_whole() -> None:
    (finding,) = project(ROW.format(f"checked: {{words: {'x' * 100_000}}}")).findings
    assert len(finding.message) < 200


@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize(("before", "beside"), WIDE.values(), ids=WIDE)
@pytest.mark.parametrize(("code", "text", "help"), FINDINGS.values(), ids=FINDINGS)
def test_the_caret_is_under_the_culprit(code: str, text: str, help: str, before: str, beside: str, ends: str) -> None:
    text = text.replace("name: b, type", f"name: b, {beside}type")
    clean, start, end = unmarked((DEVICE + before + text).replace("\n", ends))
    findings = read({"gadget/device.yaml": clean.encode()}).findings
    (finding,) = (finding for finding in findings if finding.code == code)
    lines = rendered([finding]).splitlines()
    source, marks = lines[1], lines[2]
    line_start = clean.rfind("\n", 0, start) + 1
    line = clean[line_start:].splitlines()[0]
    assert source.endswith(line)
    assert marks.index("^") == cell_len(source.removesuffix(line) + clean[line_start:start])
    assert marks.count("^") == cell_len(clean[start:end].splitlines()[0])


def test_all_findings_of_all_files_are_reported_in_one_run() -> None:
    findings = project(
        "registrs: []\n", gadget_b="enums: 5\n", gadget_a="a: 1\na: 2\n", protocols_wire="protocol: 1\n"
    ).findings
    assert [(finding.span.file.path, finding.code) for finding in findings] == [
        ("gadget/device.yaml", "unknown_key"),
        ("gadget/a.yaml", "duplicate_key"),
        ("gadget/a.yaml", "unknown_key"),
        ("gadget/b.yaml", "wrong_type"),
        ("protocols/wire.yaml", "wrong_type"),
    ]


def test_a_tree_keeps_keys_of_the_language_in_the_order_of_the_file() -> None:
    file, _ = decoded("a.yaml", Path(__file__).parent.joinpath("specs/widget/device.yaml").read_bytes())
    node, _ = parsed(file)
    assert isinstance(node, Mapping)
    keys = list(node.values)
    result, _ = typed(node)
    assert isinstance(result, Mapping)
    assert list(result.values) == keys == sorted(keys, key=lambda key: key_span(node, key).start)
