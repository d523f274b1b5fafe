"""A file of which little has changed is read anew only in part, and gives the tree that the whole text gives."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from example_counts import FACTOR
from fieldspec.language.reading import yaml_reader
from fieldspec.language.reading.memory import FileRead, Memory, file_read
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.project import read
from spec_edits import EDITS

ROOT = Path(__file__).resolve().parent
TEXTS = [
    path.read_text("utf-8") for path in sorted((*ROOT.glob("specs/*/*.yaml"), *ROOT.parent.glob("specs/*/*.yaml")))
]
HEAD = """\
device:
  id: d
  name: D
  vendor: V
  manual: {title: M, file: m.txt, sha256: "%s", lines: 9}
links:
  - {name: line, title: A line, transmission: binary, byte_order: big, word_order: big, source: 1 L1,
     request: [{name: body, role: body}], response: [{name: body, role: body}]}
registers:
  - group: all
    rows:
""" % ("0" * 64)
ROWS = [
    f"      - {{at: {number}, name: value_{number}, type: u16, access: rw, source: 1 L1}}\n" for number in range(500)
]


def as_data(node: Node) -> Any:
    """A tree as plain data, with all places."""
    place = (node.file.text, node.start, node.end)
    if isinstance(node, Scalar):
        return place, node.text, node.quoted, node.value, type(node.value)
    if isinstance(node, Sequence):
        return place, [as_data(item) for item in node.items]
    return place, node.keys, [(key, as_data(value)) for key, value in node.values.items()]


def messages(result: FileRead) -> list[tuple[str, str]]:
    return [(finding.code, finding.message) for finding in (*result.unread, *result.findings)]


@pytest.mark.proof(8)
@pytest.mark.parametrize("seed", range(20))
def test_a_revised_tree_is_that_of_the_whole_text(seed: int) -> None:
    choose = random.Random(seed)
    for _ in range(10 * FACTOR):
        text = choose.choice(TEXTS)
        result = file_read("p", text.encode(), None)
        for _ in range(choose.randrange(1, 6)):
            text = choose.choice(EDITS)(text, choose)
            result, anew = file_read("p", text.encode(), result), file_read("p", text.encode(), None)
            assert messages(result) == messages(anew)
            if anew.tree is None:
                break
            assert result.tree is not None
            assert as_data(result.tree) == as_data(anew.tree)


def test_of_a_long_list_only_what_has_changed_is_parsed(monkeypatch: pytest.MonkeyPatch) -> None:
    before = file_read("p", (HEAD + "".join(ROWS)).encode(), None)
    parsed: list[int] = []
    parser = yaml_reader._Parser

    def noted(text: str) -> object:
        parsed.append(len(text))
        return parser(text)

    monkeypatch.setattr(yaml_reader, "_Parser", noted)
    changed = [row.replace("u16", "u32") if number == 250 else row for number, row in enumerate(ROWS)]
    assert file_read("p", (HEAD + "".join(changed)).encode(), before).tree is not None
    assert sum(parsed) <= 3 * len(ROWS[250])


def test_registers_that_have_not_changed_are_the_same_objects() -> None:
    memory = Memory()

    def registers(rows: list[str]) -> dict[str, object]:
        project = read({"d/device.yaml": (HEAD + "".join(rows)).encode()}, memory=memory)
        device, findings = project.devices["d"].at(project.devices["d"].versions()[-1])
        assert not findings
        return {register.name: register for register in device.registers()}

    before = registers(ROWS)
    after = registers([*ROWS[:100], ROWS[100].replace("rw", "ro"), *ROWS[101:]])
    assert [name for name in before if before[name] is not after[name]] == ["value_100"]
    assert isinstance(memory.files["d/device.yaml"].tree, Mapping)
