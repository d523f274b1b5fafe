"""The compiler has six rooms: which of them, and which part of a room, imports which. See docs/architecture.md."""

from __future__ import annotations

import re
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from compiler_modules import MODULES, NAMES, PACKAGE, imported, inside

ARCHITECTURE = PACKAGE.parent.parent / "docs" / "architecture.md"
ROOMS = "rooms"
OUTPUTS = "outputs"

# Where tools reach into targets.
REACHING = {
    # Streams are cut into frames by the framers of the generated Python: there is no second framing.
    "tools/simulator/codecs.py": {"fieldspec.targets.python.backend"},
}

# What the modules of targets import of the rooms below theirs.
TARGETS_IMPORT = (
    "fieldspec.foundation",
    "fieldspec.language.changes",
    "fieldspec.language.diagnostics",
    "fieldspec.language.model",
    "fieldspec.codec.explain",
    "fieldspec.codec.layout",
    "fieldspec.codec.program",
)
SHARED = {"controllers", "explainer", "fact_texts", "pieces", "runtime_values", "templates", "usages"}
"""What outputs share: an output imports these and itself."""


def levels(text: str) -> dict[str, int]:
    """The level of each name of `a -> b | c`; those beside each other have the same one."""
    return {name: number for number, level in enumerate(text.split("->")) for name in re.findall(r"\w+", level)}


@cache
def order() -> dict[str, dict[str, int]]:
    """The order of imports as the documentation prints it: the levels of rooms, and of the parts of each room."""
    section = ARCHITECTURE.read_text("utf-8").partition("\n## The order of imports\n")[2].partition("\n## ")[0]
    block = section.partition("```text\n" + ROOMS)[2].partition("```")[0].replace("\n  ", " ")
    lines = (line.partition(":") for line in (ROOMS + block).splitlines())
    return {name: levels(text) for name, _, text in lines}


def place(name: str) -> tuple[str, str]:
    """The room and the part of a module: language and model for `fieldspec.language.model.device`."""
    _, room, part, *_ = [*name.split("."), "", ""]
    return room, OUTPUTS if (PACKAGE / room / part / "backend.py").exists() else part


def ours(path: Path) -> set[str]:
    return {name for name in imported(path) if name.startswith("fieldspec.")}


def is_above(name: str, other: str) -> bool:
    """Whether a module may import another one by the order of rooms and parts."""
    (room, part), (its_room, its_part) = place(name), place(other)
    if room != its_room:
        return order()[ROOMS][its_room] < order()[ROOMS][room]
    # The module of a room itself, and the parts of one output: another test judges these.
    if part in ("", its_part) or its_part == "":
        return True
    return order()[room][its_part] < order()[room][part]


def parts(folder: Path) -> set[str]:
    """The modules and folders of modules in a folder; `outputs` for all outputs."""
    names = {path.relative_to(folder).parts[0].removesuffix(".py") for path in MODULES if folder in path.parents}
    outputs = {name for name in names if (folder / name / "backend.py").exists()}
    return {name for name in names - outputs if not name.startswith("__")} | ({OUTPUTS} if outputs else set())


@pytest.mark.parametrize("room", [ROOMS, "foundation", "language", "codec", "targets", "tools", "command"])
def test_every_part_of_a_room_is_in_the_order_of_imports(room: str) -> None:
    assert set(order()[room]) == parts(PACKAGE if room == ROOMS else PACKAGE / room)


def test_a_module_imports_only_what_stands_above_it() -> None:
    wrong = {
        (inside(path), other)
        for name, path in NAMES.items()
        if "." in name and not path.stem.startswith("__main")
        for other in ours(path)
        if not is_above(name, other)
    }
    assert wrong == {(path, other) for path, names in REACHING.items() for other in names}


def test_no_modules_and_no_folders_import_each_other_in_a_circle() -> None:
    # An import for annotations alone counts: a reader has to know both modules to understand one.
    graph = {name: ours(path) & NAMES.keys() - {name} for name, path in NAMES.items()}
    TopologicalSorter(graph).prepare()
    # In each folder, the modules and folders in it: what is in them further down counts as theirs.
    paths = {name: path.relative_to(PACKAGE).with_suffix("").parts for name, path in NAMES.items()}
    for folder in {parts[:depth] for parts in paths.values() for depth in range(len(parts))}:
        depth = len(folder)
        own = {name: parts[depth] for name, parts in paths.items() if parts[:depth] == folder}
        units: dict[str, set[str]] = {}
        for name, unit in own.items():
            units.setdefault(unit, set()).update(own[other] for other in graph[name] if other in own)
        TopologicalSorter({unit: others - {unit} for unit, others in units.items()}).prepare()


@pytest.mark.parametrize("path", [path for path in MODULES if inside(path).startswith("targets/")], ids=inside)
def test_a_target_imports_what_bytes_mean_and_no_other_output(path: Path) -> None:
    own = path.relative_to(PACKAGE / "targets").parts[0].removesuffix(".py")
    # Vectors are the frames that codecs are compared with.
    allowed = (*TARGETS_IMPORT, "fieldspec.targets", *["fieldspec.codec.reference"] * (own == "vectors"))
    names = ours(path)
    assert {name for name in names if not f"{name}.".startswith(tuple(f"{other}." for other in allowed))} == set()
    others = {place for name in names if name.startswith("fieldspec.targets.") for place in [name.split(".")[2]]}
    assert others <= {own, *SHARED}
