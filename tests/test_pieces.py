"""What outputs make of a fact is made again only where something that it depends on has changed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from importlib import import_module
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.observation import observed_layout, read_of_layout
from fieldspec.command import pipeline
from fieldspec.language.reading.memory import Memory
from fieldspec.language.reading.project import read
from fieldspec.targets import pieces
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.pieces import Pieces, piece, using_pieces, version_piece

HEAD = """\
device:
  id: d
  name: D
  vendor: V
  manual: {title: M, file: m.txt, sha256: "%s", lines: 9}
links:
  - {name: line, title: A line, transmission: binary, byte_order: big, word_order: big, source: 1 L1,
     request: [{name: body, role: body}], response: [{name: body, role: body}]}
enums:
  - {name: mode, source: 1 L1, members: [{value: 0, name: off}, {value: 1, name: on}]}
flags:
  - {name: word, type: u16, source: 1 L1, bits: [{bit: 0, name: ready}]}
registers:
  - group: all
    rows:
""" % ("0" * 64)
ROWS = "".join(
    f"      - {{at: {number}, name: value_{number}, type: u16, access: rw, {more}, source: 1 L1}}\n"
    for number, more in enumerate(["range: 0..7"] * 20 + ["enum: mode"] * 3 + ["flags: word"] * 2)
)
MAKERS = {
    "c": ("fieldspec.targets.c.backend", "declare_register"),
    "python": ("fieldspec.targets.python.registers", "register_view"),
}
NUMBER_OF_ROWS = 25


def layouts_of(text: str, memory: Memory | None) -> list[DeviceLayout]:
    project = read({"d/device.yaml": text.encode()}, memory=memory)
    assert not project.findings
    return pipeline.layouts(project.devices["d"])


class Builds:
    """Outputs of a spec that is read and built again and again, and how often each was asked for a register."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.memory, self.pieces = Memory(strict=True), Pieces()
        self.calls: Counter[str] = Counter()
        for output, (module, function) in MAKERS.items():
            self._count(monkeypatch, output, import_module(module), function)

    def _count(self, monkeypatch: pytest.MonkeyPatch, output: str, module: Any, function: str) -> None:
        original: Callable[..., object] = getattr(module, function)

        def noted(*arguments: object) -> object:
            self.calls[output] += 1
            return original(*arguments)

        monkeypatch.setattr(module, function, noted)

    def build(self, text: str, output: str) -> int:
        """Builds an output, which must be that of a build without memory, and says how many registers it made."""
        layouts = layouts_of(text, self.memory)
        self.calls.clear()
        with using_pieces(self.pieces):
            files = pipeline.output(output, layouts)
        calls = self.calls[output]
        assert files == pipeline.output(output, layouts_of(text, None))
        return calls


@pytest.fixture
def builds(monkeypatch: pytest.MonkeyPatch) -> Builds:
    return Builds(monkeypatch)


CHANGES = {
    "a range": ("range: 0..7", "range: 0..9", 1),
    "the address of the last one": ("at: 24", "at: 30", 1),
    "a comment after the links": ("enums:", "# a comment\nenums:", 0),
    "a member of an enum": ("name: on}", "name: running}", 3),
    "a bit": ("name: ready", "name: steady", 2),
}
"""What is changed, and how many registers are made again."""


@pytest.mark.parametrize("output", MAKERS)
@pytest.mark.parametrize("change", CHANGES)
def test_only_what_depends_on_a_change_is_made_again(builds: Builds, output: str, change: str) -> None:
    assert builds.build(HEAD + ROWS, output) == NUMBER_OF_ROWS
    old, new, expected = CHANGES[change]
    assert old in HEAD + ROWS
    assert builds.build((HEAD + ROWS).replace(old, new, 1), output) == expected


@pytest.mark.parametrize("output", MAKERS)
def test_a_name_that_another_fact_takes_is_decided_anew(builds: Builds, output: str) -> None:
    builds.build(HEAD + ROWS, output)
    builds.build((HEAD + ROWS).replace("name: value_3,", "name: value_4_decode,"), output)
    builds.build((HEAD + ROWS).replace("name: value_3,", "name: value4,"), output)


def test_names_that_are_given_to_others_are_not_those_that_were_asked_for() -> None:
    first, second = Naming("d"), Naming("d")
    with first.noting() as asked:
        assert first.macro("register", "speed", "max") == "D_REG_SPEED_MAX"
    second.macro("register", "speed_max")
    assert not second.gives(asked)
    assert Naming("d").gives(asked)


def test_a_piece_is_made_again_for_another_object_that_is_equal() -> None:
    calls: list[int] = []

    def make() -> int:
        calls.append(0)
        return len(calls)

    fact, equal_fact = (1, [2]), (1, [2])
    with using_pieces(Pieces()):
        assert [piece("kind", (fact,), (), make) for _ in range(3)] == [1, 1, 1]
        assert piece("kind", (equal_fact,), (), make) == 2
        assert piece("kind", (fact,), ("word",), make) == 3


def test_the_oldest_pieces_go_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pieces, "MOST", 3)
    facts = [object() for _ in range(5)]
    with using_pieces(Pieces()):
        for number, fact in enumerate(facts):
            piece("kind", (fact,), (), lambda number=number: number)  # type: ignore[misc]
        again = [piece("kind", (fact,), (), lambda: -1) for fact in reversed(facts)]
    assert again == [4, 3, 2, -1, -1]


def link_names(layout: DeviceLayout) -> list[str]:
    return [layout.device.name, *(link.link.title for link in layout.links.values())]


READ = {
    "nothing": ("", "", True),
    "what is not read": ("title: A line,", "title: A line, label: Line,", True),
    "what is read of a link": ("title: A line,", "title: Another,", False),
    "what is read of the device": ("name: D\n", "name: E\n", False),
    "what the layout has": ("range: 0..7", "range: 0..9", False),
}
"""What is changed, and whether the names of links are the same list again."""


@pytest.mark.parametrize("change", READ)
def test_a_version_is_made_again_only_where_something_that_it_has_read_has_changed(change: str) -> None:
    memory, old, new, expected = Memory(strict=True), *READ[change]
    assert old in HEAD + ROWS
    (before,), (after,) = (layouts_of(text, memory) for text in (HEAD + ROWS, (HEAD + ROWS).replace(old, new, 1)))
    with using_pieces(Pieces(remembered=True)):
        first, second = (version_piece("links", layout, (), link_names) for layout in (before, after))
    assert (second is first, second) == (expected, link_names(after))


def test_what_has_read_a_piece_of_a_version_has_read_what_the_piece_has_read() -> None:
    (layout,) = layouts_of(HEAD + ROWS, None)
    with using_pieces(Pieces(remembered=True)):
        for _ in range(2):
            reading = observed_layout(layout)
            version_piece("links", reading, (), link_names)
    assert read_of_layout(reading)["name"] == "D"
